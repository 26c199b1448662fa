/** A file that takes rows in straight alpha, from top to bottom. */
export interface RowsFile {
  write(rgba: Uint8Array<ArrayBuffer>): Promise<void>;
  finish(): Promise<Blob>;
  abandon(): void;
}
