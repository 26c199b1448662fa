/** Answers the editor's questions about one solution from the WebAssembly module. */

import { frameTimes } from '../compute/module';
import type { Pose, PosedPicture } from '../compute/posed_picture';
import type { SolutionData } from '../compute/solution';
import { modeOf } from '../document/bending';
import { openDocument } from '../document/document';
import type { HiddenCorners, Turns } from '../document/handle';
import { atMoment, type PosesAt } from '../document/moment';
import type { Clip, Project } from '../document/project';
import type { Shape } from '../document/shape';
import { solveKey } from '../document/solved';
import type {
  CellBorders,
  CreasedMesh,
  Deformation,
  FrameCount,
  GroupWay,
  LimitedPose,
  SiteGraph,
} from '../editor/deformation';
import { errorWords } from '../editor/error_words';
import { asError } from '../error';
import { type Box, boxOfBoth } from '../geometry/box';
import type { Crease } from '../geometry/crease';
import type { LocatedPoint, MappedPoint, Placement } from '../geometry/place';
import { MOTION_STRIDE } from '../geometry/skin';
import { type Symmetry, symmetryOf } from '../geometry/symmetry';
import type { Vec } from '../geometry/vec';
import { OpenClip } from './clip_poses';

type FilmRange = readonly [from: number, to: number] | null;

/** Number of times of a film that are posed to estimate its size. */
const BOUND_TIMES = 24;

const NO_TURNS: Turns = new Map();
const NOTHING_HIDDEN: HiddenCorners = new Map();

/** A point of an unwarped picture. */
const atRest = (rest: Vec): LocatedPoint => ({ rest, rotation: 0, scale: 1 });

export class SolutionDeformation implements Deformation {
  readonly data: SolutionData;
  readonly #picture: PosedPicture;
  /** Computed poses, by project. Undo and redo restore the same project objects, so they show the same picture. */
  readonly #poses = new WeakMap<Project, Pose>();
  /** The poses that are frames of a drag. */
  readonly #frames = new WeakSet<Pose>();
  /** The last pose that could be computed. */
  #last: Pose | null = null;
  /** Found when somebody snaps to it. */
  #symmetry: Symmetry | undefined;

  /** The box of the film that was asked about last. */
  #filmed: { readonly of: Project; readonly key: string; readonly bounds: Box | null } | null = null;

  readonly #clip = new OpenClip();
  readonly posesAt: PosesAt = (clip, handles, time) => this.#clip.at(clip, handles, time);

  constructor(picture: PosedPicture, data: SolutionData) {
    this.#picture = picture;
    this.data = data;
  }

  filmFrames(project: Project, clip: Clip, rate: number, range: FilmRange): FrameCount {
    try {
      return { frames: frameTimes(clip, project.handles, rate, range).length, refusal: null };
    } catch (error) {
      return { frames: 0, refusal: errorWords(asError(error)) };
    }
  }

  filmBounds(project: Project, clip: Clip, range: FilmRange): Box | null {
    const key = JSON.stringify([clip, range]);
    if (this.#filmed?.of !== project || this.#filmed.key !== key)
      this.#filmed = { of: project, key, bounds: this.#boundsAlong(project, clip, range) };
    return this.#filmed.bounds;
  }

  #boundsAlong(project: Project, clip: Clip, range: FilmRange): Box | null {
    const [from, to] = range ?? [0, clip.duration];
    let all: Box | null = null;
    for (let k = 0; k <= BOUND_TIMES; k++) {
      const time = from + ((to - from) * k) / BOUND_TIMES;
      const bounds = this.bounds(atMoment(openDocument(project), clip.name, time, this.posesAt).project);
      all = bounds && all ? boxOfBoth(all, bounds) : (bounds ?? all);
    }
    return all;
  }

  /** The pose of a project; the last one if this one cannot be computed, such as of a bar without length. */
  pose(project: Project): Pose | null {
    const known = this.#poses.get(project);
    if (known) this.#last = known;
    else this.#know(project, () => this.#poseOf(project));
    return this.#last;
  }

