/**
 * Where a handle can be placed under the pointer: on what bends. The rim around it, which soft edges are drawn on, holds
 * none.
 */
import { barycentric, corner, isBeside, type Located, nearestSimilarity, type Triangle } from './locate';
import { nearestPlace } from './polyline';
import type { Skin } from './skin';
import { distance, type Vec } from './vec';

/** A place of the posed picture, and what lies there. */
export interface Spot extends Located {
  readonly at: Vec;
}

type Three = readonly [number, number, number];

/** What each corner has of a place on the border of its triangle: far enough inside that rounding does not lead out. */
const INWARDS = 0.05;

/**
 * The spot at a place; in the rim, and up to `within` beside the picture, the nearest one. Of the skin the first `samples`
 * vertices bend. Cost: linear in the triangles.
 */
export function spotAt(
  skin: Skin,
  samples: number,
  posed: Float32Array,
  at: Vec,
  within: number,
): Spot | null {
  const bends = (vertices: Three) => vertices.every((vertex) => vertex < samples);
  const posedOf = (vertices: Three) => cornersOf(posed, vertices);
  const rim = trianglesNear(skin, posed, at, 0).filter(
    (vertices) => !bends(vertices) && barycentric(...posedOf(vertices), at),
  );
  // The first corner of every triangle is a sample.
  const reach = Math.max(within, ...rim.map((vertices) => distance(at, posedOf(vertices)[0])));
  const spots = trianglesNear(skin, posed, at, reach)
    .filter(bends)
    .map((vertices) => ({ vertices, ...nearestShares(posedOf(vertices), at) }))
    .filter(({ away }) => away <= reach);
  if (spots.length === 0) return null;
  const { vertices, shares, away } = spots.reduce((best, spot) => (spot.away < best.away ? spot : best));
  const [here, rest] = [posedOf(vertices), cornersOf(skin.positions, vertices)];
  return {
    at: away === 0 ? at : mixed(here, shares),
    rest: mixed(rest, shares),
    ...nearestSimilarity(rest, here),
  };
}

/** Vertices of the triangles whose box is no farther than `slack` from a place, the last drawn first. */
function trianglesNear(
  { triangles }: Skin,
  points: Float32Array,
  [x, y]: Vec,
  slack: number,
): readonly Three[] {
  const near: Three[] = [];
  for (let index = triangles.length - 3; index >= 0; index -= 3) {
    const a = triangles[index] ?? 0;
    const b = triangles[index + 1] ?? 0;
    const c = triangles[index + 2] ?? 0;
    if (isBeside(points[2 * a], points[2 * b], points[2 * c], x, slack)) continue;
    if (isBeside(points[2 * a + 1], points[2 * b + 1], points[2 * c + 1], y, slack)) continue;
    near.push([a, b, c]);
  }
  return near;
}

/** The shares that a triangle's corners have of its place nearest to a point, and how far that is `away`. */
function nearestShares(corners: Triangle, p: Vec): { readonly shares: Three; readonly away: number } {
  const inside = barycentric(...corners, p);
  if (inside) return { shares: inside, away: 0 };
  const { edge, share, away } = nearestPlace(corners, true, p);
  const of = (k: number) =>
    INWARDS + (1 - 3 * INWARDS) * (k === edge ? 1 - share : k === (edge + 1) % 3 ? share : 0);
  return { shares: [of(0), of(1), of(2)], away };
}

const cornersOf = (points: Float32Array, [a, b, c]: Three): Triangle => [
  corner(points, a),
  corner(points, b),
  corner(points, c),
];

const mixed = ([p, q, r]: Triangle, [u, v, w]: Three): Vec => [
  u * p[0] + v * q[0] + w * r[0],
  u * p[1] + v * q[1] + w * r[1],
];
