/** A rig for game engines: the figures for its size and its errors. */

export type EngineFormat = 'spine' | 'dragonbones' | 'gltf' | 'godot';

/** Distances from exact positions, in pixels: the largest, and that of 99 of 100 places. */
export type Errors = readonly [largest: number, percentile99: number];

/** The size of a rig, and its loss. */
export interface EngineLoss {
  readonly bones: number;
  readonly sites: number;
  readonly vertices: number;
  /** Vertices in the project's pose, in random poses, and in each clip. */
  readonly pose: Errors;
  readonly random: Errors;
  readonly clips: readonly Errors[];
  /** The picture between vertices. */
  readonly between: Errors;
}
