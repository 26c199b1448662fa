/** Files with numbers for other programs: maps of the warp, heat maps, and weights. */

export type MapName = 'inverse' | 'forward' | 'stretch' | 'disocclusion';

/** A map of the warp. */
export interface WarpMap {
  readonly what: 'map';
  readonly map: MapName;
  readonly format: 'exr' | 'png';
  /** Whether the map holds everything that is bent beyond the picture. */
  readonly grow: boolean;
}

/** The weight of a handle in colours over the picture. */
export interface HeatMap {
  readonly what: 'heat';
  readonly handle: string;
}

/** Weights at points of the picture. An array of all sites comes in a zip, with the list of sites. */
export interface WeightTable {
  readonly what: 'weights';
  /** Null for all sites. */
  readonly handle: string | null;
  /** Pixels from one point to the next. */
  readonly every: number;
  readonly format: 'npy' | 'csv';
}

export type MapFile = WarpMap | HeatMap | WeightTable;
