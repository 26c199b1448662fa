/**
 * The {@link PosedPicture} that the page's module computes.
 *
 * The module caches one pose. A query about another one poses again, which takes the time of a frame.
 */
import { blendOf, restingRotation } from '../document/bending';
import { isSameDisplacement, numbersOf, withoutDisplacement } from '../document/displacement';
import {
  anchor,
  atRest,
  corners,
  type HiddenCorners,
  isAutomatic,
  rounded,
  type Turns,
} from '../document/handle';
import { projectPoses } from '../document/handle_poses';
import type { Clip, Displacement, Handle, Project, Stiffness } from '../document/project';
import { type Shape, shapeNumbers, shapeOf } from '../document/shape';
import { followedHandles, placeKey } from '../document/solved';
import { stiffnessOf } from '../document/stiffness';
import { followedPoses, groupWay, handleWay } from '../document/ways';
import type { Box } from '../geometry/box';
import type { Crease } from '../geometry/crease';
import { MOST_COVERAGE } from '../geometry/heat';
import type { LocatedPoint, MappedPoint, Placement } from '../geometry/place';
import { type Places, siteTurn } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import { createModulePicture, createModulePlayback, type ModulePicture, type ModulePlayback } from './module';
import type { GroupWay, LimitedPose, Playback, Pose, PosedPicture } from './posed_picture';
import type { CellBorders, SolutionData } from './solution';

/** Requires the module to be loaded. @param project The project that was solved. */
export const createPosedPicture = (data: SolutionData, project: Project): PosedPicture =>
  new WasmPicture(createModulePicture(data, project.handles), data, project);

class WasmPicture implements PosedPicture {
  readonly #module: ModulePicture;
  readonly #solved: Project;
  readonly data: SolutionData;
  /** The pose that the module holds; null while it rests. */
  #present: WasmPose | null = null;
  #triangles: { readonly version: number; readonly array: Uint32Array };
  #coverage: Float32Array<ArrayBuffer> | undefined;
  /** The stiffness of the picture in the module, and the last requested stiffness of its vertices. */
  #stiff: StiffPlaces;
  /** The displacement of the picture in the module, and the last requested places of its vertices. */
  #displaced: Displacement | undefined;
  #places: { readonly of: Displacement; readonly places: Places } | undefined;
  /** The shape in the module. */
  #shape: Shape | undefined;
  #restOutline: Float32Array<ArrayBuffer> | undefined;
  #stiffness: { readonly of: StiffPlaces; readonly values: Float32Array<ArrayBuffer> } | undefined;

  constructor(module: ModulePicture, data: SolutionData, solved: Project) {
    this.#module = module;
    this.#solved = solved;
    this.#stiff = stiffPlaces(solved);
    this.data = data;
    this.#triangles = { version: module.order_version, array: data.triangles };
  }

  get bytes(): number {
    return this.#module.bytes;
  }

