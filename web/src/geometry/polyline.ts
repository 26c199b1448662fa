/** Open and closed polylines: edges, nearest points, point in polygon, best-fit turns. Cost: linear in the corners. */
import { add, bearing, distance, lerp, midpoint, scaled, snapped, subtract, type Vec } from './vec';

/** Returns the mean of the corners, or the origin without corners. */
export const centre = (corners: readonly Vec[]): Vec =>
  scaled(
    corners.reduce<Vec>((sum, p) => add(sum, p), [0, 0]),
    1 / Math.max(1, corners.length),
  );

/**
 * Returns the centroid of the line itself, or the mean of the corners if the length is 0. Extra corners on the line do
 * not move the centroid.
 */
export function lineCentroid(corners: readonly Vec[], closed: boolean): Vec {
  let [sum, length]: [Vec, number] = [[0, 0], 0];
  for (const [a, b] of edgesOf(corners, closed)) {
    const long = distance(a, b);
    sum = add(sum, scaled(midpoint(a, b), long));
    length += long;
  }
  return length > 0 ? scaled(sum, 1 / length) : centre(corners);
}

/** Returns the edges as pairs of corners. The last edge of a closed line leads back to the first corner. */
export const edgesOf = (corners: readonly Vec[], closed: boolean): readonly (readonly [Vec, Vec])[] =>
  corners.flatMap((from, k) => {
    const to = corners[k + 1] ?? (closed ? corners[0] : undefined);
    return to ? [[from, to] as const] : [];
  });

/** A point on a line: the index of an edge in {@link edgesOf}, and the fraction along the edge. */
export interface LinePlace {
  readonly edge: number;
  readonly fraction: number;
}

/** Returns the point of the line nearest to `p`, and its distance: infinite without edges. */
export function nearestPlace(
  corners: readonly Vec[],
  closed: boolean,
  p: Vec,
): LinePlace & { readonly distance: number } {
  let best = { edge: 0, fraction: 0, distance: Number.POSITIVE_INFINITY };
  for (const [edge, [a, b]] of edgesOf(corners, closed).entries()) {
    const [along, to] = [subtract(b, a), subtract(p, a)];
    const squared = along[0] ** 2 + along[1] ** 2;
    const foot = squared === 0 ? 0 : (along[0] * to[0] + along[1] * to[1]) / squared;
    const fraction = Math.min(1, Math.max(0, foot));
    const length = distance(p, lerp(a, b, fraction));
    if (length < best.distance) best = { edge, fraction, distance: length };
  }
  return best;
}

/** Returns the distance from `p` to the line. */
export const distanceToLine = (corners: readonly Vec[], closed: boolean, p: Vec): number =>
  nearestPlace(corners, closed, p).distance;

/** Whether a point lies inside a closed line, by the even-odd rule. */
export const isInside = (corners: readonly Vec[], [x, y]: Vec): boolean =>
  edgesOf(corners, true).filter(
    ([a, b]) => a[1] > y !== b[1] > y && x < a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]),
  ).length %
    2 ===
  1;

/**
 * Returns the least-squares turn in degrees from the corners of `rest` to those of `posed`, both about their means. The
 * solver fits turns alike. Returns `null` if one of the two has no extent, so that all turns fit equally.
 */
export function bestTurn(rest: readonly Vec[], posed: readonly Vec[]): number | null {
  const [from, to] = [centre(rest), centre(posed)];
  let [cos, sin] = [0, 0];
  rest.forEach((corner, k) => {
    const [a, b] = subtract(corner, from);
    const [c, d] = subtract(posed[k] ?? to, to);
    cos += a * c + b * d;
    sin += a * d - b * c;
  });
  return cos === 0 && sin === 0 ? null : (Math.atan2(sin, cos) * 180) / Math.PI;
}

/** Adds the number of whole turns to `degrees` that brings it nearest to `to`. */
export const nearestTurn = (degrees: number, to: number): number =>
  degrees + 360 * Math.round((to - degrees) / 360);

/** Projects `to` onto the ray from `from` with the nearest bearing that is a multiple of `step` degrees. */
export function constrained(from: Vec, to: Vec, step: number): Vec {
  const direction = (snapped(bearing(from, to), step) * Math.PI) / 180;
  const along: Vec = [Math.cos(direction), Math.sin(direction)];
  const [dx, dy] = subtract(to, from);
  return add(from, scaled(along, Math.max(0, along[0] * dx + along[1] * dy)));
}

/** The length of an open line. */
export const lengthOf = (corners: readonly Vec[]): number =>
  edgesOf(corners, false).reduce((sum, [a, b]) => sum + distance(a, b), 0);
