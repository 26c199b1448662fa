/**
 * Dotted lines. A dot out of sight costs as much as any other, and at high zoom a bar has thousands of them: only the
 * part of a line that is on the stage is drawn.
 */
import { type SVGTemplateResult, svg } from 'lit';
import { sharesInside } from '../geometry/box';
import type { Size } from '../geometry/camera';
import { edgesOf } from '../geometry/polyline';
import { between, distance, type Vec } from '../geometry/vec';

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
      const shares = sharesInside(box, a, b);
      if (!shares) return '';
      const [from, to] = shares;
      const spacing = SPACING / Math.max(SPACING, distance(a, b));
      return `M${between(a, b, Math.floor(from / spacing) * spacing)}L${between(a, b, to)}`;
    })
    .join('');
}
