/** The type of a file by its first bytes. `wasm/cli/src/picture/kind.rs` has the same list. */
import type { Texts } from '../../texts/texts';
import { latin, startsWith } from './latin';

/** Types that are opened wherever the browser can decode them, after a look at their structure. */
export type Kind = 'png' | 'jpeg' | 'webp' | 'gif' | 'avif' | 'drawing' | 'other';

export type KindName = keyof Texts['errors']['picture']['kinds'];

export interface Signature {
  readonly kind: Kind;
  /** The type for people, as a key of the texts; undefined for an unknown one. */
  readonly name?: KindName;
}

const SIGNATURES: readonly (readonly [start: string, name: KindName, kind?: Kind])[] = [
  ['\x89PNG\r\n\x1a\n', 'png', 'png'],
  ['\xff\xd8\xff', 'jpeg', 'jpeg'],
  ['GIF87a', 'gif', 'gif'],
  ['GIF89a', 'gif', 'gif'],
  ['BM', 'bmp'],
  ['\0\0\x01\0', 'icon'],
  ['II*\0', 'tiff'],
  ['MM\0*', 'tiff'],
  ['8BPS', 'photoshop'],
  ['%PDF-', 'pdf'],
  ['%!PS', 'postscript'],
  ['\xff\x0a', 'jpegXl'],
  ['\0\0\0\x0cJXL ', 'jpegXl'],
  ['\0\0\0\x0cjP  ', 'jpeg2000'],
  ['\x1f\x8b\x08', 'compressed'],
];

/** A byte order mark in UTF-8 comes before the text of some drawings. */
const DRAWING = /^(?:ï»¿)?\s*<(?:\?xml|!--|!DOCTYPE svg|svg)/i;

/** Turns UTF-16 into one byte per ASCII character. Returns other text unchanged. */
const narrow = (start: string): string =>
  /^(?:ÿþ|þÿ|\0[<\s]|[<\s]\0)/.test(start) ? start.replace(/^(?:ÿþ|þÿ)/, '').replaceAll('\0', '') : start;

/**
 * Names by brands of ISO base media files (ISO/IEC 14496-12, section 4.3). AVIF files may name brands of HEIC as well.
 */
const BRANDS: readonly (readonly [brands: readonly string[], signature: Signature])[] = [
  [['avif', 'avis'], { kind: 'avif', name: 'avif' }],
  [['heic', 'heix', 'heim', 'heis', 'hevc', 'hevx', 'mif1', 'msf1'], { kind: 'other', name: 'heic' }],
];

export function signatureOf(view: DataView): Signature {
  const start = latin(view, 0, 256);
  const [, name, kind = 'other'] = SIGNATURES.find(([signature]) => start.startsWith(signature)) ?? [];
  if (name) return { kind, name };
  if (start.startsWith('RIFF') && startsWith(view, 'WEBP', 8)) return { kind: 'webp', name: 'webp' };
  if (DRAWING.test(narrow(start))) return { kind: 'drawing', name: 'svg' };
  const brands = brandsOf(view);
  const [, signature] = BRANDS.find(([names]) => names.some((name) => brands.includes(name))) ?? [];
  return signature ?? { kind: 'other' };
}

/** The brands of an ISO base media file; empty for other files. */
export function brandsOf(view: DataView): readonly string[] {
  if (!startsWith(view, 'ftyp', 4)) return [];
  return latin(view, 8, Math.min(view.getUint32(0), 256) - 8).match(/.{4}/gs) ?? [];
}
