/**
 * Turning handles, by the ring or by an Alt-drag: each selected one about its own place. Shift snaps to 15°. An automatic
 * one goes on from the turn that it has, and keeps what it is given. The way around counts: twice around is two turns.
 */

import { turnHandles } from '../document/edits';
import { rotationOf } from '../document/handle';
import { bearing, snapped, type Vec, wrapDegrees } from '../geometry/vec';
import { outcome, type Scene, type State } from './state';

export const SNAP_DEGREES = 15;

/** @param scene the one at the mark; `pivot` the place that the pointer goes around; `from` is where it took hold. */
export const turning = (
  { document, turns }: Pick<Scene, 'document' | 'turns'>,
  ids: readonly string[],
  pivot: Vec,
  from: Vec,
  rest: State,
): State => {
  const after = (turn: number, last: number): State => ({
    move: (press) => {
      const now = bearing(pivot, press.at);
      const whole = turn + wrapDegrees(now - last);
      const turned = turnHandles(document, ids, (handle) => {
        const degrees = rotationOf(handle, turns) + whole;
        return press.shift ? snapped(degrees, SNAP_DEGREES) : degrees;
      });
      return outcome(after(whole, now), { type: 'edit', document: turned });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  });
  return after(0, bearing(pivot, from));
};
