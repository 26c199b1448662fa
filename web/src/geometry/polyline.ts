/** Polylines, open or closed: edges, nearest places, points inside, turns. */
import { add, bearing, distance, lerp, midpoint, scaled, snapped, subtract, type Vec } from './vec';

/** The mean of the corners; the origin where there are no corners. */
export const centre = (corners: readonly Vec[]): Vec =>
  scaled(
    corners.reduce<Vec>((sum, p) => add(sum, p), [0, 0]),
    1 / Math.max(1, corners.length),
  );

/** The mean of the line itself: a corner that leaves it as it is does not move it. That of the corners without a length. */
export function middle(corners: readonly Vec[], closed: boolean): Vec {
  let [sum, length]: [Vec, number] = [[0, 0], 0];
  for (const [a, b] of edgesOf(corners, closed)) {
    const long = distance(a, b);
    sum = add(sum, scaled(midpoint(a, b), long));
    length += long;
  }
  return length > 0 ? scaled(sum, 1 / length) : centre(corners);
}

/** The edges, as pairs of corners: from each corner to the next; a closed line ends with the edge back to the first. */
export const edgesOf = (corners: readonly Vec[], closed: boolean): readonly (readonly [Vec, Vec])[] =>
  corners.flatMap((from, k) => {
    const to = corners[k + 1] ?? (closed ? corners[0] : undefined);
    return to ? [[from, to] as const] : [];
  });

/** A place on a line: the index of an edge in {@link edgesOf}, and the fraction of the way along that edge. */
export interface LinePlace {
  readonly edge: number;
  readonly fraction: number;
}

/** The place on the line nearest to a point, and its distance `away`, infinite where there is no edge. */
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

/** The distance from a point to the nearest place on the line. */
export const distanceToLine = (corners: readonly Vec[], closed: boolean, p: Vec): number =>
  nearestPlace(corners, closed, p).distance;

/** Whether a point lies inside the closed line, by the even-odd rule. */
export const isInside = (corners: readonly Vec[], [x, y]: Vec): boolean =>
  edgesOf(corners, true).filter(
    ([a, b]) => a[1] > y !== b[1] > y && x < a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]),
  ).length %
    2 ===
  1;

/**
 * The turn (degrees) that takes the corners of `rest` nearest to those of `posed`, both about their means: the least
 * squares turn, as in the solver. Null where no turn is better than another, because one of them has no extent.
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

/** `degrees` with whole turns added to be nearest to the angle `to`, in degrees. */
export const nearestTurn = (degrees: number, to: number): number =>
  degrees + 360 * Math.round((to - degrees) / 360);

/** `to`, projected onto the ray from `from` whose bearing is the nearest multiple of `step` degrees. */
export function constrained(from: Vec, to: Vec, step: number): Vec {
  const direction = (snapped(bearing(from, to), step) * Math.PI) / 180;
  const along: Vec = [Math.cos(direction), Math.sin(direction)];
  const [dx, dy] = subtract(to, from);
  return add(from, scaled(along, Math.max(0, along[0] * dx + along[1] * dy)));
}
