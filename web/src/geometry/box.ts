/** Axis-parallel boxes, as drawn by a drag over empty space. */
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
