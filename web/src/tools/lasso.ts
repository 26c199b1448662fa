/**
 * The lasso tool (L): draws a ring around a part of the original, which becomes the domain. A drag draws freely, and
 * presses set corners. Alt at the first press cuts a hole.
 */
import { begun } from './drafting';
import type { State } from './state';

export const lasso: State = {
  down: (press, context) => begun({ kind: 'lasso', hole: press.alt }, press, context, lasso),
};
