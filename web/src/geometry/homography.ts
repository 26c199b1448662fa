/**
 * Projective maps of the plane: the effect of any CSS transform on a flat element, including perspective.
 *
 * P. Heckbert, "Fundamentals of Texture Mapping and Image Warping" (1989), section 2.2.3.
 */
import type { Vec } from './vec';

/** A 3 × 3 matrix, row by row. It maps (x, y) to (u / w, v / w), where (u, v, w) is its product with (x, y, 1). */
export type Homography = readonly [
  ...u: readonly [number, number, number],
  ...v: readonly [number, number, number],
  ...w: readonly [number, number, number],
];

/** The images of (0, 0), (1, 0), (1, 1) and (0, 1). */
export type Quad = readonly [Vec, Vec, Vec, Vec];

/**
 * The least `w` of a mapped point. Points beyond the vanishing line have a negative one, and would jump to the opposite
 * side. They map far out on their own side instead.
 */
const LEAST_W = 1e-3;

export function mapped([a, b, c, d, e, f, g, h, i]: Homography, [x, y]: Vec): Vec {
  const w = Math.max(g * x + h * y + i, LEAST_W);
  return [(a * x + b * y + c) / w, (d * x + e * y + f) / w];
}

/** Maps the unit square onto a quad. Returns `null` if three of its corners lie on a line. */
export function squareToQuad([p, q, r, s]: Quad): Homography | null {
  const [ax, ay] = [q[0] - r[0], q[1] - r[1]];
  const [bx, by] = [s[0] - r[0], s[1] - r[1]];
  const [cx, cy] = [p[0] - q[0] + r[0] - s[0], p[1] - q[1] + r[1] - s[1]];
  const area = ax * by - bx * ay;
  if (!area) return null;
  const [g, h] = [(cx * by - bx * cy) / area, (ax * cy - cx * ay) / area];
  return [
    q[0] - p[0] + g * q[0],
    s[0] - p[0] + h * s[0],
    p[0],
    q[1] - p[1] + g * q[1],
    s[1] - p[1] + h * s[1],
    p[1],
    g,
    h,
    1,
  ];
}

/** Returns the inverse map, or `null` if there is none. */
export function inverted([a, b, c, d, e, f, g, h, i]: Homography): Homography | null {
  const [A, B, C] = [e * i - f * h, f * g - d * i, d * h - e * g];
  const det = a * A + b * B + c * C;
  if (!det) return null;
  return [
    A / det,
    (c * h - b * i) / det,
    (b * f - c * e) / det,
    B / det,
    (a * i - c * g) / det,
    (c * d - a * f) / det,
    C / det,
    (b * g - a * h) / det,
    (a * e - b * d) / det,
  ];
}
