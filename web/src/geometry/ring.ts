/** Rings: closed polylines that bound an area. Clipping to a box, removal of curls, and intersection tests. */
import type { Box } from './box';
import { distanceToLine, edgesOf, isInside, lengthOf } from './polyline';
import { cross, distance, lerp, subtract, type Vec } from './vec';

export type Ring = readonly Vec[];

/** Closer points count as touching. Image pixels, more than rounding to hundredths moves a point. */
export const TOUCH = 0.05;

/** Returns the enclosed area in square pixels, by the shoelace formula. */
export const areaOf = (ring: Ring): number => Math.abs(signedAreaOf(ring));

/** The area of a ring that is drawn clockwise on the screen. Otherwise it is negative. */
export const signedAreaOf = (ring: Ring): number =>
  edgesOf(ring, true).reduce((sum, [a, b]) => sum + cross(a, b), 0) / 2;

/** Clips a ring to a box (Sutherland and Hodgman 1974). Separate parts are joined along the box. */
export function clipped(ring: Ring, { min, max }: Box): Ring {
  const limits = [
    [0, 1, min[0]],
    [1, 1, min[1]],
    [0, -1, max[0]],
    [1, -1, max[1]],
  ] as const;
  return limits.reduce<Ring>((part, [axis, sign, limit]) => {
    const isWithin = (p: Vec) => sign * (p[axis] - limit) >= 0;
    return edgesOf(part, true).flatMap(([a, b]) => [
      ...(isWithin(a) === isWithin(b) ? [] : [lerp(a, b, (limit - a[axis]) / (b[axis] - a[axis]))]),
      ...(isWithin(b) ? [b] : []),
    ]);
  }, ring);
}

/** Whether only neighbouring edges touch, each at its end. */
export function isSimple(ring: Ring): boolean {
  const edges = edgesOf(ring, true);
  return (
    ring.length > 2 &&
    ring.every((at, k) => {
      const [before, after] = [ring.at(k - 1) ?? at, ring[(k + 1) % ring.length] ?? at];
      return distance(before, at) >= TOUCH && !isNear(before, at, after) && !isNear(after, at, before);
    }) &&
    crossingsOf(edges).next().done === true
  );
}

interface Crossing {
  readonly at: Vec;
  /** The indices of the edges that meet there, in ascending order. */
  readonly edges: readonly [number, number];
}

/** Where edges of a ring cross or touch others than their neighbours. */
function* crossingsOf(edges: readonly Edge[]): Generator<Crossing> {
  for (const [i, edge] of edges.entries())
    for (let j = i + 2; j < edges.length - (i === 0 ? 1 : 0); j++) {
      const at = intersection(edge, edges[j] ?? edge);
      if (at) yield { at, edges: [i, j] };
    }
}

/**
 * Drops the curls of a line that a hand has drawn: loops of a length up to `most`. They are at turns, or where an end
 * overshoots the start.
 *
 * @param kept corners of the ring that stay in any case.
 */
export function withoutCurls(
  drawn: Ring,
  most: number,
  kept: ReadonlySet<Vec | undefined> = new Set(),
): Ring {
  let ring = drawn;
  for (;;) {
    const shorter = withoutCurl(ring, most, kept);
    if (!shorter) return ring;
    ring = shorter;
  }
}

function withoutCurl(ring: Ring, most: number, kept: ReadonlySet<Vec | undefined>): Ring | null {
  for (const { at, edges } of crossingsOf(edgesOf(ring, true))) {
    const [i, j] = edges;
    const [loop, rest] = [
      [at, ...ring.slice(i + 1, j + 1)],
      [...ring.slice(0, i + 1), at, ...ring.slice(j + 1)],
    ];
    const [short, long] = perimeterOf(loop) < perimeterOf(rest) ? [loop, rest] : [rest, loop];
    const isCurl = perimeterOf(short) <= most && !short.some((corner) => corner !== at && kept.has(corner));
    if (isCurl) return long;
  }
  return null;
}

const perimeterOf = (ring: Ring): number => lengthOf([...ring, ...ring.slice(0, 1)]);

/** Whether a line crosses or touches a ring. */
export const touches = (corners: readonly Vec[], closed: boolean, ring: Ring): boolean => {
  const edges = edgesOf(ring, true);
  return edgesOf(corners, closed).some((edge) => edges.some((other) => intersection(edge, other) !== null));
};

/** Whether one ring lies inside the other, or they touch. */
export const ringsMeet = (a: Ring, b: Ring): boolean =>
  isWithin(a, b) || isWithin(b, a) || touches(a, true, b);

/** Whether a ring lies inside another. The two must not touch. */
export const isWithin = ([first]: Ring, around: Ring): boolean =>
  first !== undefined && isInside(around, first);

/** The rings that lie in no other one. They must not touch. */
export const islandsOf = (rings: readonly Ring[]): readonly Ring[] =>
  rings.filter((ring) => !rings.some((other) => other !== ring && isWithin(ring, other)));

type Edge = readonly [Vec, Vec];

/** Returns a point where two edges cross or touch, or `null` if they do not. */
function intersection([a, b]: Edge, [c, d]: Edge): Vec | null {
  if (areSeparate(a, b, c, d, 0) || areSeparate(a, b, c, d, 1)) return null;
  if (isNear(c, d, a)) return a;
  if (isNear(c, d, b)) return b;
  if (isNear(a, b, c)) return c;
  if (isNear(a, b, d)) return d;
  const [one, other, gap] = [subtract(b, a), subtract(d, c), subtract(c, a)];
  const area = cross(one, other);
  const [s, t] = [cross(gap, other) / area, cross(gap, one) / area];
  return s > 0 && s < 1 && t > 0 && t < 1 ? lerp(a, b, s) : null;
}

/** Whether a point touches an edge. */
const isNear = (a: Vec, b: Vec, p: Vec): boolean => distanceToLine([a, b], false, p) < TOUCH;

/** Whether the extents of two edges along an axis are disjoint. This cheap test rules out nearly every pair. */
const areSeparate = (a: Vec, b: Vec, c: Vec, d: Vec, axis: 0 | 1): boolean =>
  Math.max(a[axis], b[axis]) + TOUCH < Math.min(c[axis], d[axis]) ||
  Math.max(c[axis], d[axis]) + TOUCH < Math.min(a[axis], b[axis]);

/** Whether a point lies inside the area of several rings, by the even-odd rule. */
export const isInsideOf = (rings: readonly Ring[], p: Vec): boolean =>
  rings.filter((ring) => isInside(ring, p)).length % 2 === 1;
