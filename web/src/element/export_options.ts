/** Checks the options of `toBlob` and `toCanvas`. */
import type { DrawingOptions } from '../compute/messages';
import type { FileSettings, PictureType } from '../io/encoding';
import type { BlobOptions, WarpOptions } from './api';

const TYPES: readonly PictureType[] = ['image/png', 'image/jpeg', 'image/webp'];

const DRAWN = [
  'scale',
  'grow',
  'crop',
  'pixelated',
  'signal',
] as const satisfies readonly (keyof WarpOptions)[];
const WRITTEN = [
  ...DRAWN,
  'type',
  'quality',
  'background',
  'onProgress',
] as const satisfies readonly (keyof BlobOptions)[];

/** @throws RangeError that names the invalid option. */
export function drawingSettings({
  scale = 1,
  grow = false,
  crop = false,
}: WarpOptions): Omit<DrawingOptions, 'pixelated'> {
  if (!(Number.isFinite(scale) && scale > 0)) throw new RangeError('scale: expected a number above 0');
  return { scale, area: crop ? 'covered' : grow ? 'grown' : 'picture' };
}

/** @throws the errors of {@link drawingSettings}. */
export function fileSettings({
  type = 'image/png',
  quality = 0.9,
  background = '#ffffff',
}: BlobOptions): Omit<FileSettings, 'width' | 'height'> {
  if (!TYPES.includes(type)) throw new RangeError(`type: expected one of ${TYPES.join(', ')}`);
  if (!(quality >= 0 && quality <= 1)) throw new RangeError('quality: expected a number from 0 to 1');
  if (!/^#[\da-f]{6}$/i.test(background)) throw new RangeError('background: expected a colour as #rrggbb');
  return { type, quality, background, chunks: [] };
}

/** Unlike a canvas, both methods take one object. @throws TypeError that names the fault. */
export const checkWritten = (options: unknown): void => checkKeys('toBlob', options, WRITTEN);

/** @throws the errors of {@link checkWritten}. */
export const checkDrawn = (options: unknown): void => checkKeys('toCanvas', options, DRAWN);

function checkKeys(method: string, options: unknown, keys: readonly string[]): void {
  if (typeof options !== 'object' || options === null)
    throw new TypeError(
      `${method}: expected an object of options such as { scale: 2 }, found a ${typeof options}`,
    );
  const unknown = Object.keys(options).find((key) => !keys.includes(key));
  if (unknown !== undefined)
    throw new TypeError(`${method}: unknown option "${unknown}"; expected one of ${keys.join(', ')}`);
}
