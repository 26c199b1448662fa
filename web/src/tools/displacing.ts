/** The brush that moves places of the picture, before the handles pose them. */

import { displacementAt } from '../document/displacement';
import {
  beginDisplacing,
  type DisplacingBrush,
  type DisplacingStroke,
  ledDisplacing,
  withDisplacing,
} from '../document/displacing_stroke';
import { add } from '../geometry/vec';
import { say } from '../texts/wording';
import { type Brushing, stroked } from './brushing';
import { type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/** @param resting The tool between presses, if nothing under the brush bends. */
export function displace(press: Press, own: DisplacingBrush, context: ToolContext, resting: State): Outcome {
  if (!context.place(press.at, own.radius)) return outcome(resting, { type: 'miss', at: press.at });
  const limits = { guarded: context.guards, held: context.heldOutline() };
  const begun = beginDisplacing(context.document.project, own, limits);
  const kind: Brushing<DisplacingStroke> = {
    radius: own.radius,
    // Strokes go by the moved places.
    place: ({ field }, rest) => add(rest, displacementAt(field, rest)),
    led: ledDisplacing,
    edited: (stroke) => ({ project: withDisplacing(stroke), stopped: stroke.stopped }),
  };
  return stroked(press, begun, kind, say(`steps.strokes.${own.kind}`), context);
}
