/** Limits on the size of pictures: those of the solver. */

import { C2WarpError } from '../error';
import { MAX_PIXELS, MAX_SIDE, MIN_SIDE } from './generated/limits';

/** @throws C2WarpError if the size is out of bounds. */
export function checkSize(width: number, height: number): void {
  const size = `${width} × ${height} px`;
  if (width < MIN_SIDE || height < MIN_SIDE) {
    throw new C2WarpError(
      'picture',
      `The picture is ${size}. It must be at least ${MIN_SIDE} × ${MIN_SIDE} px.`,
    );
  }
  if (width > MAX_SIDE || height > MAX_SIDE) {
    throw new C2WarpError(
      'picture',
      `The picture is ${size}. A side can be at most ${grouped(MAX_SIDE)} px: scale the picture down.`,
    );
  }
  if (width * height > MAX_PIXELS) {
    throw new C2WarpError(
      'picture',
      `The picture is ${size}. It can have at most ${MAX_PIXELS / 1e6} million pixels: scale the picture down.`,
    );
  }
}

const grouped = (value: number): string => value.toLocaleString('en');
