/** Answers about many points of a solution. */

/** A solution's mesh in a pose. */
export interface PosedMesh {
  /** Vertices × 2, in the order of the solution's vertices. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Triangles × 3 vertices, in drawing order. */
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** Triangles × 3 vertices: those over the domain that the pose turns over, as the report counts them. */
  readonly folds: Uint32Array<ArrayBuffer>;
}

/** Weights above 0 in rows, one row a point. Points outside the domain have no value. */
export interface PointWeights {
  /** Points + 1: point p has the entries `offsets[p]` to `offsets[p + 1]` of `sites` and `weights`. */
  readonly offsets: Uint32Array<ArrayBuffer>;
  /** Entries: index of a site, ascending in each row. */
  readonly sites: Uint32Array<ArrayBuffer>;
  /** Entries: weight of that site. */
  readonly weights: Float64Array<ArrayBuffer>;
}
