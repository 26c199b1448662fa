/**
 * The lasso tool (L): draws around what bends, on the original. A drag draws freely, presses set corners. With Alt at
 * the beginning it cuts a hole.
 */
import { begun } from './drafting';
import type { State } from './state';

export const lasso: State = {
  down: (press, context) => begun({ kind: 'lasso', hole: press.alt }, press, context, lasso),
};
