/** Rings, as closed lines are where they bound something: clipped to a box, rid of loops, and whether two of them meet. */
import type { Box } from './box';
import { edgesOf, isInside } from './polyline';
import { between, cross, subtract, type Vec } from './vec';

export type Ring = readonly Vec[];

/** The area inside, by the shoelace formula: square pixels. */
export const areaOf = (ring: Ring): number =>
  Math.abs(edgesOf(ring, true).reduce((sum, [a, b]) => sum + cross(a, b), 0)) / 2;

/** The part of a ring within a box (Sutherland and Hodgman 1974). Separate parts are joined along the box. */
export function clipped(ring: Ring, { min, max }: Box): Ring {
  const limits = [
    [0, 1, min[0]],
    [1, 1, min[1]],
    [0, -1, max[0]],
    [1, -1, max[1]],
  ] as const;
  return limits.reduce<Ring>((left, [axis, sign, limit]) => {
    const isWithin = (p: Vec) => sign * (p[axis] - limit) >= 0;
    return edgesOf(left, true).flatMap(([a, b]) => [
      ...(isWithin(a) === isWithin(b) ? [] : [between(a, b, (limit - a[axis]) / (b[axis] - a[axis]))]),
      ...(isWithin(b) ? [b] : []),
    ]);
  }, ring);
}

/**
 * The ring without crossing itself: where it does, the smaller of the two parts goes, such as what a hand draws beyond
 * the start. Cost: quadratic in the corners for each crossing.
 */
export function withoutLoops(ring: Ring): Ring {
  const edges = edgesOf(ring, true);
  for (const [i, edge] of edges.entries()) {
    for (let j = i + 2; j < edges.length; j++) {
      const at = crossing(edge, edges[j] ?? edge);
      if (!at) continue;
      const loop = [at, ...ring.slice(i + 1, j + 1)];
      const rest = [...ring.slice(0, i + 1), at, ...ring.slice(j + 1)];
      return withoutLoops(areaOf(loop) > areaOf(rest) ? loop : rest);
    }
  }
  return ring;
}

/** Whether a line crosses a ring. */
export const crosses = (corners: readonly Vec[], closed: boolean, ring: Ring): boolean => {
  const edges = edgesOf(ring, true);
  return edgesOf(corners, closed).some((edge) => edges.some((other) => crossing(edge, other) !== null));
};

/** Whether one ring lies inside the other, or they cross. */
export const meet = (a: Ring, b: Ring): boolean => isWithin(a, b) || isWithin(b, a) || crosses(a, true, b);

/** Whether a ring that does not cross another lies inside it. */
export const isWithin = ([first]: Ring, around: Ring): boolean =>
  first !== undefined && isInside(around, first);

type Edge = readonly [Vec, Vec];

/** Where two edges cross, not at an end of either; null where they do not. */
function crossing([a, b]: Edge, [c, d]: Edge): Vec | null {
  const [one, other, gap] = [subtract(b, a), subtract(d, c), subtract(c, a)];
  const area = cross(one, other);
  const [s, t] = [cross(gap, other) / area, cross(gap, one) / area];
  return s > 0 && s < 1 && t > 0 && t < 1 ? between(a, b, s) : null;
}
