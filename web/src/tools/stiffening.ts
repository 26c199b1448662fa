/**
 * The brush that stiffens: a drag paints how stiff the picture is, or erases that. A whole drag is one undo step.
 *
 * It paints on the posed picture: each place of the pointer is led back to the place of the original under it.
 */
import { type Brush, beginStroke, ledStroke, type Stroke, withStroke } from '../document/brush_stroke';
import type { Document } from '../document/document';
import { distance, type Vec } from '../geometry/vec';
import { type Outcome, outcome, type Press, type State, type ToolContext } from './state';

/** A step in the original of more radii than this, beyond the step of the pointer, leads to another part of it. */
const JUMP = 1;

export function stiffen(press: Press, own: Brush, context: ToolContext): Outcome {
  const { document } = context;
  const stroke = beginStroke(document.project, own);
  const begun = painted(document, stroke, press, null, context);
  const label = own.erases ? 'Erase stiffness' : 'Paint stiffness';
  return outcome(begun.next, { type: 'begin', label }, ...begun.effects);
}

/** The tool returns to the state between presses. */
const ENDED: State = {};

interface Place {
  /** Of the pointer, and of the original under it. */
  readonly at: Vec;
  readonly rest: Vec;
}

const painting = (document: Document, stroke: Stroke, last: Place): State => ({
  move: (press, context) => painted(document, stroke, press, last, context),
  up: () => outcome(ENDED, { type: 'commit' }),
  cancel: () => outcome(ENDED, { type: 'bail' }),
});

/** Leads the stroke on to a press. */
function painted(
  document: Document,
  stroke: Stroke,
  { at }: Press,
  last: Place | null,
  context: ToolContext,
): Outcome {
  const [found] = context.layerUnder([at]);
  const rest = found?.rest ?? at;
  const { radius } = stroke.brush;
  const goesOn = last && distance(last.rest, rest) <= 2 * distance(last.at, at) + JUMP * radius;
  const led = ledStroke(stroke, goesOn ? last.rest : rest, rest);
  return outcome(painting(document, led, { at, rest }), {
    type: 'edit',
    document: { ...document, project: withStroke(led) },
  });
}
