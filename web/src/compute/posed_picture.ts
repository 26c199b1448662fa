/**
 * A solved picture that answers where its parts go in a pose.
 *
 * Only types: they import neither the DOM nor the module, so that pure code can name them. A picture belongs to one
 * solution and never changes. Every query depends only on its arguments; the module caches the pose of the last query.
 * Places are image pixels, angles degrees.
 */
import type { HiddenCorners, Turns } from '../document/handle';
import type { Clip, Project } from '../document/project';
import type { Shape } from '../document/shape';
import type { Box } from '../geometry/box';
import type { Crease } from '../geometry/crease';
import type { LocatedPoint, MappedPoint, Placement } from '../geometry/place';
import type { Places } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import type { CellBorders } from './solution';

/** The mesh and the weights of one solution. Holds memory of the module until {@link PosedPicture.free}. */
export interface PosedPicture {
  /**
   * The picture posed as in a project, and as stiff. Handles of the solution that the project lacks, or has with other
   * corners, keep the pose that they were solved with. Handles that are not solved yet move nothing.
   * @param before The frame before in a drag, which the pose continues. Without it, the project decides alone.
   * @throws C2WarpError if no such pose exists, such as a bar of no length. Show the last pose then.
   */
  pose(project: Project, before?: Pose): Pose;

  /** The pose of the same project in which a drag comes to rest. */
  settled(pose: Pose): Pose;

  /**
   * The picture along a clip. Handles without a track keep their pose in `project`.
   * @throws C2WarpError for a clip that does not fit the handles.
   */
  playback(clip: Clip, project: Project): Playback;

  /** Ids of the handles that force the visible creases of a pose, from the one that forces most. */
  forcing(project: Project): readonly string[];

  /**
   * The nearest pose without visible creases, within 2⁻⁸ of the way from `last`, an earlier pose without, or from rest.
   * Null if there is none.
   */
  unfolded(project: Project, last: Project | null): Project | null;

  /** The number of triangles in the visible creases of a pose; infinite if no such pose exists. */
  foldCount(project: Project): number;

  /**
   * Finds the last pose on the path from `from` with at most `allowed` triangles in visible creases. The
   * search is exact to 2⁻⁸ of the path. Handles move in straight lines and rotate at a constant rate. The
   * search assumes that `from` is allowed, and continues from it.
   */
  foldLimit(from: Pose, to: Project, allowed: number): LimitedPose;

  /** Like {@link foldLimit}, for handles that turn and scale together about one centre. */
  groupFoldLimit(from: Pose, way: GroupWay, allowed: number): LimitedPose;

  /**
   * Vertices: how far each follows a move of the selected handles from a pose. 1 moves as far as they do, 0 stays.
   * Null if the solution lacks them.
   * @throws C2WarpError if no such pose exists.
   */
  reach(pose: Pose, selection: readonly string[]): Float32Array<ArrayBuffer> | null;

  /** Vertices: the number of sites that move each, as a fraction of `MOST_COVERAGE`. Always the same array. */
  coverage(): Float32Array<ArrayBuffer>;

  /** Vertices: how stiff a project makes each, from 0 to 1. The same array for the same stiff places. */
  stiffness(project: Project): Float32Array<ArrayBuffer>;

  /** The bounding box at rest, without the rim; null without vertices. */
  restBounds(): Box | null;

  /** Pieces × 2 ends × 2: the outline of the bending part at rest. Always the same array. */
  restOutline(): Float32Array<ArrayBuffer>;

  /** Whether a point of the original bends. The rim that is drawn around it does not. */
  bends(rest: Vec): boolean;

  /** Bytes of the module's memory that the picture takes. */
  readonly bytes: number;

  /** Releases the module's memory. No query may follow. */
  free(): void;
}

/**
 * A picture along a clip, without the jumps of the rigid mode between frames. Poses depend only on the time, so
 * scrubbing and playing show the same frames. Where nothing jumps, they come to rest in those of the handles. Holds
 * memory of the module until {@link Playback.free}.
 */
