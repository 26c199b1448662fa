/**
 * Dotted lines. Only the part on the stage is drawn. A hidden dot costs as much as a visible one, and at high zoom
 * a bar has thousands.
 */
import { type SVGTemplateResult, svg } from 'lit-html';
import { fractionsInside } from '../geometry/box';
import type { Size } from '../geometry/camera';
import { edgesOf } from '../geometry/polyline';
import { distance, lerp, type Vec } from '../geometry/vec';

/** From dot to dot, CSS pixels. */
const SPACING = 6.5;
/** Length of a dot without its round caps, CSS pixels. */
const DOT = 0.5;
/** More than half the width of a dot, CSS pixels. */
const ROOM = 4;

/** A dotted line along a path that is {@link onStage}. */
export const dots = (kind: string, path: string): SVGTemplateResult =>
  svg`<path class=${kind} stroke-dasharray="${DOT} ${SPACING - DOT}" d=${path}/>`;

/**
 * The visible parts of the edges. Each begins a whole number of dots from its corner, so that panning does not shift
 * the dots.
 */
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
