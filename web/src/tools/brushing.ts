/**
 * Strokes of a brush: a whole drag is one undo step.
 *
 * A brush works on the posed picture: each place of the pointer is led back to the place of the original under it.
 */

import type { Document } from '../document/document';
import type { Project } from '../document/project';
import { distance, type Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';
import { type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/** A step of more radii than this, beyond the step of the pointer, leads to another part of the picture. */
const JUMP = 1;

/** How a kind of brush makes a stroke. */
export interface Brushing<S> {
  /** Image pixels. */
  readonly radius: number;
  /** The place that the stroke goes to, for a place of the original under the pointer. */
  place(stroke: S, rest: Vec): Vec;
  /** The stroke, led on between two places; from null it begins there. */
  led(stroke: S, from: Vec | null, to: Vec): S;
  /** The project after the stroke, and whether the guard has stopped it at a fold. */
  edited(stroke: S): { readonly project: Project; readonly stopped?: boolean };
}

interface Last {
  /** Of the pointer, and of the stroke. */
  readonly at: Vec;
  readonly place: Vec;
}

/** Begins a stroke at a press. */
export function stroked<S>(
  press: Press,
  stroke: S,
  kind: Brushing<S>,
  label: Wording,
  context: ToolContext,
): Outcome {
  const begun = ledTo(context.document, stroke, kind, press, null, context);
  return outcome(begun.next, { type: 'begin', label }, ...begun.effects);
}

const brushing = <S>(document: Document, stroke: S, kind: Brushing<S>, last: Last): State => ({
  move: (press, context) => ledTo(document, stroke, kind, press, last, context),
  up: () => outcome(ENDED, { type: 'commit' }),
  cancel: () => outcome(ENDED, { type: 'bail' }),
});

/** The tool returns to the state between presses. */
const ENDED: State = {};

/** Leads the stroke on to a press. */
function ledTo<S>(
  document: Document,
  stroke: S,
  kind: Brushing<S>,
  { at }: Press,
  last: Last | null,
  context: ToolContext,
): Outcome {
  const [found] = context.layerUnder([at]);
  const place = kind.place(stroke, found?.rest ?? at);
  const goesOn = last && distance(last.place, place) <= 2 * distance(last.at, at) + JUMP * kind.radius;
  const led = kind.led(stroke, goesOn ? last.place : null, place);
  const { project, ...told } = kind.edited(led);
  return outcome(brushing(document, led, kind, { at, place }), {
    type: 'edit',
    document: { ...document, project },
    ...told,
  });
}
