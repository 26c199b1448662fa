/** Reads files from the user. Such a file can be a folder, or can be moved or changed before it is read. */
import { say } from '../texts/wording';
import { type Signature, signatureOf } from './formats/signature';
import { pictureError } from './picture_error';

/** @throws C2WarpError with the code `file` if the bytes cannot be read. */
export async function readBytes(file: Blob): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw pictureError('file', say('errors.picture.unreadable'), { cause });
  }
}

/** Number of bytes that tell the type of a file. */
const SIGNATURE_BYTES = 256;

/** Detects the type of a file from its first bytes. @throws the error of {@link readBytes}. */
export const readSignature = async (file: Blob): Promise<Signature> =>
  signatureOf(new DataView(await readBytes(file.slice(0, SIGNATURE_BYTES))));
