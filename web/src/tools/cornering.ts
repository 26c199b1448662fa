/**
 * Dragging one corner of a bar or polygon. Shift snaps the direction of its edge to steps of 45°. Otherwise the corner
 * snaps to guides.
 */
import { type Document, handleById } from '../document/document';
import { putCorner } from '../document/edits';
import { isLine, rotationOf } from '../document/handle';
import { constrained } from '../geometry/polyline';
import { add, subtract, type Vec } from '../geometry/vec';
import { outcome, type State, snappedPlace } from './state';
import { STEP_DEGREES } from './stroking';

/** @param origin the document at the start of the drag. */
export const cornering = (origin: Document, id: string, index: number, from: Vec, rest: State): State => {
  const handle = handleById(origin, id);
  const start = handle && isLine(handle) ? handle.posed[index] : undefined;
  if (!handle || !start || !isLine(handle)) return rest;
  const { posed } = handle;
  const neighbour = posed[index - 1] ?? posed[index + 1] ?? start;
  /** The state after a move. It has the turn so far, so that full turns count. */
  const after = (turn: number): State => ({
    holds: true,
    move: (press, context) => {
      const at = add(start, subtract(press.at, from));
      const { at: free, guides } = snappedPlace(at, press, context, [id]);
      const goal = press.shift ? constrained(neighbour, at, STEP_DEGREES) : free;
      const document = putCorner(origin, id, index, goal, turn);
      const put = handleById(document, id);
      const next = after(put ? rotationOf(put) : turn);
      return outcome(next, { type: 'edit', document }, { type: 'guides', guides });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  });
  return after(rotationOf(handle));
};
