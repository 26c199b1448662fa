/** Takes the frames of a film and writes it. */
export interface FilmEncoder {
  /**
   * Adds the next frame, straight RGBA from top to bottom.
   * @throws Refused with a reason for people.
   */
  add(rgba: Uint8Array<ArrayBuffer>): Promise<void>;
  /** Writes the end, after the last frame. */
  finish(): Promise<void>;
  /** Frees its memory; called at the end in any case. */
  dispose(): void;
}
