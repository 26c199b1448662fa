/**
 * Turning handles by the ring or an Alt-drag, each selected handle about its own centre. Shift snaps to 15°. An
 * automatic handle starts from its current turn, and its rotation is then pinned. Full turns count: twice around is
 * two turns.
 */

import { turnHandles } from '../document/edits';
import { rotationOf } from '../document/handle';
import { bearing, snapped, type Vec, wrapDegrees } from '../geometry/vec';
import { outcome, type Scene, type State } from './state';

export const SNAP_DEGREES = 15;

/**
 * @param scene the scene at the start of the drag.
 * @param pivot the point that the pointer goes around.
 * @param from where the drag started.
 */
export const turning = (
  { document, turns }: Pick<Scene, 'document' | 'turns'>,
  ids: readonly string[],
  pivot: Vec,
  from: Vec,
  rest: State,
): State => {
  const after = (turn: number, last: number): State => ({
    holds: true,
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
