/**
 * A text in a PNG file: the iTXt chunk of a keyword (PNG, 3rd edition, §11.3.3.4), in UTF-8 without compression.
 *
 * Cost: linear in the number of chunks and the length of the text. Pixels are neither read nor copied.
 */
import { WarpError } from '../error';

const SIGNATURE = 8;
/** Length, name and checksum. */
const AROUND = 12;
/** Of the IHDR chunk, always the first one. */
const HEADER = 13;

/** Longer texts are refused before they are decoded. */
export const MAX_TEXT_BYTES = 100e6;

/** The file with a text behind its header. */
export function withText(png: Blob, keyword: string, text: string): Blob {
  const encoder = new TextEncoder();
  // Keyword, separator, no compression with its method, no language, no translated keyword.
  const content = concatenated(encoder.encode(keyword), Uint8Array.of(0, 0, 0, 0, 0), encoder.encode(text));
  const named = concatenated(encoder.encode('iTXt'), content);
  const chunk = concatenated(bigEndian(content.length), named, bigEndian(crc32(named)));
  const at = SIGNATURE + AROUND + HEADER;
  return new Blob([png.slice(0, at), chunk, png.slice(at)], { type: png.type });
}

/**
 * The text of a keyword in the bytes of any file; null if there is none.
 *
 * @throws WarpError with the code `project` if the chunk is damaged, too long, or compressed.
 */
export function textIn(file: ArrayBuffer, keyword: string): string | null {
  const view = new DataView(file);
  if (!isPng(view)) return null;
  for (let at = SIGNATURE; at + AROUND <= view.byteLength; ) {
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
  if (named.length > MAX_TEXT_BYTES) throw damaged('is too long');
  if (crc32(named) !== checksum) throw damaged('is damaged');
  const flags = 4 + keywordLength + 1;
  if (named[flags] !== 0) throw damaged('is compressed, which is not supported');
  const language = named.indexOf(0, flags + 2);
  const translated = named.indexOf(0, language + 1);
  if (language < 0 || translated < 0) throw damaged('is damaged');
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(named.subarray(translated + 1));
  } catch {
    throw damaged('is damaged');
  }
}

const damaged = (what: string): WarpError => new WarpError('project', `The project in this picture ${what}.`);

const isPng = (view: DataView): boolean => latin(view, 0, SIGNATURE) === '\x89PNG\r\n\x1a\n';

function latin(view: DataView, at: number, length: number): string {
  const end = Math.min(at + length, view.byteLength);
  return at < end ? String.fromCharCode(...new Uint8Array(view.buffer, at, end - at)) : '';
}

function concatenated(...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

const bigEndian = (value: number): Uint8Array =>
  Uint8Array.of(value >>> 24, (value >>> 16) & 255, (value >>> 8) & 255, value & 255);

/** The checksum of a chunk's name and content (PNG, annex D). */
export function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = (TABLE[(crc ^ byte) & 255] ?? 0) ^ (crc >>> 8);
  return ~crc >>> 0;
}

const TABLE = Uint32Array.from({ length: 256 }, (_, index) => {
  let value = index;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});
