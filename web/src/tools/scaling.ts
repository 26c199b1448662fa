/**
 * Scaling several handles together by the grip on their ring. The farthest handle moves as far as the pointer. Shift
 * snaps to tenths.
 */
import type { Document } from '../document/document';
import { posedGroup } from '../document/group';
import { distance, snapped, type Vec } from '../geometry/vec';
import type { GroupRing } from './group_ring';
import { outcome, type State } from './state';

const STEP = 0.1;

/** @param origin the document at the start of the drag. */
export const scaling = (
  origin: Document,
  { pivot, radius, clearance }: GroupRing,
  from: Vec,
  rest: State,
): State => {
  const held = distance(pivot, from);
  const state: State = {
    holds: true,
    move: (press) => {
      const scale = 1 + (distance(pivot, press.at) - held) / (radius - clearance);
      const steps = press.shift ? Math.max(STEP, snapped(scale, STEP)) : scale;
      return outcome(state, { type: 'edit', ...posedGroup(origin, 0, steps) });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  };
  return state;
};
