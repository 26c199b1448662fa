/** Reads files from the user. Such a file can be a folder, or can be moved or changed before it is read. */
import { say } from '../texts/wording';
import { pictureError } from './picture_error';

/** @throws C2WarpError with the code `file` if the bytes cannot be read. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw pictureError('file', say('errors.picture.unreadable'), { cause });
  }
}
