/**
 * Decodes pictures with the browser's decoders, which apply the EXIF orientation and convert colour profiles to sRGB.
 * A picture with neither keeps its exact bytes.
 */

import { WarpError } from '../error';
import { type Header, readHeader } from './header';
import { checkSize } from './limits';
import { straightPixels } from './pixels';
import { readBytes } from './read';

export interface DecodedPicture {
  /** Premultiplied, for drawing. The caller closes it. */
  readonly bitmap: ImageBitmap;
  readonly width: number;
  readonly height: number;
  /** Straight alpha: RGBA, rows from the top. */
  readonly rgba: Uint8Array<ArrayBuffer>;
}

/**
 * Returns the picture in a file.
 *
 * @throws WarpError if the file is not a picture, is incomplete, or has an unsupported size.
 * @throws ReadError if the bytes cannot be read.
 */
export async function decodePicture(file: Blob): Promise<DecodedPicture> {
  if (file.size === 0) throw new WarpError('picture', 'The file is empty.');
  const { kind, size, complete } = readHeader(await readBytes(file));
  if (kind === 'svg') {
    throw new WarpError('picture', 'SVG files have no pixels. Export the drawing as PNG and open the PNG.');
  }
  // Checked before decoding: a small file can hold more pixels than fit in memory.
  if (size) checkSize(size.width, size.height);
  if (!complete) {
    throw new WarpError(
      'picture',
      'The picture is incomplete: the end of the file is missing. Get the file again.',
    );
  }

  const straight = await bitmapOf(file, 'none', kind);
  let bitmap: ImageBitmap | undefined;
  try {
    checkSize(straight.width, straight.height);
    if (kind !== 'jpeg') bitmapsKeepColours ??= await probeBitmapColours();
    const image = kind === 'jpeg' || bitmapsKeepColours ? null : await imageOf(file);
    const rgba = straightPixels(image ?? straight, straight.width, straight.height);
    // The caller closes this bitmap, so nothing may fail after this line. A JPEG has no alpha: decode it once.
    bitmap = kind === 'jpeg' ? straight : await bitmapOf(file, 'premultiply', kind);
    return { bitmap, width: bitmap.width, height: bitmap.height, rgba };
  } finally {
    if (bitmap !== straight) straight.close();
  }
}

async function bitmapOf(file: Blob, premultiplyAlpha: 'none' | 'premultiply', kind: Header['kind']) {
  try {
    return await createImageBitmap(file, { premultiplyAlpha });
  } catch (error) {
    // Firefox fails here for some photographs with EXIF data, but decodes them in an image element.
    const image = kind === 'jpeg' ? await imageOf(file) : null;
    if (image) return await createImageBitmap(image, { premultiplyAlpha });
    throw new WarpError(
      'picture',
      kind === 'other'
        ? 'The file is not a picture that this browser can read. Use PNG, JPEG or WebP.'
        : 'The picture is damaged, or this browser cannot read it. Save it again as PNG, JPEG or WebP.',
      { cause: error },
    );
  }
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
