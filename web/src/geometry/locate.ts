/**
 * From the posed picture back to rest: which point of the original lies under the pointer, and how the picture is
 * turned there. And from rest to the posed picture, for the places of single points in every frame.
 *
 * Within a triangle the map is affine, so its inverse is exact. Triangles are searched from the last drawn to the
 * first, which finds the visible one where the picture overlaps itself. Cost: linear in the triangles.
 */
import { type Blend, posedVertex } from './blend';
import type { Skin } from './skin';
import type { Vec } from './vec';

export interface Located {
  readonly rest: Vec;
  /** The rotation (degrees) and scale of the similarity nearest to the map at that point. */
  readonly rotation: number;
  readonly scale: number;
}

/** The rest point that `posed` takes to `at`, or null beside the picture. `skin.triangles` are in drawing order. */
export function locate(skin: Skin, posed: Float32Array, at: Vec): Located | null {
  return found(skin.triangles, posed, at, (vertex) => corner(skin.positions, vertex));
}

/**
 * Where `motions` take the point `at` of the original, or null beside the picture; `rotation` and `scale` are those of
 * the way back. Blends three vertices alone.
 */
export function locatePosed(skin: Skin, motions: Float32Array | null, blend: Blend, at: Vec): Located | null {
  return found(skin.triangles, skin.positions, at, (vertex) => posedVertex(skin, motions, blend, vertex));
}

/** Searches the triangles of `points` for the one around `at`; `there` is where each of its corners goes. */
function found(
  triangles: Uint32Array,
  points: Float32Array,
  at: Vec,
  there: (vertex: number) => Vec,
): Located | null {
  for (
    let index = nextNear(triangles, points, at, 0);
    index >= 0;
    index = nextNear(triangles, points, at, 0, index)
  ) {
    const here = cornersOf(points, triangles, index);
    const shares = barycentric(...here, at);
    if (!shares) continue;
    const vertex = (k: number) => there(triangles[index + k] ?? 0);
    const corners: Triangle = [vertex(0), vertex(1), vertex(2)];
    return { rest: mixed(corners, shares), ...nearestSimilarity(corners, here) };
  }
  return null;
}

/**
 * Like {@link locate}, but beside the picture extrapolates from a triangle at the vertex nearest to `at`. Null for a
 * mesh without triangles. Cost: linear in the triangles.
 */
export function locateNear(skin: Skin, posed: Float32Array, at: Vec): Located | null {
  const inside = locate(skin, posed, at);
  if (inside) return inside;
  let [best, least] = [-1, Number.POSITIVE_INFINITY];
  skin.triangles.forEach((vertex, index) => {
    const away = (at[0] - (posed[2 * vertex] ?? 0)) ** 2 + (at[1] - (posed[2 * vertex + 1] ?? 0)) ** 2;
    if (away < least) [best, least] = [index, away];
  });
  if (best < 0) return null;
  const first = best - (best % 3);
  const of = (points: Float32Array) => cornersOf(points, skin.triangles, first);
  const vertex = skin.triangles[best] ?? 0;
  const motion = nearestSimilarity(of(skin.positions), of(posed));
  const scale = Math.max(motion.scale, Number.EPSILON);
  const turn = (-motion.rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(turn) / scale, Math.sin(turn) / scale];
  const [from, to] = [corner(skin.positions, vertex), corner(posed, vertex)];
  const [dx, dy] = [at[0] - to[0], at[1] - to[1]];
  return { ...motion, rest: [from[0] + cos * dx - sin * dy, from[1] + sin * dx + cos * dy] };
}

export type Triangle = readonly [Vec, Vec, Vec];
/** What each corner of a triangle has of a place in it; in sum 1. */
export type Shares = readonly [number, number, number];

/**
 * The index of the triangle, of those drawn before the one at `before`, that is drawn last among the ones whose box is no
 * farther than `slack` from a place; negative where there is none. Rules out nearly every triangle, without a list of them.
 */
export function nextNear(
  triangles: Uint32Array,
  points: Float32Array,
  [x, y]: Vec,
  slack: number,
  before = triangles.length,
): number {
  let index = before - 3;
  for (; index >= 0; index -= 3) {
    const a = triangles[index] ?? 0;
    const b = triangles[index + 1] ?? 0;
    const c = triangles[index + 2] ?? 0;
    if (isBeside(points[2 * a], points[2 * b], points[2 * c], x, slack)) continue;
    if (!isBeside(points[2 * a + 1], points[2 * b + 1], points[2 * c + 1], y, slack)) break;
  }
  return index;
}

/** Whether a coordinate is farther than `slack` beyond those of all corners. */
const isBeside = (p = 0, q = 0, r = 0, at: number, slack: number): boolean =>
  (p < at - slack && q < at - slack && r < at - slack) ||
  (p > at + slack && q > at + slack && r > at + slack);

/** The corners of the triangle at an index. */
export const cornersOf = (points: Float32Array, triangles: Uint32Array, index: number): Triangle => [
  corner(points, triangles[index] ?? 0),
  corner(points, triangles[index + 1] ?? 0),
  corner(points, triangles[index + 2] ?? 0),
];

const corner = (points: Float32Array, index: number): Vec => [
  points[2 * index] ?? 0,
  points[2 * index + 1] ?? 0,
];

export const mixed = ([p, q, r]: Triangle, [u, v, w]: Shares): Vec => [
  u * p[0] + v * q[0] + w * r[0],
  u * p[1] + v * q[1] + w * r[1],
];

/** Barycentric coordinates of `p`, in either orientation; null outside the triangle, or where its area is 0. */
export function barycentric(a: Vec, b: Vec, c: Vec, p: Vec): Shares | null {
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (area === 0) return null;
  const u = ((b[0] - p[0]) * (c[1] - p[1]) - (c[0] - p[0]) * (b[1] - p[1])) / area;
  const v = ((c[0] - p[0]) * (a[1] - p[1]) - (a[0] - p[0]) * (c[1] - p[1])) / area;
  const w = 1 - u - v;
  return u >= 0 && v >= 0 && w >= 0 ? [u, v, w] : null;
}

/** The similarity [a −b; b a] nearest to the triangle's affine map J: a = (J₁₁ + J₂₂)/2, b = (J₂₁ − J₁₂)/2. */
export function nearestSimilarity(
  [p, q, r]: Triangle,
  [s, t, u]: Triangle,
): { rotation: number; scale: number } {
  const area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  if (area === 0) return { rotation: 0, scale: 1 };
  const column = (axis: 0 | 1): Vec => {
    const [along, across] = [t[axis] - s[axis], u[axis] - s[axis]];
    return [
      (along * (r[1] - p[1]) - across * (q[1] - p[1])) / area,
      (across * (q[0] - p[0]) - along * (r[0] - p[0])) / area,
    ];
  };
  const [j11, j12] = column(0);
  const [j21, j22] = column(1);
  const a = (j11 + j22) / 2;
  const b = (j21 - j12) / 2;
  return { rotation: (Math.atan2(b, a) * 180) / Math.PI, scale: Math.hypot(a, b) };
}
