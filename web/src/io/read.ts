/** Reads files from the user. Such a file can be a folder, or can be moved or changed before it is read. */
import { C2WarpError } from '../error';

const UNREADABLE =
  'The file cannot be read: it is a folder, or it was moved or changed. Choose the file again.';

/** @throws C2WarpError with the code `file` if the bytes cannot be read. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw new C2WarpError('file', UNREADABLE, { cause });
  }
}
