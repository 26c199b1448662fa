/**
 * Decodes pictures with the browser's decoders, which apply the EXIF orientation and convert colour profiles to sRGB.
 * A picture with neither keeps its exact bytes.
 *
 * Files on which browsers disagree are changed first. `web/docs/pictures.md` lists them.
 */

import { WarpError } from '../error';
import { type Header, readHeader } from './formats/header';
import { probes } from './formats/jpeg';
import { withoutExif } from './formats/webp';
import { checkSize } from './limits';
import { straightPixels } from './pixels';
import { readBytes } from './read';
import { turned } from './turn';

export interface DecodedPicture {
  /** Premultiplied, for drawing. The caller closes it. */
  readonly bitmap: ImageBitmap;
  readonly width: number;
  readonly height: number;
  /** Straight alpha: RGBA, rows from the top. */
  readonly rgba: Uint8Array<ArrayBuffer>;
  /** Whether the file has several frames. The picture is the first. */
  readonly moves: boolean;
}

const INCOMPLETE = 'The picture is incomplete: the end of the file is missing. Get the file again.';

/**
 * Returns the picture in a file.
 *
 * @throws WarpError if the file is not a picture, is incomplete, or has an unsupported size.
 * @throws ReadError if the bytes cannot be read.
 */
export async function decodePicture(file: Blob): Promise<DecodedPicture> {
  if (file.size === 0) throw new WarpError('picture', 'The file is empty.');
  const bytes = await readBytes(file);
  const header = readHeader(bytes);
  const { kind, size, end, moves, orientation = 1 } = header;
  if (kind === 'drawing') throw unreadable(header);
  // Checked before decoding: a small file can hold more pixels than fit in memory.
  if (size) checkSize(size.width, size.height);
  if (end === 'missing') throw new WarpError('picture', INCOMPLETE);
  if (typeof end === 'number') return await decodeUnmarked(probes(bytes, end), header);
  if (orientation === 1) return { ...(await decode(file, header)), moves };

  const { bitmap, ...stored } = await decode(new Blob([withoutExif(bytes)], { type: file.type }), header);
  bitmap.close();
  const { width, height, rgba } = turned(stored, orientation);
  const data = new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
  return { width, height, rgba, moves, bitmap: await createImageBitmap(data) };
}

type Decoded = Omit<DecodedPicture, 'moves'>;

/** Decodes a JPEG without an end marker. */
async function decodeUnmarked([plain, ...filled]: readonly Blob[], header: Header): Promise<DecodedPicture> {
  const picture = await decode(plain ?? new Blob(), header);
  for (const probe of filled) {
    const other = await decode(probe, header).catch(() => null);
    other?.bitmap.close();
    if (other && isSame(picture.rgba, other.rgba)) continue;
    picture.bitmap.close();
    throw new WarpError('picture', INCOMPLETE);
  }
  return { ...picture, moves: false };
}

function isSame(a: Uint8Array<ArrayBuffer>, b: Uint8Array<ArrayBuffer>): boolean {
  const [colours, others] = [new Uint32Array(a.buffer), new Uint32Array(b.buffer)];
  return colours.length === others.length && colours.every((colour, i) => colour === others[i]);
}

async function decode(file: Blob, header: Header): Promise<Decoded> {
  const { kind } = header;
  const straight = await bitmapOf(file, 'none', header);
  let bitmap: ImageBitmap | undefined;
  try {
    checkSize(straight.width, straight.height);
    if (kind !== 'jpeg') bitmapsKeepColours ??= await probeBitmapColours();
    const image = kind === 'jpeg' || bitmapsKeepColours ? null : await imageOf(file);
    const rgba = straightPixels(image ?? straight, straight.width, straight.height);
    // The caller closes this bitmap, so nothing may fail after this line. A JPEG has no alpha: decode it once.
    bitmap = kind === 'jpeg' ? straight : await bitmapOf(file, 'premultiply', header);
    return { bitmap, width: bitmap.width, height: bitmap.height, rgba };
  } finally {
    if (bitmap !== straight) straight.close();
  }
}

async function bitmapOf(file: Blob, premultiplyAlpha: 'none' | 'premultiply', header: Header) {
  try {
    return await createImageBitmap(file, { premultiplyAlpha });
  } catch (cause) {
    // Firefox fails here for some photographs with EXIF data, but decodes them in an image element.
    const image = header.kind === 'jpeg' ? await imageOf(file) : null;
    if (image) return await createImageBitmap(image, { premultiplyAlpha });
    throw unreadable(header, cause);
  }
}

/** The error for a file that the browser cannot decode. */
function unreadable({ kind, name }: Header, cause?: unknown): WarpError {
  const message =
    name === undefined
      ? 'The file is not a picture that this browser can read. Use PNG, JPEG or WebP.'
      : kind === 'other' || kind === 'drawing'
        ? `This is ${name}. Save it as PNG, JPEG or WebP.`
        : 'The picture is damaged, or this browser cannot read it. Save it again as PNG, JPEG or WebP.';
  return new WarpError('picture', message, { cause });
}

/** Set by the first picture that can have transparency. */
let bitmapsKeepColours: boolean | undefined;

/**
 * Whether bitmaps keep the exact colours of translucent pixels. WebKit premultiplies them and divides again; its image
 * elements keep the colours.
 */
async function probeBitmapColours(): Promise<boolean> {
  const colour = Uint8ClampedArray.of(200, 100, 50, 1);
  const bitmap = await createImageBitmap(new ImageData(colour, 1, 1), { premultiplyAlpha: 'none' });
  try {
    return straightPixels(bitmap, 1, 1).every((value, i) => value === colour[i]);
  } finally {
    bitmap.close();
  }
}

/** Returns an image element with the file, or `null` if decoding fails or the page's policy forbids it. */
async function imageOf(file: Blob): Promise<HTMLImageElement | null> {
  const image = new Image();
  image.src = URL.createObjectURL(file);
  try {
    await image.decode();
    return image;
  } catch {
    return null;
  } finally {
    URL.revokeObjectURL(image.src);
  }
}
