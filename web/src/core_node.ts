/** `c2warp/core` for Node. Its types are those of `core.ts`. */
import { node } from './core/node';
import type { PictureInput, WarperOptions } from './core/types';
import { Warper } from './core/warper';

export { encodePng } from './core/encode_png';
export type { PosedSolution } from './core/posed';
export type { Solution } from './core/solution';
export type * from './core/types';
export { C2WarpError, type C2WarpErrorCode, type SolverErrorCode } from './error';
export type { Warper };

/** @see the one of `core.ts`. */
export const createWarper = (picture: PictureInput, options?: WarperOptions): Promise<Warper> =>
  Warper.create(node, picture, options);