  /** The pose that depends on the project only. It replaces that of the last frame of a drag. */
  rest(project: Project): Pose | null {
    const pose = this.pose(project);
    if (pose && this.#frames.has(pose)) this.#know(project, () => this.#picture.pose(project));
    return this.#last;
  }

  shapeLeft(project: Project): Shape | undefined {
    const pose = this.pose(project);
    if (pose?.project !== project || !this.#frames.has(pose)) return project.shape;
    return this.#picture.settled(pose).shape();
  }

  /** The picture does not change until a pose can be computed. */
  #know(project: Project, find: () => Pose): void {
    try {
      this.#last = find();
    } catch {}
    if (this.#last) this.#poses.set(project, this.#last);
  }

  /** Along a clip, the way from the beginning counts: scrubbing and playing show the same. Else drags go on. */
  #poseOf(project: Project): Pose {
    const along = modeOf(project) === 'rigid' ? this.#clip.playbackOf(this.#picture, project) : null;
    if (along) return along.playback.pose(project, along.time);
    const last = this.#last;
    if (modeOf(project) !== 'rigid' || !last || !isFrameAfter(last.project, project))
      return this.#picture.pose(project);
    const pose = this.#picture.pose(project, last);
    this.#frames.add(pose);
    return pose;
  }

  placement(project: Project, posed: Vec, within: number): Placement | null {
    return this.pose(project)?.placement(posed, within) ?? null;
  }

  layerUnder(project: Project, corners: readonly Vec[]): readonly LocatedPoint[] {
    return this.pose(project)?.layerUnder(corners) ?? corners.map(atRest);
  }

  /** Where a point of the original goes; null outside the mesh. */
  map(project: Project, rest: Vec): MappedPoint | null {
    return this.pose(project)?.map(rest) ?? null;
  }

  turns(project: Project): Turns {
    return this.pose(project)?.turns ?? NO_TURNS;
  }

  hidden(project: Project): HiddenCorners {
    return this.pose(project)?.hidden ?? NOTHING_HIDDEN;
  }

  lead(project: Project, ids: readonly string[]): number {
    return this.pose(project)?.lead(ids) ?? 1;
  }

  siteGraph(project: Project): SiteGraph | null {
    const pose = this.pose(project);
    if (!pose) return null;
    const { siteHandle: handles, siteEdges: edges } = this.data;
    return { handles, edges, places: posedSites(pose.motions) };
  }

  posedBorders(project: Project, borders: CellBorders): Float32Array {
    return this.pose(project)?.borders(borders) ?? new Float32Array();
  }

  posedLines(
    project: Project,
    lines: readonly (readonly Vec[])[],
    step: number,
  ): readonly (readonly Vec[])[] {
    return this.pose(project)?.lines(lines, step) ?? lines;
  }

  outline(project: Project): Float32Array {
    return this.pose(project)?.outline() ?? new Float32Array();
  }

  creasedMesh(project: Project): CreasedMesh | null {
    const pose = this.pose(project);
    if (!pose || pose.creases.length === 0) return null;
    return { posed: pose.positions, triangles: pose.creasedTriangles() };
  }

  creases(project: Project): readonly Crease[] {
    return this.pose(project)?.creases ?? [];
  }

  forcing(project: Project): readonly string[] {
    return this.#picture.forcing(project);
  }

  unfolded(project: Project, last: Project | null): Project | null {
    return this.#picture.unfolded(project, last);
  }

  foldCount(project: Project): number {
    const known = this.#poses.get(project);
    return known ? known.creasedTriangles().length / 3 : this.#picture.foldCount(project);
  }

  foldLimit(from: Project, to: Project, allowed: number): LimitedPose {
    const pose = this.pose(from);
    return pose ? this.#picture.foldLimit(pose, to, allowed) : { project: to, fraction: 1 };
  }

  groupFoldLimit(way: GroupWay, allowed: number): LimitedPose {
    const pose = this.pose(way.from);
    return pose ? this.#picture.groupFoldLimit(pose, way, allowed) : { project: way.to, fraction: 1 };
  }

  bounds(project: Project): Box | null {
    return this.pose(project)?.bounds() ?? null;
  }

  restBounds(): Box | null {
    return this.#picture.restBounds();
  }

  restOutline(): Float32Array {
    return this.#picture.restOutline();
  }

  symmetry(): Symmetry {
    const bounds = this.restBounds();
    this.#symmetry ??= bounds ? symmetryOf(bounds, (rest) => this.bends(rest)) : { x: null, y: null };
    return this.#symmetry;
  }

  bends(rest: Vec): boolean {
    return this.#picture.bends(rest);
  }

  /** Vertices: how far each follows a move of the selected handles; null if no such pose exists. */
  reach(project: Project, selection: readonly string[]): Float32Array | null {
    const pose = this.pose(project);
    return pose && this.#picture.reach(pose, selection);
  }

  stiffness(project: Project): Float32Array {
    return this.#picture.stiffness(project);
  }

  coverage(): Float32Array {
    return this.#picture.coverage();
  }

  free(): void {
    this.#picture.free();
    this.#clip.free();
  }
}

/** Whether a project differs from another one in the poses of its handles and the shape only. */
const isFrameAfter = (before: Project, project: Project): boolean =>
  solveKey(before) === solveKey(project) && before.stiffness === project.stiffness;

/** Sites × 2: the posed positions in motions. */
function posedSites(motions: Float32Array): Float32Array {
  const places = new Float32Array((2 * motions.length) / MOTION_STRIDE);
  for (let site = 0; 2 * site < places.length; site++) {
    const posed = MOTION_STRIDE * site + 6;
    places.set(motions.subarray(posed, posed + 2), 2 * site);
  }
  return places;
}
