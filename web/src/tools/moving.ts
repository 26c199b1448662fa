/**
 * Dragging handles: all of them move by the same vector. Shift snaps its direction to steps of 45°. Otherwise the
 * leading handle snaps to guides.
 */

import type { Document } from '../document/document';
import { moveHandles } from '../document/edits';
import { constrained } from '../geometry/polyline';
import { add, subtract, type Vec } from '../geometry/vec';
import { outcome, type State, snappedPlace } from './state';
import { STEP_DEGREES } from './stroking';

/**
 * @param origin the document at the start of the drag. Moves start from it, so that rounding errors do not add up.
 * @param lead the place of the leading handle at the start.
 */
export const moving = (
  origin: Document,
  ids: readonly string[],
  lead: Vec,
  from: Vec,
  rest: State,
): State => {
  const state: State = {
    holds: true,
    move: (press, context) => {
      const to = press.shift ? constrained(from, press.at, STEP_DEGREES) : press.at;
      const { at, guides } = snappedPlace(add(lead, subtract(to, from)), press, context, ids);
      const document = moveHandles(origin, ids, subtract(at, lead));
      return outcome(state, { type: 'edit', document }, { type: 'guides', guides });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  };
  return state;
};
