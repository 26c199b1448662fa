/** Limits on the size of pictures: those of the solver. */

import { say } from '../texts/wording';
import { MAX_PIXELS, MAX_SIDE, MIN_SIDE } from './generated/limits';
import { pictureError } from './picture_error';

/** @throws C2WarpError if the size is out of bounds. */
export function checkSize(width: number, height: number): void {
  if (width < MIN_SIDE || height < MIN_SIDE) {
    throw pictureError('picture', say('errors.picture.tooSmall', width, height, MIN_SIDE));
  }
  if (width > MAX_SIDE || height > MAX_SIDE) {
    throw pictureError('picture', say('errors.picture.tooLong', width, height, MAX_SIDE));
  }
  if (width * height > MAX_PIXELS) {
    throw pictureError('picture', say('errors.picture.tooLarge', width, height, MAX_PIXELS / 1e6));
  }
}
