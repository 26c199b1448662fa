/** Points of the original at rest, paired with their positions in the posed picture. */
import type { Vec } from './vec';

/** The local turn and scale of the posed picture: the similarity nearest to the map from rest to pose. */
export interface LocalSimilarity {
  /** Degrees. */
  readonly rotation: number;
  readonly scale: number;
}

/** The point of the original that is drawn at a position of the posed picture. */
export interface LocatedPoint extends LocalSimilarity {
  readonly rest: Vec;
}

/** The posed position of a point of the original. */
export interface MappedPoint extends LocalSimilarity {
  readonly posed: Vec;
}

/** A position of the posed picture that can take a handle, with the point of the original there. */
export interface Placement extends LocatedPoint {
  readonly posed: Vec;
}
