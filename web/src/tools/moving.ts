/** Dragging handles: all selected handles move by the same vector. */

import type { Document } from '../document/document';
import { moveHandles } from '../document/edits';
import { subtract, type Vec } from '../geometry/vec';
import { outcome, type State } from './state';

/** @param origin the document at the start of the drag; every move starts from it, so that rounding never adds up. */
export const moving = (origin: Document, ids: readonly string[], from: Vec, rest: State): State => {
  const state: State = {
    holds: true,
    move: (press) =>
      outcome(state, { type: 'edit', document: moveHandles(origin, ids, subtract(press.at, from)) }),
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  };
  return state;
};
