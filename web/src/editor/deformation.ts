/**
 * The posed picture as geometry: the questions that the editor asks about one solution.
 *
 * Answers depend only on the arguments, so the editor stays pure. The runtime answers from the WebAssembly module,
 * tests from a plane. Places are image pixels, rotations degrees. A pose that the solver cannot compute, such as a bar
 * without length, gives the last answer again.
 */

import type { HiddenCorners, Turns } from '../document/handle';
import type { PosesAt } from '../document/moment';
import type { Clip, Project } from '../document/project';
import type { Shape } from '../document/shape';
import type { Box } from '../geometry/box';
import type { Crease } from '../geometry/crease';
import type { LocatedPoint, Placement } from '../geometry/place';
import type { Symmetry } from '../geometry/symmetry';
import type { Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';

/** The sites of a solution in one pose. */
export interface SiteGraph {
  /** Sites: index of the site's handle, −1 for a virtual site. */
  readonly handles: Int32Array;
  /** Edges × 2: sites whose cells touch. */
  readonly edges: Uint32Array;
  /** Sites × 2: posed positions. */
  readonly places: Float32Array;
}

/** The triangles of the creases. */
export interface CreasedMesh {
  /** Vertices × 2. */
  readonly posed: Float32Array;
  /** Triangles × 3. */
  readonly triangles: Uint32Array;
}

/** The borders between the cells of a solution: straight pieces, each within one triangle of its mesh. */
export interface CellBorders {
  /** Pieces × 3 vertices of the triangle. */
  readonly corners: Uint32Array<ArrayBuffer>;
  /** Pieces × 2 ends × 3 barycentric coordinates. */
  readonly barycentric: Float32Array<ArrayBuffer>;
}

/** How far handles can go. */
export interface LimitedPose {
  readonly project: Project;
  /** Of the way: 0 is its start, 1 its end. */
  readonly fraction: number;
}

/** The way of a group transform. Everything but the poses of the group is as in `to`. */
export interface GroupWay {
  /** The project that is shown: the way continues its pose. */
  readonly from: Project;
  /** The project before anything was turned or scaled. */
  readonly origin: Project;
  /** Ids of the handles in the group. */
  readonly selection: readonly string[];
  readonly to: Project;
  /** Turn in degrees and scale from `origin`: the allowed one, and the wanted one. */
  readonly start: { readonly turn: number; readonly scale: number };
  readonly end: { readonly turn: number; readonly scale: number };
}

/** The number of frames of a film, or why there can be no such film. */
export interface FrameCount {
  readonly frames: number;
  readonly refusal: Wording | null;
}

export interface Deformation {
  /** The shape in which a project comes to rest after a drag; undefined if its handles alone determine that. */
  shapeLeft(project: Project): Shape | undefined;
  /** The poses of handles at a time of a clip, in seconds. */
  posesAt: PosesAt;
  /** The frames of a clip, or of a part of it in seconds, at a rate in frames a second. */
  filmFrames(project: Project, clip: Clip, rate: number, range: readonly [number, number] | null): FrameCount;
  /** About the bounding box of all frames of a clip, or of a part of it in seconds. */
  filmBounds(project: Project, clip: Clip, range: readonly [number, number] | null): Box | null;
  /** Where a point handle can be placed: at `posed`, or at most `within` away on the nearest part that bends. */
  placement(project: Project, posed: Vec, within: number): Placement | null;
  /**
   * The points of the original under the corners of a drawing, all on the layer of the first one. Beside the picture
   * its nearest part continues.
   */
  layerUnder(project: Project, corners: readonly Vec[]): readonly LocatedPoint[];
  /** The turns of automatic handles. */
  turns(project: Project): Turns;
  /** The corners of handles that lie behind another part of the picture. */
  hidden(project: Project): HiddenCorners;
  /**
   * How the parts that some handles move lie to the parts that they cross. Negative is behind one of them, 0 is level
   * with one of them, positive is in front of all.
   */
  lead(project: Project, ids: readonly string[]): number;
  /** The sites and the edges between their cells. */
  siteGraph(project: Project): SiteGraph | null;
  /** Pieces × 2 ends × 2: where the pose puts the borders between cells. */
  posedBorders(project: Project, borders: CellBorders): Float32Array;
  /** The posed course of lines at rest, at places no farther apart than `step` at rest. */
  posedLines(project: Project, lines: readonly (readonly Vec[])[], step: number): readonly (readonly Vec[])[];
  /** Pieces × 2 ends × 2: the posed outline of the bending part. */
  outline(project: Project): Float32Array;
  /** The triangles that the pose visibly turns over; null if there are none. */
  creasedMesh(project: Project): CreasedMesh | null;
  /** The places where the pose visibly turns the picture over, from the largest. */
  creases(project: Project): readonly Crease[];
  /** Ids of the handles that force the visible creases, from the one that forces most. */
  forcing(project: Project): readonly string[];
  /**
   * The nearest pose without visible creases, on the way from an earlier one without or from rest. Of the handles only
   * those that force creases move, if that suffices. Null if there is none.
   */
  unfolded(project: Project, last: Project | null): Project | null;
  /** The number of triangles in visible creases; infinite for a pose that cannot be computed. */
  foldCount(project: Project): number;
  /**
   * The farthest pose on the way between two poses with at most `allowed` triangles in visible creases. Returns `to`
   * itself if all of the way is allowed. The pose of `from` counts as allowed.
   */
  foldLimit(from: Project, to: Project, allowed: number): LimitedPose;
  /** The same for handles that turn and scale together about one centre. */
  groupFoldLimit(way: GroupWay, allowed: number): LimitedPose;
  /** Bounding box of the posed picture; null for an empty mesh. */
  bounds(project: Project): Box | null;
  /** Bounding box of the bending part at rest. */
  restBounds(): Box | null;
  /** Pieces × 2 ends × 2: the outline of the bending part at rest. */
  restOutline(): Float32Array;
  /** The axes of symmetry of the bending part at rest. */
  symmetry(): Symmetry;
  /** Whether a point of the original is in the domain. */
  bends(rest: Vec): boolean;
}
