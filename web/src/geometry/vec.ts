/** Points and vectors in the plane, written as in the project file: `[x, y]`, image pixels, y down. */
export type Vec = readonly [x: number, y: number];

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1]];
export const subtract = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1]];
export const scaled = (a: Vec, factor: number): Vec => [a[0] * factor, a[1] * factor];
export const midpoint = (a: Vec, b: Vec): Vec => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
/** Interpolates linearly: `a` at fraction 0, `b` at fraction 1. */
export const lerp = (a: Vec, b: Vec, fraction: number): Vec => add(a, scaled(subtract(b, a), fraction));
/** Returns the cross product: positive if `b` lies clockwise of `a` on the screen. */
export const cross = (a: Vec, b: Vec): number => a[0] * b[1] - a[1] * b[0];
export const distance = (a: Vec, b: Vec): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Rotates a vector about the origin by degrees, clockwise on the screen. */
export function rotated([x, y]: Vec, degrees: number): Vec {
  const turn = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return [cos * x - sin * y, sin * x + cos * y];
}

/** Returns the direction from `from` to `to` in degrees, clockwise on the screen since y points down. */
export const bearing = (from: Vec, to: Vec): number =>
  (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;

/** Returns the same direction in (−180, 180]. */
export function wrapDegrees(degrees: number): number {
  const turned = degrees - 360 * Math.ceil((degrees - 180) / 360);
  return turned === 0 ? 0 : turned;
}

/** Returns the multiple of `step` nearest to `value`. */
export const snapped = (value: number, step: number): number => Math.round(value / step) * step;
