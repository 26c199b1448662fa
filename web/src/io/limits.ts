/** The sizes of pictures that can be opened; the solver has the same limits. */
import { PictureError } from './picture_error';

export const MIN_SIDE = 2;
export const MAX_SIDE = 16_384;
export const MAX_PIXELS = 100_000_000;

/** @throws PictureError where the size is out of bounds. */
export function checkSize(width: number, height: number): void {
  const size = `${width} × ${height} px`;
  if (width < MIN_SIDE || height < MIN_SIDE) {
    throw new PictureError(
      `The picture has ${size}; at least ${MIN_SIDE} × ${MIN_SIDE} are needed to bend it.`,
    );
  }
  if (width > MAX_SIDE || height > MAX_SIDE) {
    throw new PictureError(`The picture has ${size}; a side may have ${grouped(MAX_SIDE)} px at most.`);
  }
  if (width * height > MAX_PIXELS) {
    throw new PictureError(`The picture has ${size}; ${MAX_PIXELS / 1e6} million pixels are the most.`);
  }
}

const grouped = (value: number): string => value.toLocaleString('en');
