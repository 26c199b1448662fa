/** Axis-parallel boxes: of a drag over empty space, of what can be seen. */
import type { Vec } from './vec';

export interface Box {
  readonly min: Vec;
  readonly max: Vec;
}

/** The box between two opposite corners, in whatever order they come. */
export const boxBetween = (a: Vec, b: Vec): Box => ({
  min: [Math.min(a[0], b[0]), Math.min(a[1], b[1])],
  max: [Math.max(a[0], b[0]), Math.max(a[1], b[1])],
});

export const boxContains = ({ min, max }: Box, p: Vec): boolean =>
  p[0] >= min[0] && p[0] <= max[0] && p[1] >= min[1] && p[1] <= max[1];

/** Between which shares of the way from `a` to `b` it is in the box; null where it never is (Liang and Barsky 1984). */
export function sharesInside({ min, max }: Box, a: Vec, b: Vec): readonly [number, number] | null {
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
