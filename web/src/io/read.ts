/** Reads files from the user. Such a file can be a folder, or can be moved or changed before it is read. */

/** A file cannot be read. The message is for the user. */
export class ReadError extends Error {
  readonly code = 'file';

  constructor(options?: ErrorOptions) {
    super(
      'The file cannot be read: it is a folder, or it was moved or changed. Choose the file again.',
      options,
    );
    this.name = 'ReadError';
  }
}

/** @throws ReadError if the bytes cannot be read. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw new ReadError({ cause });
  }
}
