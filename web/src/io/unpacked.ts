/** Drawings that gzip compressed, as in .svgz. */
import { say } from '../texts/wording';
import { signatureOf } from './formats/signature';
import { pictureError } from './picture_error';

/** Bytes that tell whether a file is a drawing. */
const START = 256;

/**
 * Unpacks a drawing; null for any other compressed file, or if the browser cannot unpack it.
 *
 * @param most the most bytes.
 * @throws C2WarpError for a drawing that is damaged or too large.
 */
export async function unpackedDrawing(file: Blob, most: number): Promise<Blob | null> {
  if (typeof DecompressionStream === 'undefined') return null;
  const reader = file.stream().pipeThrough(new DecompressionStream('gzip')).getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  let isDrawing = false;
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (value) parts.push(value);
      length += value?.length ?? 0;
      isDrawing ||= (done || length >= START) && (await startsAsDrawing(parts));
      if (!isDrawing && (done || length >= START)) return null;
      if (length > most) throw pictureError('picture', say('errors.picture.drawingTooLarge'));
      if (done) return new Blob(parts, { type: file.type });
    }
  } catch (cause) {
    if (!(cause instanceof TypeError)) throw cause;
    if (!isDrawing) return null;
    throw pictureError('picture', say('errors.picture.drawingDamaged'), { cause });
  } finally {
    // Ends an unpacking that nobody reads.
    await reader.cancel().catch(() => {});
  }
}

async function startsAsDrawing(parts: readonly Uint8Array<ArrayBuffer>[]): Promise<boolean> {
  const start = await new Blob([...parts]).slice(0, START).arrayBuffer();
  return signatureOf(new DataView(start)).kind === 'drawing';
}
