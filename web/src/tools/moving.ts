/** Dragging handles: all of them move by the same vector. Shift snaps its direction to steps of 45°. */

import type { Document } from '../document/document';
import { moveHandles } from '../document/edits';
import { constrained } from '../geometry/polyline';
import { subtract, type Vec } from '../geometry/vec';
import { STEP_DEGREES } from './drafting';
import { outcome, type State } from './state';

/** @param origin the document at the start of the drag. Moves start from it, so that rounding errors do not add up. */
export const moving = (origin: Document, ids: readonly string[], from: Vec, rest: State): State => {
  const state: State = {
    holds: true,
    move: (press) => {
      const to = press.shift ? constrained(from, press.at, STEP_DEGREES) : press.at;
      return outcome(state, { type: 'edit', document: moveHandles(origin, ids, subtract(to, from)) });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  };
  return state;
};
