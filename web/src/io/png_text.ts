/**
 * A text in a PNG file: the iTXt chunk of a keyword (PNG, 3rd edition, §11.3.3.4), in UTF-8 without compression.
 *
 * Cost: linear in the number of chunks and the length of the text. Pixels are neither read nor copied.
 */
import type { C2WarpError } from '../error';
import { say } from '../texts/wording';
import type { PngChunk } from './encoding';
import { latin } from './formats/latin';
import { MAX_PROJECT_BYTES } from './generated/limits';
import { carriedError } from './picture_error';
import { crc32, SIGNATURE } from './png_chunk';
import { readBytes } from './read';

/** Length, name and checksum. */
const AROUND = 12;

/** The chunk that holds a text in a PNG file. */
export function textChunk(keyword: string, text: string): PngChunk {
  // Keyword, separator, no compression with its method, no language, no translated keyword, text.
  return { type: 'iTXt', data: new TextEncoder().encode(`${keyword}\0\0\0\0\0${text}`) };
}

/** The text of a keyword in any file, of which only a PNG is read as a whole. @throws the errors of {@link textIn}. */
export async function textOfFile(file: Blob, keyword: string): Promise<string | null> {
  const start = new DataView(await readBytes(file.slice(0, SIGNATURE.length)));
  return isPng(start) ? textIn(await readBytes(file), keyword) : null;
}

/**
 * The text of a keyword in the bytes of any file; null if there is none.
 *
 * @throws C2WarpError with the code `project` if the chunk is damaged, too long, or compressed.
 */
export function textIn(file: ArrayBuffer, keyword: string): string | null {
  const view = new DataView(file);
  if (!isPng(view)) return null;
  for (let at = SIGNATURE.length; at + AROUND <= view.byteLength; ) {
    const length = view.getUint32(at);
    const end = at + AROUND + length;
    if (end > view.byteLength) return null;
    if (latin(view, at + 4, 4) === 'iTXt' && latin(view, at + 8, keyword.length + 1) === `${keyword}\0`) {
      return textOf(new Uint8Array(file, at + 4, length + 4), view.getUint32(end - 4), keyword.length);
    }
    at = end;
  }
  return null;
}

/** @param named the name and the content of a chunk. */
function textOf(named: Uint8Array, checksum: number, keywordLength: number): string {
  if (named.length > MAX_PROJECT_BYTES) throw carriedError('project', say('errors.carried.tooLong'));
  if (crc32(named) !== checksum) throw damaged();
  const flags = 4 + keywordLength + 1;
  if (named[flags] !== 0) throw carriedError('project', say('errors.carried.compressed'));
  const language = named.indexOf(0, flags + 2);
  const translated = named.indexOf(0, language + 1);
  if (language < 0 || translated < 0) throw damaged();
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(named.subarray(translated + 1));
  } catch {
    throw damaged();
  }
}

const damaged = (): C2WarpError => carriedError('project', say('errors.carried.damaged'));

const isPng = (view: DataView): boolean =>
  SIGNATURE.every((byte, at) => at < view.byteLength && view.getUint8(at) === byte);