  /** Gives the module the stiffness, the displacement and the shape of a project, on which its poses depend. */
  #prepared(project: Project): ModulePicture {
    const places = stiffPlaces(project);
    if (!isSame(this.#stiff, places)) {
      this.#module.set_stiffness(JSON.stringify(places));
    }
    this.#stiff = places;
    const { displacement } = project;
    if (!isSameDisplacement(this.#displaced, displacement)) {
      if (displacement)
        this.#module.set_displacement(displacement.width, displacement.height, numbersOf(displacement));
      else this.#module.set_displacement(0, 0, NO_NUMBERS);
      this.#displaced = displacement;
      // Its answers are those of another displacement now.
      this.#present = null;
    }
    if (this.#shape !== project.shape) this.#module.set_shape(shapeNumbers(project.shape));
    this.#shape = project.shape;
    return this.#module;
  }

  placesOf(pose: WasmPose): Places | null {
    const { displacement } = pose.project;
    if (!displacement) return null;
    if (!this.#places || !isSameDisplacement(this.#places.of, displacement)) {
      const module = this.holding(pose);
      const feather = module.displaced_points(this.data.featherPositions);
      this.#places = { of: displacement, places: { mesh: module.displaced_positions(), feather } };
    }
    return this.#places.places;
  }

  restOutline(): Float32Array<ArrayBuffer> {
    if (!this.#restOutline) {
      const rotation = restingRotation(this.#solved);
      const handles = this.#solved.handles.map((handle) => atRest(handle, rotation));
      this.#restOutline = this.pose(withoutDisplacement({ ...this.#solved, handles })).outline();
    }
    return this.#restOutline;
  }

  stiffness(project: Project): Float32Array<ArrayBuffer> {
    const of = stiffPlaces(project);
    if (!this.#stiffness || !isSame(this.#stiffness.of, of))
      this.#stiffness = { of, values: this.#module.stiffness(JSON.stringify(of)) };
    return this.#stiffness.values;
  }

  pose(project: Project, before?: Pose): Pose {
    const way = before ? ({ after: before as WasmPose } as const) : {};
    return this.#posed(new WasmPose(this, project, projectPoses(this.#solved, project), way));
  }

  settled(pose: Pose): Pose {
    const { project, handles } = pose as WasmPose;
    return this.#posed(new WasmPose(this, project, handles, { settles: pose as WasmPose }));
  }

  playback(clip: Clip, project: Project): Playback {
    // The module knows handles by the names that they were solved with.
    const names = new Map<string, string>();
    const handles = followedHandles(this.#solved, project).map((handle, index): Handle => {
      const id = this.#solved.handles[index]?.id ?? handle.id;
      names.set(handle.id, id);
      return { ...handle, id };
    });
    const tracks = clip.tracks.flatMap((track) => {
      const handle = names.get(track.handle);
      return handle === undefined ? [] : { ...track, handle };
    });
    const playback = createModulePlayback(this.#prepared(project), { ...clip, tracks }, handles);
    return {
      pose: (posed, time) =>
        this.#posed(
          new WasmPose(this, posed, projectPoses(this.#solved, posed), { moment: { playback, time } }),
        ),
      free: () => playback.free(),
    };
  }

  #posed(pose: WasmPose): WasmPose {
    pose.motions = this.#show(pose);
    return pose;
  }

  /** Gives the module a pose. */
  #show(pose: WasmPose): Motions {
    const motions = pose.show(this.#prepared(pose.project));
    this.#present = pose;
    return motions;
  }

  forcing(project: Project): readonly string[] {
    const { poses, handles } = followedPoses(this.#solved, project);
    return Array.from(
      this.#prepared(project).forcing_handles(poses, isRigid(project)),
      (index) => handles[index]?.id ?? '',
    );
  }

  unfolded(project: Project, last: Project | null): Project | null {
    const { poses, apply } = followedPoses(this.#solved, project);
    const before = last ? projectPoses(this.#solved, last) : undefined;
    const found = this.#prepared(project).unfolded(poses, before, isRigid(project));
    return found ? apply(found) : null;
  }

  foldCount(project: Project): number {
    return this.#prepared(project).fold_count_of(projectPoses(this.#solved, project), isRigid(project));
  }

  foldLimit(from: Pose, to: Project, allowed: number): LimitedPose {
    const way = handleWay(this.#solved, from.project, to, from.turns);
    return limited(
      this.holding(from as WasmPose).fold_limit(way.from, way.to, way.turns, isRigid(to), allowed),
      to,
      way.apply,
    );
  }

  groupFoldLimit(from: Pose, { origin, selection, to, start, end }: GroupWay, allowed: number): LimitedPose {
    const way = groupWay(this.#solved, origin, selection, to);
    const group = [...way.pivot, start.turn, start.scale, end.turn, end.scale, ...way.scales];
    const limit = this.holding(from as WasmPose).group_fold_limit(
      way.to,
      way.members,
      way.origins,
      way.rotations,
      Float64Array.from(group),
      isRigid(to),
      allowed,
    );
    return limited(limit, to, way.apply);
  }

  reach(pose: Pose, selection: readonly string[]): Float32Array<ArrayBuffer> | null {
    const { project } = pose;
    const selected = this.indicesOf(project, selection);
    if (selected.length === 0) return null;
    const { width, height } = project.image;
    const { handles } = pose as WasmPose;
    const module = this.holding(pose as WasmPose);
    return module.reach(handles, isRigid(project), selected, Math.hypot(width, height));
  }

  /** The indices in the solution of a project's handles. */
  indicesOf(project: Project, ids: readonly string[]): Uint32Array {
    const followed = followedHandles(this.#solved, project);
    return Uint32Array.from(followed.flatMap(({ id }, index) => (ids.includes(id) ? [index] : [])));
  }

  coverage(): Float32Array<ArrayBuffer> {
    this.#coverage ??= Float32Array.from(this.#module.coverage(), (sites) => sites / MOST_COVERAGE);
    return this.#coverage;
  }

  restBounds(): Box | null {
    return asBox(this.#module.rest_bounds());
  }

  bends([x, y]: Vec): boolean {
    return this.#module.bends(x, y);
  }

  free(): void {
    this.#module.free();
  }

  /** The module, holding a pose. */
  holding(pose: WasmPose): ModulePicture {
    if (this.#present !== pose) this.#show(pose);
    return this.#module;
  }

  /** The triangles in drawing order of a pose. */
  trianglesOf(pose: WasmPose): Uint32Array {
    const module = this.holding(pose);
    const version = module.order_version;
    if (version !== this.#triangles.version) this.#triangles = { version, array: module.triangles() };
    return this.#triangles.array;
  }

  /** Turns of automatic handles: of their own sites, or of the picture around handles that are not solved yet. */
  turnsOf(pose: WasmPose): Turns {
    const sites = new Map<string, number>();
    const followed = followedHandles(this.#solved, pose.project);
    this.data.siteHandle.forEach((index, site) => {
      const handle = followed[index];
      if (handle) sites.set(handle.id, site);
    });
    const automatic = pose.project.handles.filter(isAutomatic);
    return new Map(
      automatic.map((handle) => {
        const site = sites.get(handle.id);
        const turn =
          site === undefined
            ? (pose.map(anchor(handle, 'rest'))?.rotation ?? 0)
            : siteTurn(pose.motions, site);
        // Rounded as in the document, so that pinning changes no digit.
        return [handle.id, rounded(turn)];
      }),
    );
  }
}

type Motions = Float32Array<ArrayBuffer>;

/** No shape is stored if every vertex is within this distance of the pose without a shape. */
const SHAPE_PX = 0.25;

/** How a pose is found: without history unless a key is there. */
interface Way {
  /** A time of a clip. */
  readonly moment?: { readonly playback: ModulePlayback; readonly time: number };
  /** The frame before in a drag. */
  readonly after?: WasmPose;
  /** The end of a drag. */
  readonly settles?: WasmPose;
}

class WasmPose implements Pose {
  readonly #picture: WasmPicture;
  readonly project: Project;
  readonly handles: Float64Array;
  /** The motions in full precision, once they are found. */
  #numbers: Float64Array | undefined;
  #way: Way;
  motions = new Float32Array();
  #positions: Float32Array<ArrayBuffer> | undefined;
  #turns: Turns | undefined;
  #creases: readonly Crease[] | undefined;
  #hidden: HiddenCorners | undefined;

  constructor(picture: WasmPicture, project: Project, handles: Float64Array, way: Way) {
    this.#picture = picture;
    this.project = project;
    this.handles = handles;
    this.#way = way;
  }

  /** Gives the module this pose. Returns the motions. */
  show(module: ModulePicture): Motions {
    const rigid = isRigid(this.project);
    if (this.#numbers) return module.show_motions(this.#numbers, rigid);
    const motions = this.#find(module, rigid);
    this.#numbers = module.motion_numbers();
    // Else each frame of a drag would keep all frames before.
    this.#way = {};
    return motions;
  }

  #find(module: ModulePicture, rigid: boolean): Motions {
    const { moment, after, settles } = this.#way;
    if (moment) return moment.playback.pose(module, moment.time, rigid);
    const before = after ?? settles;
    if (!before) return module.set_pose(this.handles, rigid);
    this.#picture.holding(before);
    return settles ? module.settle_pose(this.handles, rigid) : module.follow_pose(this.handles, rigid);
  }

  shape(): Shape | undefined {
    return shapeOf(this.#module.shape(this.handles, isRigid(this.project), SHAPE_PX));
  }

  get places(): Places | null {
    return this.#picture.placesOf(this);
  }

  get triangles(): Uint32Array {
    return this.#picture.trianglesOf(this);
  }

  get positions(): Float32Array<ArrayBuffer> {
    this.#positions ??= this.#module.posed_positions();
    return this.#positions;
  }

  get turns(): Turns {
    this.#turns ??= this.#picture.turnsOf(this);
    return this.#turns;
  }

  get creases(): readonly Crease[] {
    this.#creases ??= asCreases(this.#module.creases());
    return this.#creases;
  }

  get hidden(): HiddenCorners {
    this.#hidden ??= this.#findHidden();
    return this.#hidden;
  }

  #findHidden(): HiddenCorners {
    const { handles } = this.project;
    const places = Float64Array.from(handles.flatMap((handle) => corners(handle, 'rest')).flat());
    // Nothing is hidden while no part crosses another: a drag need not look for it.
    const found = this.#module.crossed() ? this.#module.hidden(places) : new Uint8Array(places.length / 2);
    let next = 0;
    return new Map(
      handles.map((handle) => {
        const from = next;
        next += corners(handle).length;
        return [handle.id, Array.from(found.subarray(from, next), (flag) => flag === 1)];
      }),
    );
  }

  creasedTriangles(): Uint32Array<ArrayBuffer> {
    return this.#module.creased_triangles();
  }

  map([x, y]: Vec): MappedPoint | null {
    return asPlacement(this.#module.map(x, y));
  }

  mapPoints(rest: Float64Array): Float64Array {
    return this.#module.map_points(rest);
  }

  locatePoints(posed: Float64Array): Float64Array {
    return this.#module.locate_points(posed);
  }

  locate([x, y]: Vec): LocatedPoint | null {
    return asPlacement(this.#module.locate(x, y));
  }

  layerUnder(corners: readonly Vec[]): readonly LocatedPoint[] | null {
    const numbers = this.#module.layer_under(Float64Array.from(corners.flat()));
    if (!numbers) return null;
    return corners.flatMap((_, k) => asPlacement(numbers.subarray(6 * k, 6 * k + 6)) ?? []);
  }

  lead(ids: readonly string[]): number {
    return this.#module.lead(this.handles, this.#picture.indicesOf(this.project, ids));
  }

  crossed(): Box | null {
    return asBox(this.#module.crossed());
  }

  placement([x, y]: Vec, within: number): Placement | null {
    return asPlacement(this.#module.placement(x, y, within));
  }

  lines(rest: readonly (readonly Vec[])[], step: number): readonly (readonly Vec[])[] {
    // A pair of NaN separates lines.
    const flat = rest.flatMap((line, at) =>
      at === 0 ? line.flat() : [Number.NaN, Number.NaN, ...line.flat()],
    );
    const posed = this.#module.posed_lines(Float64Array.from(flat), step);
    const lines: Vec[][] = [[]];
    for (let at = 0; at < posed.length; at += 2) {
      const [x = 0, y = 0] = posed.subarray(at, at + 2);
      if (Number.isNaN(x)) lines.push([]);
      else lines.at(-1)?.push([x, y]);
    }
    return lines;
  }

  bounds(): Box | null {
    return asBox(this.#module.bounds());
  }

  outline(): Float32Array<ArrayBuffer> {
    return this.#module.outline();
  }

  borders({ corners, barycentric }: CellBorders): Float32Array<ArrayBuffer> {
    return this.#module.borders(corners, barycentric);
  }

  get #module(): ModulePicture {
    return this.#picture.holding(this);
  }
}

/** The part of a project that defines stiff areas, as a separate project. */
type StiffPlaces = Pick<Project, 'format' | 'image' | 'handles' | 'stiffness'>;

const stiffPlaces = ({ format, image, handles, stiffness }: Project): StiffPlaces => ({
  format,
  image,
  handles: handles.filter((handle) => stiffnessOf(handle) > 0),
  ...(stiffness && { stiffness }),
});

/** Whether the same places are stiff. Poses of polygons make no difference. */
const isSame = (a: StiffPlaces, b: StiffPlaces): boolean =>
  isSameGrid(a.stiffness, b.stiffness) &&
  a.handles.length === b.handles.length &&
  a.handles.every((handle, k) => {
    const other = b.handles[k];
    return other && placeKey(other) === placeKey(handle) && stiffnessOf(other) === stiffnessOf(handle);
  });

const isSameGrid = (a: Stiffness | undefined, b: typeof a): boolean =>
  a === b || (a?.width === b?.width && a?.height === b?.height && a?.values === b?.values);

const NO_NUMBERS = new Int16Array();

const isRigid = (project: Project): boolean => blendOf(project) === 'rigid';

/** @param numbers The fraction of the way, then the poses there. */
function limited(numbers: Float64Array, to: Project, apply: (poses: Float64Array) => Project): LimitedPose {
  const [fraction = 0] = numbers;
  return { fraction, project: fraction === 1 ? to : apply(numbers.subarray(1)) };
}

/** From a point's six numbers, see `wasm/bind/src/posed_picture.rs`. */
function asPlacement(numbers: Float64Array | undefined): Placement | null {
  if (!numbers) return null;
  const [restX = 0, restY = 0, posedX = 0, posedY = 0, rotation = 0, scale = 1] = numbers;
  return { rest: [restX, restY], posed: [posedX, posedY], rotation, scale };
}

/** @param numbers Creases × 5: the edges of the box, and the area. */
const asCreases = (numbers: Float64Array): readonly Crease[] =>
  Array.from({ length: numbers.length / 5 }, (_, index) => {
    const [left = 0, top = 0, right = 0, bottom = 0, area = 0] = numbers.subarray(5 * index);
    return { box: { min: [left, top], max: [right, bottom] }, area };
  });

function asBox(edges: Float64Array | undefined): Box | null {
  if (!edges) return null;
  const [left = 0, top = 0, right = 0, bottom = 0] = edges;
  return { min: [left, top], max: [right, bottom] };
}
