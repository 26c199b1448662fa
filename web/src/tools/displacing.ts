/**
 * The brush that moves places of the picture. A whole drag is one undo step.
 *
 * It works on the posed picture: each place of the pointer is led back to the moved place of the original under it,
 * before the handles pose that.
 */

import { displacementAt } from '../document/displacement';
import {
  beginDisplacing,
  type DisplacingBrush,
  type DisplacingStroke,
  ledDisplacing,
  withDisplacing,
} from '../document/displacing_stroke';
import type { Document } from '../document/document';
import { add, distance, type Vec } from '../geometry/vec';
import { type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/** A step of more radii than this, beyond the step of the pointer, leads to another part of the picture. */
const JUMP = 1;

const LABELS = {
  push: 'Push',
  pinch: 'Pinch',
  bloat: 'Bloat',
  smooth: 'Smooth',
  restore: 'Restore',
} as const;

/** @param resting The tool between presses, if nothing under the brush bends. */
export function displace(press: Press, own: DisplacingBrush, context: ToolContext, resting: State): Outcome {
  if (!context.place(press.at, own.radius)) return outcome(resting, { type: 'miss', at: press.at });
  const { document } = context;
  const limits = { guarded: context.guards, held: context.heldOutline() };
  const stroke = beginDisplacing(document.project, own, limits);
  const begun = moved(document, stroke, press, null, context);
  return outcome(begun.next, { type: 'begin', label: LABELS[own.kind] }, ...begun.effects);
}

interface Place {
  /** Of the pointer, and the moved place of the original under it. */
  readonly at: Vec;
  readonly moved: Vec;
}

const displacing = (document: Document, stroke: DisplacingStroke, last: Place): State => ({
  move: (press, context) => moved(document, stroke, press, last, context),
  up: () => outcome(ENDED, { type: 'commit' }),
  cancel: () => outcome(ENDED, { type: 'bail' }),
});

/** The tool returns to the state between presses. */
const ENDED: State = {};

/** Leads the stroke on to a press. */
function moved(
  document: Document,
  stroke: DisplacingStroke,
  { at }: Press,
  last: Place | null,
  context: ToolContext,
): Outcome {
  const [found] = context.layerUnder([at]);
  const rest = found?.rest ?? at;
  const now = add(rest, displacementAt(stroke.field, rest));
  const { radius } = stroke.brush;
  const goesOn = last && distance(last.moved, now) <= 2 * distance(last.at, at) + JUMP * radius;
  const led = ledDisplacing(stroke, goesOn ? last.moved : null, now);
  return outcome(displacing(document, led, { at, moved: now }), {
    type: 'edit',
    document: { ...document, project: withDisplacing(led) },
    stopped: led.stopped,
  });
}
