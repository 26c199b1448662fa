/**
 * Dotted lines. A dot out of sight costs as much as any other, and at high zoom a bar has thousands of them: only the
 * part of a line that is on the stage is drawn.
 */
import { type SVGTemplateResult, svg } from 'lit';
import { fractionsInside } from '../geometry/box';
import type { Size } from '../geometry/camera';
import { edgesOf } from '../geometry/polyline';
import { distance, lerp, type Vec } from '../geometry/vec';

/** From dot to dot, CSS pixels. */
const SPACING = 6.5;
/** A dot with round caps is hardly longer than wide. */
const DOT = 0.5;
/** More than half the width of a dot, CSS pixels. */
const ROOM = 4;

/** A dotted line along a path that is {@link onStage}. */
export const dots = (kind: string, path: string): SVGTemplateResult =>
  svg`<path class=${kind} stroke-dasharray="${DOT} ${SPACING - DOT}" d=${path}/>`;

/** The visible parts of the edges. Each begins a whole number of dots from its corner: dots stay in place in a pan. */
export function onStage(corners: readonly Vec[], closed: boolean, { width, height }: Size): string {
  const box = { min: [-ROOM, -ROOM], max: [width + ROOM, height + ROOM] } as const;
  return edgesOf(corners, closed)
    .map(([a, b]) => {
      const fractions = fractionsInside(box, a, b);
      if (!fractions) return '';
      const [from, to] = fractions;
      const spacing = SPACING / Math.max(SPACING, distance(a, b));
      return `M${lerp(a, b, Math.floor(from / spacing) * spacing)}L${lerp(a, b, to)}`;
    })
    .join('');
}
