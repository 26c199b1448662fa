/** Lines through corners, open or closed: how far away they are, what lies inside, how they are turned. */
import { add, bearing, between, distance, scaled, snapped, subtract, type Vec } from './vec';

/** The mean of the corners; the origin where there are none. */
export const centre = (corners: readonly Vec[]): Vec =>
  scaled(
    corners.reduce<Vec>((sum, p) => add(sum, p), [0, 0]),
    1 / Math.max(1, corners.length),
  );

/** The edges, as pairs of corners: from each corner to the next, and at last, of a closed line, to the first. */
export const edgesOf = (corners: readonly Vec[], closed: boolean): readonly (readonly [Vec, Vec])[] =>
  corners.flatMap((from, k) => {
    const to = corners[k + 1] ?? (closed ? corners[0] : undefined);
    return to ? [[from, to] as const] : [];
  });

/** A place on a line: a share of the way along an edge, which are counted as {@link edgesOf} lists them. */
export interface LinePlace {
  readonly edge: number;
  readonly share: number;
}

/** The place of the line that is nearest to a point, and how far that is; infinitely far where there is no edge. */
export function nearestPlace(
  corners: readonly Vec[],
  closed: boolean,
  p: Vec,
): LinePlace & { readonly away: number } {
  let best = { edge: 0, share: 0, away: Number.POSITIVE_INFINITY };
  for (const [edge, [a, b]] of edgesOf(corners, closed).entries()) {
    const [along, to] = [subtract(b, a), subtract(p, a)];
    const squared = along[0] ** 2 + along[1] ** 2;
    const foot = squared === 0 ? 0 : (along[0] * to[0] + along[1] * to[1]) / squared;
    const share = Math.min(1, Math.max(0, foot));
    const away = distance(p, between(a, b, share));
    if (away < best.away) best = { edge, share, away };
  }
  return best;
}

/** From a point to the nearest place of the line. */
export const distanceToLine = (corners: readonly Vec[], closed: boolean, p: Vec): number =>
  nearestPlace(corners, closed, p).away;

/** By the even-odd rule. */
export const isInside = (corners: readonly Vec[], [x, y]: Vec): boolean =>
  edgesOf(corners, true).filter(
    ([a, b]) => a[1] > y !== b[1] > y && x < a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]),
  ).length %
    2 ===
  1;

/**
 * The turn (degrees) that takes the corners of `rest` nearest to those of `posed`, both about their means: the least
 * squares one, as the solver reads it. Null where there is none, because one of them has no extent.
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

/** The same direction, whole turns added until it is nearest to another angle. Degrees. */
export const nearestTurn = (degrees: number, to: number): number =>
  degrees + 360 * Math.round((to - degrees) / 360);

/** `to`, moved so that it is seen from `from` in a direction of whole steps. */
export function constrained(from: Vec, to: Vec, step: number): Vec {
  const direction = (snapped(bearing(from, to), step) * Math.PI) / 180;
  const along: Vec = [Math.cos(direction), Math.sin(direction)];
  const [dx, dy] = subtract(to, from);
  return add(from, scaled(along, Math.max(0, along[0] * dx + along[1] * dy)));
}
