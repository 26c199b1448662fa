/**
 * Placing a point handle: it appears when the pointer goes down, and can be dragged before the release. Both together
 * are one undo step.
 */

import { restingRotation } from '../document/bending';
import { addHandle, freeId } from '../document/edits';
import { rounded, roundedVec } from '../document/handle';
import type { PointHandle, Project } from '../document/project';
import type { Placement } from '../geometry/place';
import { add, distance, subtract } from '../geometry/vec';
import { moving } from './moving';
import { type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/**
 * A handle at a place of the posed picture, with the motion that the picture has there, so that the picture does not
 * jump. An automatic rotation follows from the pose. Where the picture is turned over, the nearest scale can be 0, which
 * no handle has.
 */
export function pointHandle(project: Project, placement: Placement): PointHandle {
  const { rest, rotation, scale } = placement;
  const posed = roundedVec(placement.posed);
  return {
    id: freeId(project),
    kind: 'point',
    // From there, so that what is not bent rests where it is: a half of a hundredth is rounded up or down by a hair.
    rest: roundedVec(add(posed, subtract(rest, placement.posed))),
    posed,
    rotation: restingRotation(project) === 'auto' ? 'auto' : rounded(rotation),
    scale: rounded(scale) || 1,
  };
}

export function placed(press: Press, context: ToolContext, rest: State): Outcome {
  const placement = context.place(press.at);
  if (!placement) return outcome(rest, { type: 'miss' });
  const handle = pointHandle(context.document.project, placement);
  const document = addHandle(context.document, handle);
  return outcome(
    placing(document, handle.id, press, rest),
    { type: 'begin', label: 'Add handle' },
    { type: 'edit', document },
  );
}

const placing = (origin: ToolContext['document'], id: string, from: Press, rest: State): State => {
  const drag = moving(origin, [id], from.at, rest);
  const state: State = {
    ...drag,
    move: (press, context) => {
      const stays = distance(press.at, from.at) <= context.grips.slop;
      return stays ? outcome(state) : (drag.move?.(press, context) ?? outcome(state));
    },
  };
  return state;
};
