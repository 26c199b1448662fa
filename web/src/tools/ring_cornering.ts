/**
 * Dragging a corner of a drawn domain, or a new one from an edge. The outline stops before it crosses itself. A lasso
 * that snaps to edges puts the corner on one nearby, except with Alt.
 */

import type { Document } from '../document/document';
import {
  type RingCorner,
  ringCornerAt,
  withRingCornerAdded,
  withRingCornerMoved,
} from '../document/lasso_corners';
import { add, distance, subtract } from '../geometry/vec';
import { say } from '../texts/wording';
import type { RingHit } from './ring_hit';
import { type Outcome, outcome, type Press, type State } from './state';

/** @param click the outcome of a press that is released where it began. */
export function ringPressing(hit: RingHit, from: Press, rest: State, click: () => Outcome): State {
  const state: State = {
    move: (press, context) => {
      if (distance(press.at, from.at) <= context.grips.slop) return outcome(state);
      const { document } = context;
      const adds = hit.part === 'edge';
      const corner: RingCorner = adds ? { ring: hit.ring, index: hit.place.edge + 1 } : hit;
      const project = adds ? withRingCornerAdded(document.project, hit.ring, hit.place) : document.project;
      const drag = ringCornering(
        { ...document, project },
        corner,
        from,
        document.project.handles.length,
        rest,
      );
      const first = drag.move?.(press, context) ?? outcome(drag);
      const label = say(adds ? 'steps.addSelectionCorner' : 'steps.moveSelectionCorner');
      return outcome(first.next, { type: 'begin', label }, ...first.effects);
    },
    up: click,
    cancel: () => outcome(rest),
  };
  return state;
}

/** @param handles their number at the start. */
function ringCornering(
  origin: Document,
  corner: RingCorner,
  from: Press,
  handles: number,
  rest: State,
): State {
  const start = ringCornerAt(origin.project, corner);
  if (!start) return rest;
  /** @param left the number of handles after the last move. */
  const after = (left: number): State => ({
    move: (press, context) => {
      const at = add(start, subtract(press.at, from.at));
      const [goal = at] = press.alt ? [] : (context.trace?.([], at) ?? []);
      const project = withRingCornerMoved(origin.project, corner, goal);
      if (!project) return outcome(after(left));
      return outcome(after(project.handles.length), { type: 'edit', document: { ...origin, project } });
    },
    up: () =>
      outcome(
        rest,
        { type: 'commit' },
        { type: 'ring-focus', corner },
        ...(left < handles ? [{ type: 'left-out', count: handles - left } as const] : []),
      ),
    cancel: () => outcome(rest, { type: 'bail' }),
  });
  return after(origin.project.handles.length);
}
