/** Checks the options of `toBlob`. */
import type { Area } from '../geometry/area';
import type { FileSettings, PictureType } from '../io/encoding';
import type { BlobOptions, WarpOptions } from './api';

const TYPES: readonly PictureType[] = ['image/png', 'image/jpeg', 'image/webp'];

/** @throws RangeError that names the invalid option. */
export function blobSettings({
  type = 'image/png',
  quality = 0.9,
  background = '#ffffff',
}: BlobOptions): Omit<FileSettings, 'width' | 'height'> {
  if (!TYPES.includes(type)) throw new RangeError(`type: expected one of ${TYPES.join(', ')}`);
  if (!(quality >= 0 && quality <= 1)) throw new RangeError('quality: expected a number from 0 to 1');
  if (!/^#[\da-f]{6}$/i.test(background)) throw new RangeError('background: expected a colour as #rrggbb');
  return { type, quality, background, chunks: [] };
}

export const areaOf = ({ grow = false, crop = false }: WarpOptions): Area =>
  crop ? 'covered' : grow ? 'grown' : 'picture';
