/** Reading what a person gave: a folder can be dropped too, and a file be gone or changed by the time it is read. */

/** A file that cannot be read. The message is fit to be shown. */
export class ReadError extends Error {
  readonly code = 'file';

  constructor(options?: ErrorOptions) {
    super('This cannot be read: it is a folder, or a file that was moved or changed meanwhile.', options);
    this.name = 'ReadError';
  }
}

/** @throws ReadError where the bytes are not to be had. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw new ReadError({ cause });
  }
}
