/** Dragging handles: everything selected follows the pointer by the same way. */

import type { Document } from '../document/document';
import { moveHandles } from '../document/edits';
import { subtract, type Vec } from '../geometry/vec';
import { outcome, type State } from './state';

/** @param origin the document at the mark; every move is computed from it, so that rounding never adds up. */
export const moving = (origin: Document, ids: readonly string[], from: Vec, rest: State): State => {
  const state: State = {
    move: (press) =>
      outcome(state, { type: 'edit', document: moveHandles(origin, ids, subtract(press.at, from)) }),
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  };
  return state;
};
