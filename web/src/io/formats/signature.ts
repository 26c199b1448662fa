/** The type of a file by its first bytes. `wasm/cli/src/picture/kind.rs` has the same list. */
import { latin, startsWith } from './latin';

/** Types that are opened wherever the browser can decode them, after a look at their structure. */
export type Kind = 'png' | 'jpeg' | 'webp' | 'gif' | 'avif' | 'drawing' | 'other';

export interface Signature {
  readonly kind: Kind;
  /** The type for people, with an article; undefined for an unknown one. */
  readonly name?: string;
}

const SIGNATURES: readonly (readonly [start: string, name: string, kind?: Kind])[] = [
  ['\x89PNG\r\n\x1a\n', 'a PNG picture', 'png'],
  ['\xff\xd8\xff', 'a JPEG picture', 'jpeg'],
  ['GIF87a', 'a GIF picture', 'gif'],
  ['GIF89a', 'a GIF picture', 'gif'],
  ['BM', 'a BMP picture'],
  ['\0\0\x01\0', 'an icon'],
  ['II*\0', 'a TIFF picture'],
  ['MM\0*', 'a TIFF picture'],
  ['8BPS', 'a Photoshop document'],
  ['%PDF-', 'a PDF document'],
  ['%!PS', 'a PostScript document'],
  ['\xff\x0a', 'a JPEG XL picture'],
  ['\0\0\0\x0cJXL ', 'a JPEG XL picture'],
  ['\0\0\0\x0cjP  ', 'a JPEG 2000 picture'],
];

/** A byte order mark in UTF-8 comes before the text of some drawings. */
const DRAWING = /^(?:ï»¿)?\s*<(?:\?xml|!--|!DOCTYPE svg|svg)/i;

/** By brands of ISO base media files (ISO/IEC 14496-12, section 4.3). AVIF files may name brands of HEIC as well. */
const BRANDS: readonly (readonly [brands: readonly string[], signature: Signature])[] = [
  [['avif', 'avis'], { kind: 'avif', name: 'an AVIF picture' }],
  [
    ['heic', 'heix', 'heim', 'heis', 'hevc', 'hevx', 'mif1', 'msf1'],
    { kind: 'other', name: 'a HEIC picture' },
  ],
];

export function signatureOf(view: DataView): Signature {
  const start = latin(view, 0, 256);
  const [, name, kind = 'other'] = SIGNATURES.find(([signature]) => start.startsWith(signature)) ?? [];
  if (name) return { kind, name };
  if (start.startsWith('RIFF') && startsWith(view, 'WEBP', 8))
    return { kind: 'webp', name: 'a WebP picture' };
  if (DRAWING.test(start)) return { kind: 'drawing', name: 'an SVG drawing' };
  const brands = brandsOf(view);
  const [, signature] = BRANDS.find(([names]) => names.some((name) => brands.includes(name))) ?? [];
  return signature ?? { kind: 'other' };
}

/** The brands of an ISO base media file; empty for other files. */
export function brandsOf(view: DataView): readonly string[] {
  if (!startsWith(view, 'ftyp', 4)) return [];
  return latin(view, 8, Math.min(view.getUint32(0), 256) - 8).match(/.{4}/gs) ?? [];
}
