/** The present pose of the picture, and lookups between places on it and in the original. */
import type { GroupWay, LimitedPose, Pose } from '../compute/posed_picture';
import type { CellBorders } from '../compute/solution';
import type { Document } from '../document/document';
import type { Turns } from '../document/handle';
import type { History } from '../document/history';
import type { Project } from '../document/project';
import { type Box, reachesBeyond } from '../geometry/box';
import type { LocatedPoint, MappedPoint, Placement } from '../geometry/place';
import type { Vec } from '../geometry/vec';
import type { FoldedMesh, SiteGraph } from '../ui/overlays';
import type { Solved, Solving } from './solving';

/** Image pixels beyond the frame that nobody misses; also covers rounding. */
const SLACK = 0.5;

const NO_TURNS: Turns = new Map();

export class Posing {
  readonly #history: History<Document>;
  readonly #solving: Solving;
  #solved: Solved | null = null;
  #project: Project | null = null;
  #pose: Pose | null = null;

  constructor(history: History<Document>, solving: Solving) {
    this.#history = history;
    this.#solving = solving;
  }

  /** Clears all cached values, for another solution. */
  forget(): void {
    this.#solved = null;
    this.#project = null;
    this.#pose = null;
  }

  /** The present pose; null without a solution. If there is no such pose, for example a bar of no length, the last one. */
  pose(): Pose | null {
    const { current } = this.#solving;
    const { project } = this.#history.present;
    if (current !== this.#solved) this.forget();
    if (!current || project === this.#project) return this.#pose;
    this.#solved = current;
    this.#project = project;
    try {
      this.#pose = current.posed.pose(project);
    } catch {
      this.#pose ??= current.posed.pose(current.project);
    }
    return this.#pose;
  }

  /** Turns of automatic handles: from their own sites, or from the picture around handles not solved yet. */
  turns(): Turns {
    return this.pose()?.turns ?? NO_TURNS;
  }

  /**
   * Where a handle can be placed on the posed picture: there, or at most `within` away. Without a solution the point of
   * the original is the place itself.
   */
  place(at: Vec, within: number): Placement | null {
    const { picture } = this.#solving;
    if (!picture) return null;
    const pose = this.pose();
    if (pose) return pose.placement(at, within);
    const inside = at[0] >= 0 && at[1] >= 0 && at[0] < picture.width && at[1] < picture.height;
    return inside ? { posed: at, rest: at, rotation: 0, scale: 1 } : null;
  }

  /** What lies at a place of the posed picture; beside it as if its nearest part continued there. */
  placeNear(at: Vec): LocatedPoint {
    return this.pose()?.locateNear(at) ?? { rest: at, rotation: 0, scale: 1 };
  }

  /** The number of triangles that the present pose turns over. */
  folds(): number {
    return this.pose()?.foldCount ?? 0;
  }

  /** `folds` for any pose, counted up to `limit` + 1; infinite if the solver cannot pose it. */
  foldsOf(project: Project, limit: number): number {
    return this.#solving.current?.posed.foldCount(project, limit) ?? 0;
  }

  /** How far handles go from one pose to another without more than the allowed folds. */
  foldLimit(from: Project, to: Project, allowed: number): LimitedPose {
    const limit = this.#solving.current?.posed.foldLimit(from, to, this.turns(), allowed);
    return limit ?? { project: to, fraction: 1 };
  }

  /** Like `foldLimit`, for handles that turn and scale together. */
  groupFoldLimit(way: GroupWay, allowed: number): LimitedPose {
    return this.#solving.current?.posed.groupFoldLimit(way, allowed) ?? { project: way.to, fraction: 1 };
  }

  /** The triangles that the present pose turns over; null if there are none. */
  folded(): FoldedMesh | null {
    const pose = this.pose();
    if (!pose || pose.foldCount === 0) return null;
    return { posed: pose.positions, triangles: pose.foldedTriangles() };
  }

  /** Bounding box of the posed picture without the skirt, image pixels; null without a solution. */
  bounds(): Box | null {
    return this.pose()?.bounds() ?? null;
  }

  /** Bounding box of what bends, at rest, image pixels; null without a solution. */
  restBounds(): Box | null {
    return this.#solving.current?.posed.restBounds() ?? null;
  }

  /** Whether part of the posed picture lies outside the picture's own rectangle. */
  beyond(): boolean {
    const { picture } = this.#solving;
    const bounds = this.bounds();
    if (!picture || !bounds) return false;
    return reachesBeyond(bounds, { min: [0, 0], max: [picture.width, picture.height] }, SLACK);
  }

  /** Where a point of the original is posed; null outside the warped area. */
  map(rest: Vec): MappedPoint | null {
    return this.pose()?.map(rest) ?? null;
  }

  /** Whether a point of the original is part of what bends, and not of the skirt around it. */
  bends(rest: Vec): boolean {
    return this.#solving.current?.posed.bends(rest) ?? false;
  }

  /** Where the borders between cells are in the present pose: pieces × 2 ends × 2. */
  posed(borders: CellBorders): Float32Array {
    return this.pose()?.borders(borders) ?? new Float32Array();
  }

  /** How many sites move each vertex; null without a solution. */
  coverage(): Float32Array | null {
    return this.#solving.current?.posed.coverage() ?? null;
  }

  graph(): SiteGraph | null {
    const pose = this.pose();
    const data = this.#solving.current?.data;
    return data && pose ? { handles: data.siteHandle, edges: data.siteEdges, motions: pose.motions } : null;
  }
}
