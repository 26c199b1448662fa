/** Axis-aligned boxes: of a drag over empty space, of the visible area, of the posed picture. */
import type { Vec } from './vec';

export interface Box {
  readonly min: Vec;
  readonly max: Vec;
}

/** Returns the box with two opposite corners, in any order. */
export const boxBetween = (a: Vec, b: Vec): Box => ({
  min: [Math.min(a[0], b[0]), Math.min(a[1], b[1])],
  max: [Math.max(a[0], b[0]), Math.max(a[1], b[1])],
});

/** Returns the smallest box around two boxes. */
export const boxOfBoth = (a: Box, b: Box): Box => ({
  min: [Math.min(a.min[0], b.min[0]), Math.min(a.min[1], b.min[1])],
  max: [Math.max(a.max[0], b.max[0]), Math.max(a.max[1], b.max[1])],
});

/** Whether `box` extends beyond the other box by more than `slack` on any side. */
export const reachesBeyond = (box: Box, { min, max }: Box, slack: number): boolean =>
  box.min[0] < min[0] - slack ||
  box.min[1] < min[1] - slack ||
  box.max[0] > max[0] + slack ||
  box.max[1] > max[1] + slack;

export const boxContains = ({ min, max }: Box, p: Vec): boolean =>
  p[0] >= min[0] && p[0] <= max[0] && p[1] >= min[1] && p[1] <= max[1];

/**
 * Clips the segment from `a` to `b` to a box (Liang and Barsky 1984). Returns the start and end of the part inside, as
 * fractions of the segment, or `null` if the segment misses the box.
 */
export function fractionsInside({ min, max }: Box, a: Vec, b: Vec): readonly [number, number] | null {
  let [from, to] = [0, 1];
  for (const axis of [0, 1] as const) {
    const along = b[axis] - a[axis];
    const [low, high] = [min[axis] - a[axis], max[axis] - a[axis]];
    if (along === 0 && (low > 0 || high < 0)) return null;
    if (along !== 0) {
      from = Math.max(from, Math.min(low / along, high / along));
      to = Math.min(to, Math.max(low / along, high / along));
    }
  }
  return from <= to ? [from, to] : null;
}
