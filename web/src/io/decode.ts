/**
 * Decodes a picture with the browser's own decoders: turned upright by its EXIF data, and converted to sRGB from its
 * colour profile. A picture without either keeps its bytes.
 */
import { type Header, readHeader } from './header';
import { checkSize } from './limits';
import { PictureError } from './picture_error';
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
 * @throws PictureError where the file is no picture, incomplete, or of a size that cannot be opened; ReadError where it
 * cannot be read.
 */
export async function decodePicture(file: Blob): Promise<DecodedPicture> {
  if (file.size === 0) throw new PictureError('The file is empty.');
  const { kind, size, complete } = readHeader(await readBytes(file));
  if (kind === 'svg') {
    throw new PictureError('An SVG is a drawing without pixels: export it as PNG, and open that.');
  }
  // Before decoding: a small file can hold more pixels than memory does.
  if (size) checkSize(size.width, size.height);
  if (!complete) throw new PictureError('The picture is cut off: the end of the file is missing.');

  const straight = await bitmapOf(file, 'none', kind);
  let bitmap: ImageBitmap | undefined;
  try {
    checkSize(straight.width, straight.height);
    if (kind !== 'jpeg') bitmapsKeepColours ??= await keepsColours();
    const image = kind === 'jpeg' || bitmapsKeepColours ? null : await imageOf(file);
    const rgba = straightPixels(image ?? straight, straight.width, straight.height);
    // Last: the caller closes this bitmap, so nothing may fail after it. A JPEG has no alpha, and is decoded once.
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
    // Firefox makes no bitmap of some photographs with EXIF data that it decodes for an image element.
    const image = kind === 'jpeg' ? await imageOf(file) : null;
    if (image) return await createImageBitmap(image, { premultiplyAlpha });
    throw new PictureError(
      kind === 'other'
        ? 'This is not a picture that the browser can show: PNG, JPEG and WebP work everywhere.'
        : 'The picture is damaged, or of a kind that this browser cannot show.',
      { cause: error },
    );
  }
}

/** Of this browser; found out with the first picture that may be transparent. */
let bitmapsKeepColours: boolean | undefined;

/** False in WebKit, whose bitmaps have colours that were premultiplied and divided again; those of images have not. */
async function keepsColours(): Promise<boolean> {
  const colour = Uint8ClampedArray.of(200, 100, 50, 1);
  const bitmap = await createImageBitmap(new ImageData(colour, 1, 1), { premultiplyAlpha: 'none' });
  try {
    return straightPixels(bitmap, 1, 1).every((value, i) => value === colour[i]);
  } finally {
    bitmap.close();
  }
}

/** The file in an image element; null where it cannot be decoded, or the page's policy forbids it. */
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
