/** Pairs of places: one of the original, at rest, and the one of the posed picture that it is drawn at. */
import type { Vec } from './vec';

/** How the posed picture is turned and scaled at a place: the similarity nearest to the map from rest to pose. */
export interface LocalSimilarity {
  /** Degrees. */
  readonly rotation: number;
  readonly scale: number;
}

/** The point of the original that lies at a place of the posed picture. */
export interface LocatedPoint extends LocalSimilarity {
  readonly rest: Vec;
}

/** The place of the posed picture that a point of the original goes to. */
export interface MappedPoint extends LocalSimilarity {
  readonly posed: Vec;
}

/** A place of the posed picture where a handle can be placed, and the point of the original there. */
export interface Placement extends LocatedPoint {
  readonly posed: Vec;
}
