/**
 * Where a handle can be placed under the pointer: on what bends. The skirt around it, which soft edges are drawn on, holds
 * none.
 */
import {
  barycentric,
  cornersOf,
  type Located,
  mixed,
  nearestSimilarity,
  nextNear,
  type Shares,
  type Triangle,
} from './locate';
import { nearestPlace } from './polyline';
import type { Skin } from './skin';
import { distance, type Vec } from './vec';

/** A place of the posed picture, and what lies there. */
export interface Spot extends Located {
  readonly at: Vec;
}

/** What each corner has of a place on the border of its triangle: far enough inside that rounding does not lead out. */
const INWARDS = 0.05;

/**
 * The spot at a place; in the skirt, and up to `within` beside the picture, the nearest one. Of the skin the first `samples`
 * vertices bend. Cost: linear in the triangles.
 */
export function spotAt(
  skin: Skin,
  samples: number,
  posed: Float32Array,
  at: Vec,
  within: number,
): Spot | null {
  const { positions, triangles } = skin;
  const bends = (index: number) => triangles.subarray(index, index + 3).every((vertex) => vertex < samples);
  const here = (index: number) => cornersOf(posed, triangles, index);
  const skirt = allNear(triangles, posed, at, 0).filter(
    (index) => !bends(index) && barycentric(...here(index), at),
  );
  // The first corner of every triangle is a sample.
  const reach = Math.max(within, ...skirt.map((index) => distance(at, here(index)[0])));
  const spots = allNear(triangles, posed, at, reach)
    .filter(bends)
    .map((index) => ({ index, ...nearestShares(here(index), at) }))
    .filter(({ away }) => away <= reach);
  if (spots.length === 0) return null;
  const { index, shares, away } = spots.reduce((best, spot) => (spot.away < best.away ? spot : best));
  const rest = cornersOf(positions, triangles, index);
  return {
    at: away === 0 ? at : mixed(here(index), shares),
    rest: mixed(rest, shares),
    ...nearestSimilarity(rest, here(index)),
  };
}

/** Every triangle whose box is no farther than `slack` from a place, by index, the last drawn first. */
function allNear(triangles: Uint32Array, points: Float32Array, at: Vec, slack: number): readonly number[] {
  const near: number[] = [];
  let index = nextNear(triangles, points, at, slack);
  for (; index >= 0; index = nextNear(triangles, points, at, slack, index)) near.push(index);
  return near;
}

/** The shares that a triangle's corners have of its place nearest to a point, and how far that is `away`. */
function nearestShares(corners: Triangle, p: Vec): { readonly shares: Shares; readonly away: number } {
  const inside = barycentric(...corners, p);
  if (inside) return { shares: inside, away: 0 };
  const { edge, fraction: share, distance: away } = nearestPlace(corners, true, p);
  const of = (k: number) =>
    INWARDS + (1 - 3 * INWARDS) * (k === edge ? 1 - share : k === (edge + 1) % 3 ? share : 0);
  return { shares: [of(0), of(1), of(2)], away };
}
