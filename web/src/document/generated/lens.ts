// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** The weights at a point, and the shortest paths to the handles. */
export interface Lens {
  /** The point at rest, in image pixels. */
  readonly at: readonly [number, number];
  /** The handles with a path to the point, in the order of the project. A held boundary comes last. */
  readonly shares: readonly Share[];
  /** The weights of all virtual sites together. */
  readonly virtual_weight: number;
  /** The sites with a weight, the heaviest first. */
  readonly sites: readonly LensSite[];
}

/** The share of one handle in the motion of a point. */
export interface Share {
  /** Index of the handle in the project; −2 for a held boundary. */
  readonly handle: number;
  /** The weights of its own sites together. */
  readonly weight: number;
  /** Its share through virtual sites: their weights times the harmonic fields of its sites. */
  readonly passed_on: number;
  /** Its site nearest to the point. */
  readonly site: number;
  /** Length of the shortest path from that site to the point, in pixels. */
  readonly distance: number;
  /** The vertices of that path, from the point to the site. */
  readonly path: readonly (readonly [number, number])[];
}

/** A site that moves the point. */
export interface LensSite {
  /** The index of the site. */
  readonly site: number;
  /** w_i at the point. */
  readonly weight: number;
  /** Intrinsic distance to the point, in pixels. */
  readonly distance: number;
}
