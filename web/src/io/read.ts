/** Reads files that the person gave: these may be folders, or moved or changed by the time they are read. */

/** A file that cannot be read. The message can be shown to the person. */
export class ReadError extends Error {
  readonly code = 'file';

  constructor(options?: ErrorOptions) {
    super('This cannot be read: it is a folder, or a file that was moved or changed meanwhile.', options);
    this.name = 'ReadError';
  }
}

/** @throws ReadError where the bytes cannot be read. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw new ReadError({ cause });
  }
}
