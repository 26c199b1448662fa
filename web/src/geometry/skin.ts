/** The weighted mesh of a solution, and the layout of the motions that move it. */
import type { Vec } from './vec';

/** How the motions that reach a vertex are blended. */
export type Blend = 'linear' | 'rigid';

/** A mesh with sparse weights, as the solver returns it. */
export interface Skin {
  /** Vertices × 2, rest positions in image pixels. */
  readonly positions: Float32Array;
  /** Triangles × 3: vertices. The drawing order of a pose without depths or crossings. */
  readonly triangles: Uint32Array;
  /** Vertices + 1: vertex v has the entries `offsets[v]` to `offsets[v + 1]` of `sites` and `weights`. */
  readonly offsets: Uint32Array;
  /** Entries: index of a site. */
  readonly sites: Uint32Array;
  /** Entries: weight of that site. A vertex's weights sum to 1; a vertex without weights stays at rest. */
  readonly weights: Float32Array;
}

/** Where the brush has moved a skin before it is posed, image pixels. */
export interface Places {
  /** Vertices × 2. */
  readonly mesh: Float32Array;
  /** Vertices of the feather × 2. */
  readonly feather: Float32Array;
}

/**
 * Numbers per site in motions. The first four are the matrix a, b, c, d. The next four are rest x, rest y, posed x and
 * posed y. The last four are depth, angle θ, cos θ/2 and sin θ/2.
 */
export const MOTION_STRIDE = 12;

/** Returns the posed position of a site. */
export const sitePlace = (motions: Float32Array, site: number): Vec => [
  motions[MOTION_STRIDE * site + 6] ?? 0,
  motions[MOTION_STRIDE * site + 7] ?? 0,
];

/** Returns the turn of a site in degrees. */
export const siteTurn = (motions: Float32Array, site: number): number =>
  ((motions[MOTION_STRIDE * site + 9] ?? 0) * 180) / Math.PI;
