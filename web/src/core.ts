/** `c2warp/core` for pages and workers: the headless solver. `web/docs/core.md` explains it. */
import { browser } from './core/browser';
import type { PictureInput, WarperOptions } from './core/types';
import { Warper } from './core/warper';

export { encodePng } from './core/encode_png';
export type { PosedSolution } from './core/posed';
export type { Solution } from './core/solution';
export type * from './core/types';
export { C2WarpError, type C2WarpErrorCode, type SolverErrorCode } from './error';
export type { Warper };

/**
 * Opens a picture.
 *
 * @throws C2WarpError with the code `picture` for anything but a picture, `engine` if the solver cannot be loaded.
 * @throws the reason of the signal if that is aborted.
 */
export const createWarper = (picture: PictureInput, options?: WarperOptions): Promise<Warper> =>
  Warper.create(browser, picture, options);