export interface Playback {
  /**
   * The pose at any time in seconds. A time later than all before takes a pose for each sixtieth of a second up to it.
   * @param project The project with its handles posed as at that time. The pose answers for it.
   * @throws C2WarpError if no such pose exists.
   */
  pose(project: Project, time: number): Pose;

  /** Releases the module's memory. No pose of it may be asked anything after that. */
  free(): void;
}

/** One pose of a {@link PosedPicture}. Queries are computed at first use. */
export interface Pose {
  /** The project that was posed. */
  readonly project: Project;
  /** Sites × 12 for the graphics card, see `MOTION_STRIDE`. */
  readonly motions: Float32Array<ArrayBuffer>;
  /** Null where the brush has moved nothing. */
  readonly places: Places | null;
  /** Triangles × 3 in drawing order. Poses of the same order return the same array. */
  readonly triangles: Uint32Array;
  /** Vertices × 2: the posed mesh. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** The turn of each automatic handle, rounded as in the document. */
  readonly turns: Turns;
  /** Where the picture is visibly turned over, from the largest. */
  readonly creases: readonly Crease[];
  /** For each handle, which of its corners lie behind another part of the picture. */
  readonly hidden: HiddenCorners;

  /** The shape for the project file; undefined if the handles alone determine the pose. */
  shape(): Shape | undefined;
  /** Triangles × 3: those of the creases. */
  creasedTriangles(): Uint32Array<ArrayBuffer>;
  /** Where a point of the original goes; null outside the mesh. */
  map(rest: Vec): MappedPoint | null;
  /** Points × 2: where points of the original go, or NaN outside the mesh. One walk over the mesh finds all. */
  mapPoints(rest: Float64Array): Float64Array;
  /** Points × 2: the points of the original that are drawn at places, or NaN beside the picture. */
  locatePoints(posed: Float64Array): Float64Array;
  /** The point of the original that is drawn at a place; null beside the picture. */
  locate(posed: Vec): LocatedPoint | null;
  /**
   * The points of the original under the corners of a drawing, all on the layer of the first one. Beside the picture
   * its nearest part continues. Null without triangles.
   */
  layerUnder(corners: readonly Vec[]): readonly LocatedPoint[] | null;
  /** The box around all places where one part of the picture is drawn over another; null if there are none. */
  crossed(): Box | null;
  /**
   * How the parts that some handles move lie to the parts that they cross. Negative is behind one of them, 0 is level
   * with one of them, positive is in front of all.
   */
  lead(ids: readonly string[]): number;
  /** Where a handle can be placed: at a place, or at the nearest one that bends, at most `within` away. */
  placement(posed: Vec, within: number): Placement | null;
  /** The posed course of lines at rest, at places no farther apart than `step` at rest. */
  lines(rest: readonly (readonly Vec[])[], step: number): readonly (readonly Vec[])[];
  /** The bounding box of the posed picture and its static background, without the rim; null without vertices. */
  bounds(): Box | null;
  /** Pieces × 2 ends × 2: the outline of the bending part, posed. */
  outline(): Float32Array<ArrayBuffer>;
  /** Pieces × 2 ends × 2: the borders between cells, posed. */
  borders(borders: CellBorders): Float32Array<ArrayBuffer>;
}

/** The way of handles that turn and scale together. All else is as in `to`. */
export interface GroupWay {
  /** The project before anything was turned or scaled. */
  readonly origin: Project;
  /** Ids of the handles that turn and scale. */
  readonly selection: readonly string[];
  readonly to: Project;
  /** Turn in degrees and scale of the group, from `origin`: the allowed one, and the wanted one. */
  readonly start: GroupPose;
  readonly end: GroupPose;
}

export interface GroupPose {
  readonly turn: number;
  readonly scale: number;
}

/** How far handles can go. */
export interface LimitedPose {
  /** The wanted project itself if all of the way is allowed. */
  readonly project: Project;
  /** Of the way: 0 is its start, 1 its end. */
  readonly fraction: number;
}
