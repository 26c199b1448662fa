/** Converts pictures of a page to the form that the editor opens: an address, or a file with its name. */

import type { NamedFile } from '../editor/picture';
import { C2WarpError } from '../error';
import type { PictureSource } from './api';

/** The name of a picture without a file. */
const NAME = 'picture.png';

/**
 * Encoding pixels as a file takes time.
 *
 * @throws the errors of {@link pngOf}; TypeError for anything that is not a picture.
 */
export function namedSource(source: PictureSource): string | NamedFile | Promise<NamedFile> {
  if (typeof source === 'string') return source;
  if (source instanceof URL) return source.href;
  if (source instanceof File) return { name: source.name, file: source };
  if (source instanceof Blob) return { name: NAME, file: source };
  if (isOf(source, 'HTMLImageElement')) return addressOf(source as HTMLImageElement);
  if (isDrawable(source)) return pngOf(source).then((file) => ({ name: NAME, file }));
  throw new TypeError(
    'load: expected an address, a Blob such as a File, an image, a canvas, an ImageBitmap or an ImageData',
  );
}

/** Compares names, because an image or a canvas of a frame belongs to another realm. */
const isOf = (value: unknown, ...names: readonly string[]): boolean =>
  names.includes(Object.prototype.toString.call(value).slice('[object '.length, -1));

type Drawable = HTMLCanvasElement | OffscreenCanvas | ImageBitmap | ImageData;

const isDrawable = (source: unknown): source is Drawable =>
  isOf(source, 'HTMLCanvasElement', 'OffscreenCanvas', 'ImageBitmap', 'ImageData');

/** The file itself is read again: its pixels are exact, and a saved project can name it. */
function addressOf(image: HTMLImageElement): string {
  const address = image.currentSrc || image.src;
  if (!address) throw new C2WarpError('picture', 'load: the image has no address yet');
  return address;
}

/** @throws C2WarpError `picture` for a picture without pixels, or with pixels of another origin. */
async function pngOf(source: Drawable): Promise<Blob> {
  const { width, height } = source;
  if (width === 0 || height === 0)
    throw new C2WarpError('picture', `load: the picture has ${width} × ${height} pixels`);
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext('2d');
  if (!pen)
    throw new C2WarpError(
      'picture',
      `load: the browser cannot create a canvas of ${width} × ${height} pixels`,
    );
  if ('data' in source) pen.putImageData(source, 0, 0);
  else pen.drawImage(source, 0, 0);
  try {
    return await canvas.convertToBlob({ type: 'image/png' });
  } catch (cause) {
    throw new C2WarpError(
      'picture',
      'load: the canvas has pixels from another origin, so scripts cannot read it',
      {
        cause,
      },
    );
  }
}
