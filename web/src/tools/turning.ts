/**
 * Turning by the ring or an Alt-drag. One handle turns about its own centre. An automatic rotation starts from its
 * current value, and is then fixed. Several handles turn together about their common centre.
 *
 * Shift snaps to 15°. Full turns count: twice around is two turns.
 */

import { turnHandles } from '../document/edits';
import { posedGroup } from '../document/group';
import { rotationOf } from '../document/handle';
import { bearing, snapped, type Vec, wrapDegrees } from '../geometry/vec';
import { outcome, type State, type ToolContext } from './state';

export const SNAP_DEGREES = 15;

/**
 * @param context the context at the start of the drag.
 * @param pivot the point that the pointer goes around.
 * @param from where the drag started.
 */
export const turning = (
  { document, turns }: Pick<ToolContext, 'document' | 'turns'>,
  ids: readonly string[],
  pivot: Vec,
  from: Vec,
  rest: State,
): State => {
  const several = ids.length > 1;
  const after = (turn: number, last: number): State => ({
    holds: true,
    move: (press) => {
      const now = bearing(pivot, press.at);
      const whole = turn + wrapDegrees(now - last);
      const stepped = (degrees: number) => (press.shift ? snapped(degrees, SNAP_DEGREES) : degrees);
      const effect = several
        ? posedGroup(document, stepped(whole), 1)
        : { document: turnHandles(document, ids, (handle) => stepped(rotationOf(handle, turns) + whole)) };
      return outcome(after(whole, now), { type: 'edit', ...effect });
    },
    up: () => outcome(rest, { type: 'commit' }),
    cancel: () => outcome(rest, { type: 'bail' }),
  });
  return after(0, bearing(pivot, from));
};
