// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** The object of `c2warp inspect --json`. */
export interface Inspection {
  /** Samples of the domain. */
  readonly samples: number;
  /** Connected parts of the domain. */
  readonly islands: number;
  /** Holes of the domain. */
  readonly holes: number;
  /** Islands without a handle. */
  readonly loose_islands: number;
  /** Opaque regions too small to keep. */
  readonly specks: number;
  /** How closely the outline follows the picture. */
  readonly outline: OutlineDetail;
  /** Maximum width of a gap that the domain includes, in pixels. */
  readonly bridged_gap: number;
  /** Corners of the outline at which shortest paths may bend. */
  readonly reflex_corners: number;
  /** Point handles. */
  readonly point_handles: number;
  /** Bar handles. */
  readonly bar_handles: number;
  /** Polygon handles. */
  readonly polygon_handles: number;
  /** Parts of bars and polygons outside the domain. */
  readonly outside: readonly OutsidePart[];
  /** Sites of handles, and of a held boundary. */
  readonly real_sites: number;
  /** Sites that Algorithm 1 inserted. */
  readonly virtual_sites: number;
  /** The score δ / r_d of the worst cell before each round of Algorithm 1 (figure 3, right). Here δ is r_d minus the greatest allowed radius of the cell, instead of r_d − r_h. */
  readonly scores: readonly number[];
  /** Mean number of supports that contain a sample. */
  readonly cover_mean: number;
  /** Maximum number of supports that contain a sample. */
  readonly cover_max: number;
  /** Least Σφ over the samples of islands with handles. */
  readonly min_phi_sum: number;
  /** Flipped triangles of the posed mesh. */
  readonly folded_triangles: number;
  /** A hash of the samples' weights. It changes if any bit of them changes. */
  readonly weights_hash: string;
  /** The time of each stage. */
  readonly ms: StageTimes;
}

/** How closely the outline of a domain follows the picture. */
export type OutlineDetail = 'traced' | 'simplified' | 'bridged' | 'picture';

/** A part of a bar or polygon that lies outside the domain, or on its held boundary. It moves nothing. */
export interface OutsidePart {
  /** Id of the handle. */
  readonly handle: string;
  /** Start of the part at rest, in image pixels. */
  readonly from: readonly [number, number];
  /** End of the part at rest, in image pixels. */
  readonly to: readonly [number, number];
}

/** Milliseconds spent in each stage, and on a pose. The crate has no clock, so the caller measures them. */
export interface StageTimes {
  /** Time of the stage `domain`. */
  readonly domain: number;
  /** Time of the stage `sampling`. */
  readonly sampling: number;
  /** Time of the stage `regions`. */
  readonly regions: number;
  /** Time of the stage `weights`. */
  readonly weights: number;
  /** A pose: the motions of the sites. */
  readonly pose: number;
}

/** A stage of the solve. Between two stages a caller may decide to solve a newer project instead. */
export type Stage = 'domain' | 'sampling' | 'regions' | 'weights';
