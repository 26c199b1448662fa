/** Placing a point handle: a press adds it, and a drag moves it. Both together are one undo step. */

import { restingRotation } from '../document/bending';
import { addHandle, freeId } from '../document/edits';
import { rounded, roundedVec } from '../document/handle';
import type { PointHandle, Project } from '../document/project';
import type { Placement } from '../geometry/place';
import { add, distance, subtract } from '../geometry/vec';
import { say } from '../texts/wording';
import { moving } from './moving';
import { type Outcome, outcome, type Press, type State, snappedPlace, type ToolContext } from './state';

/**
 * Returns a handle with the rotation and scale of the posed picture at its position, so that the picture does not jump.
 *
 * An automatic rotation follows from the pose. Where the picture is flipped, the nearest scale can be 0. It becomes 1,
 * since handles have positive scales.
 */
export function pointHandle(project: Project, placement: Placement): PointHandle {
  const { rest, rotation, scale } = placement;
  const posed = roundedVec(placement.posed);
  return {
    id: freeId(project),
    kind: 'point',
    // Relative to the rounded `posed`, so that both are equal in an unbent picture in spite of rounding.
    rest: roundedVec(add(posed, subtract(rest, placement.posed))),
    posed,
    rotation: restingRotation(project) === 'auto' ? 'auto' : rounded(rotation),
    scale: rounded(scale) || 1,
  };
}

export function placed(press: Press, context: ToolContext, rest: State): Outcome {
  const { at, guides } = snappedPlace(press.at, press, context, []);
  const placement = context.place(at) ?? context.place(press.at);
  if (!placement) return outcome(rest, { type: 'miss', at: press.at });
  const handle = pointHandle(context.document.project, placement);
  const document = addHandle(context.document, handle);
  return outcome(
    placing(document, handle, press, rest),
    { type: 'begin', label: say('steps.add.point') },
    { type: 'edit', document },
    { type: 'guides', guides },
  );
}

const placing = (
  origin: ToolContext['document'],
  { id, posed }: PointHandle,
  from: Press,
  rest: State,
): State => {
  const drag = moving(origin, [id], posed, from.at, rest);
  const state: State = {
    ...drag,
    move: (press, context) => {
      const stays = distance(press.at, from.at) <= context.grips.slop;
      return stays ? outcome(state) : (drag.move?.(press, context) ?? outcome(state));
    },
  };
  return state;
};
