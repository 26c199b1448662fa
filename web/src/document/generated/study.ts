// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** A solution, explained. Points are in image pixels at rest, lengths in pixels. */
export interface Study {
  /** The rings of the domain. */
  readonly outline: readonly (readonly (readonly [number, number])[])[];
  /** The sites in the order of insertion. */
  readonly sites: readonly SiteStudy[];
  /** φ at even steps from 0 to 1. */
  readonly falloff: readonly number[];
  /** The rounds of Algorithm 1; empty without sites. */
  readonly rounds: readonly Round[];
  /** The score at or below which Algorithm 1 ends. */
  readonly allowed_score: number;
}

/** A site with its cell and its support. */
export interface SiteStudy {
  /** h_i: the rest position. */
  readonly rest: readonly [number, number];
  /** Index of the handle in the project; −1 for a virtual site, −2 for one of a held boundary. */
  readonly handle: number;
  /** r_d: distance of the farthest point of the cell. */
  readonly cell_radius: number;
  /** r_h: distance of the nearest other site. Null if the island has no other. */
  readonly separation: number | null;
  /** r_i: distance at which φ reaches zero. Null if the support has no end. */
  readonly support_radius: number | null;
  /** r_i for α = 0 and for α = 1; empty if the support has no end. */
  readonly support_range: readonly number[];
  /** The shortest path to the farthest point of the cell. */
  readonly to_farthest: readonly (readonly [number, number])[];
  /** The shortest path to the nearest other site; empty if a bar or a held boundary is nearer. */
  readonly to_nearest: readonly (readonly [number, number])[];
}

/** The state of Algorithm 1 before a round, and the points that the round inserts. The last round has no points. */
export interface Round {
  /** The score δ / r_d of the worst cell. Here δ is r_d minus the greatest allowed radius of the cell, instead of r_d − r_h. */
  readonly score: number;
  /** The number of sites before the round. The sites that it inserts follow them. */
  readonly sites: number;
  /** The farthest points of the worst cells. */
  readonly points: readonly RoundPoint[];
}

/** A point where a round divides a cell. */
export interface RoundPoint {
  /** The point, in image pixels. */
  readonly at: readonly [number, number];
  /** The site whose cell it divides. */
  readonly owner: number;
  /** Its distance from the owner, in pixels: the radius r_d of the cell if it is the farthest point. */
  readonly distance: number;
  /** The greatest allowed radius of the cell, in pixels. */
  readonly limit: number;
  /** The vertices of the shortest path from the owner to the point. */
  readonly path: readonly (readonly [number, number])[];
}
