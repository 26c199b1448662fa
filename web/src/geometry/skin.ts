/** A mesh that sites move, and their motions, as the solver and its poser hand them out. */
import type { Vec } from './vec';

/** A mesh with sparse weights, as the solver hands it out. */
export interface Skin {
  /** Vertices × 2, rest positions in image pixels. */
  readonly positions: Float32Array;
  /** Triangles × 3: vertices; the later covers the earlier, where all sites are equally deep. */
  readonly triangles: Uint32Array;
  /** Vertices + 1: vertex v has the entries `offsets[v]` to `offsets[v + 1]` of `sites` and `weights`. */
  readonly offsets: Uint32Array;
  /** Entries: index of a site. */
  readonly sites: Uint32Array;
  /** Entries: weight of that site. A vertex's weights sum to 1; a vertex without any stays at rest. */
  readonly weights: Float32Array;
}

/** Numbers per site in a motions array: a, b, c, d, rest x, rest y, posed x, posed y, depth, angle, cosine and sine of half of it. */
export const MOTION_STRIDE = 12;

/** Where a site is posed. */
export const sitePlace = (motions: Float32Array, site: number): Vec => [
  motions[MOTION_STRIDE * site + 6] ?? 0,
  motions[MOTION_STRIDE * site + 7] ?? 0,
];

/** How far a site is turned, degrees. */
export const siteTurn = (motions: Float32Array, site: number): number =>
  ((motions[MOTION_STRIDE * site + 9] ?? 0) * 180) / Math.PI;
