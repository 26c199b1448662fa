/** The brush that stiffens: it paints how stiff places of the original are, or erases that. */

import { type Brush, beginStroke, ledStroke, type Stroke, withStroke } from '../document/brush_stroke';
import { say } from '../texts/wording';
import { type Brushing, stroked } from './brushing';
import type { Outcome, Press, ToolContext } from './state';

export function stiffen(press: Press, own: Brush, context: ToolContext): Outcome {
  const begun = beginStroke(context.document.project, own);
  const kind: Brushing<Stroke> = {
    radius: own.radius,
    place: (_, rest) => rest,
    led: (stroke, from, to) => ledStroke(stroke, from ?? to, to),
    edited: (stroke) => ({ project: withStroke(stroke) }),
  };
  const label = say(own.erases ? 'steps.eraseStiffness' : 'steps.paintStiffness');
  return stroked(press, begun, kind, label, context);
}
