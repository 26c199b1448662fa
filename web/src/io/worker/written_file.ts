/** A file that takes pixels in straight alpha, from top to bottom or frame by frame. */
export interface WrittenFile<File> {
  /** @throws Refused with a reason for people. */
  write(rgba: Uint8Array<ArrayBuffer>): Promise<void>;
  /** @throws the errors of {@link write}. */
  finish(): Promise<File>;
  /** Frees its memory, and leaves nothing of an unfinished file behind; called at the end in any case. */
  abandon(): void | Promise<void>;
}
