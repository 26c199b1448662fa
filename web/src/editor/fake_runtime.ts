/**
 * A runtime without a browser, for tests: effects are answered by a list of pending answers that the test delivers in
 * any order. The picture is a plane: every place of it is posed where it rests, moved by the mean of the handles.
 */

import { keyCorners, trackOf } from '../document/clip_keys';
import { ringsOf } from '../document/domain';
import { groupCentre } from '../document/group';
import {
  anchor,
  corners,
  depthOf,
  type HiddenCorners,
  moved,
  rotationOf,
  scaleOf,
  type Turns,
} from '../document/handle';
import type { HandlePose } from '../document/handle_poses';
import type { Clip, Handle, Project } from '../document/project';
import type { Crease } from '../geometry/crease';
import { distanceToLine } from '../geometry/polyline';
import { isInsideOf } from '../geometry/ring';
import { add, distance, lerp, subtract, type Vec } from '../geometry/vec';
import type { Deformation, GroupWay, LimitedPose } from './deformation';
import type { EditorEffect } from './effects';
import type { EditorEvent } from './events';
import { initialState } from './initial_state';
import { initialOpening, nothingCarried } from './opening_state';
import type { Media, PageAttributes } from './page';
import type { Picture, SourceFile } from './picture';
import type { Solution, SolveReport } from './solution';
import type { EditorState } from './state';
import { update } from './update';

export const PAGE: PageAttributes = {
  readonly: false,
  disabled: false,
  posable: false,
  clip: null,
  autoplay: false,
  loop: false,
  tool: null,
  alt: null,
  hint: null,
  src: null,
  projectSource: null,
  samples: [],
  features: null,
  credentials: 'same-origin',
  defaults: {},
};

export const MEDIA: Media = {
  dark: false,
  coarse: false,
  still: false,
  platform: 'Linux',
  rtl: false,
  folders: false,
};

const files = new Map<string, SourceFile>();

/** The one file of a name. */
export function testFile(name: string): SourceFile {
  const file = files.get(name) ?? { size: 1, type: 'image/png' };
  files.set(name, file);
  return file;
}

export const testPicture = (name = 'cat.png'): Picture => ({
  id: name,
  name,
  thumbnail: '',
  file: testFile(name),
  width: 400,
  height: 300,
  alphaThreshold: null,
  isSmall: false,
  isPixelArt: false,
  moves: false,
  lacksTexts: false,
});

/** Moves everything by the mean move of the handles. Handles beyond x = 1,000 fold one triangle each. */
class PlaneDeformation implements Deformation {
  /** Drags below y = 1,000 leave a shape. */
  shapeLeft({ handles }: Project) {
    const lowest = Math.max(...handles.map((handle) => anchor(handle)[1]));
    return lowest > 1000 ? [[0, 0, lowest, lowest, 1, 0, 0, 1]] : undefined;
  }

  /** Linear between keys, whatever their ease. */
  posesAt(clip: Clip, handles: readonly Handle[], time: number): readonly HandlePose[] {
    return handles.map((handle) => {
      const keys = trackOf(clip, handle.id)?.keys ?? [];
      const before = keys.findLast((key) => key.time <= time) ?? keys[0];
      const after = keys.find((key) => key.time > time) ?? before;
      const fraction =
        before && after !== before ? (time - before.time) / ((after?.time ?? 0) - before.time) : 0;
      const [from, to] = [before, after].map((key) => (key?.posed ? keyCorners(key.posed) : corners(handle)));
      const posed = corners(handle).map((corner, k) =>
        lerp(from?.[k] ?? corner, to?.[k] ?? corner, fraction),
      );
      const rotation = before?.rotation ?? handle.rotation ?? 0;
      const deep = keys.filter((key) => key.depth !== undefined);
      return {
        posed,
        rotation: rotation === 'auto' ? Number.NaN : rotation,
        scale: before?.scale ?? scaleOf(handle),
        depth: (deep.findLast((key) => key.time <= time) ?? deep[0])?.depth ?? depthOf(handle),
      };
    });
  }

  filmFrames(_: Project, { duration }: Clip, rate: number, range: readonly [number, number] | null) {
    const [from, to] = range ?? [0, duration];
    return { frames: Math.round((to - from) * rate), refusal: null };
  }

  filmBounds(project: Project) {
    return this.bounds(project);
  }

  placement(project: Project, posed: Vec, within: number) {
    const rest = subtract(posed, shift(project));
    const inside = isInside(project, rest, within);
    return inside ? { posed, rest, rotation: 0, scale: 1 } : null;
  }

  layerUnder(project: Project, corners: readonly Vec[]) {
    const by = shift(project);
    return corners.map((posed) => ({ rest: subtract(posed, by), rotation: 0, scale: 1 }));
  }

  /** The frame of the test picture. */
  restOutline(): Float32Array {
    return Float32Array.of(0, 0, 400, 0, 400, 0, 400, 300, 400, 300, 0, 300, 0, 300, 0, 0);
  }

  turns({ handles }: Project): Turns {
    return new Map(handles.map((handle) => [handle.id, rotationOf(handle)]));
  }

  hidden(): HiddenCorners {
    return new Map();
  }

  /** Handles at nearly the same place cross. */
  lead({ handles }: Project, ids: readonly string[]): number {
    const pairs = handles.flatMap((one) =>
      handles
        .filter(({ id }) => ids.includes(one.id) && !ids.includes(id))
        .filter((other) => distance(anchor(one), anchor(other)) < 10)
        .map((other) => depthOf(one) - depthOf(other)),
    );
    return Math.min(1, ...pairs);
  }

  creases({ handles }: Project): readonly Crease[] {
    const box = { min: [0, 0], max: [4, 4] } as const;
    return handles.filter((handle) => anchor(handle)[0] > 1000).map(() => ({ box, area: 16 }));
  }

  /** Those beyond x = 1,000. */
  forcing({ handles }: Project): readonly string[] {
    return handles.filter((handle) => anchor(handle)[0] > 1000).map(({ id }) => id);
  }

  /** They go back to x = 1,000. Nothing leads back from x = 9,000. */
  unfolded(project: Project): Project | null {
    if (project.handles.some((handle) => anchor(handle)[0] > 9000)) return null;
    const back = (handle: Handle) =>
      anchor(handle)[0] > 1000 ? moved(handle, [1000 - anchor(handle)[0], 0]) : handle;
    return { ...project, handles: project.handles.map(back) };
  }

  foldCount(project: Project): number {
    return this.creases(project).length;
  }

  foldLimit(from: Project, to: Project, allowed: number): LimitedPose {
    return this.foldCount(to) <= allowed
      ? { project: to, fraction: 1 }
      : { project: { ...to, ...from }, fraction: 0 };
  }

  groupFoldLimit({ origin, to }: GroupWay, allowed: number): LimitedPose {
    return this.foldLimit(origin, to, allowed);
  }

  bounds(project: Project) {
    const by = shift(project);
    return { min: by, max: add([project.image.width, project.image.height], by) };
  }

  restBounds() {
    return { min: [0, 0], max: [400, 300] } as const;
  }

  symmetry() {
    return { x: 200, y: null };
  }

  bends(): boolean {
    return true;
  }

  siteGraph(): null {
    return null;
  }

  posedBorders(): Float32Array {
    return new Float32Array();
  }

  posedLines(project: Project, lines: readonly (readonly Vec[])[]): readonly (readonly Vec[])[] {
    return lines.map((line) => line.map((place) => add(place, shift(project))));
  }

  outline(): Float32Array {
    return new Float32Array();
  }

  creasedMesh(): null {
    return null;
  }
}

const shift = ({ handles }: Project): Vec => {
  if (handles.length === 0) return [0, 0];
  const [sum, rest] = [groupCentre(handles), handles.map((handle) => anchor(handle, 'rest'))];
  const mean = rest.reduce(add, [0, 0]).map((value) => value / rest.length) as unknown as Vec;
  return subtract(sum, mean);
};

function isInside(project: Project, at: Vec, within: number): boolean {
  const { width, height } = project.image;
  const rings = ringsOf(project);
  if (rings.length > 0)
    return isInsideOf(rings, at) || rings.some((ring) => distanceToLine(ring, true, at) <= within);
  const [x, y] = at;
  return x >= -within && y >= -within && x <= width + within && y <= height + within;
}

export const solutionOf = (key: string, project: Project): Solution => ({
  key,
  project,
  report: {
    samples: 100,
    virtualSites: 0,
    outside: [],
    outline: 'traced',
    bridgedGap: 0,
    looseParts: 0,
    ms: 1,
    times: { domain: 0, sampling: 0, regions: 1, weights: 0, pose: 0 },
  },
  deformation: new PlaneDeformation(),
});

export class FakeRuntime {
  state: EditorState;
  /** All effects so far. */
  readonly effects: EditorEffect[] = [];
  /** Effects that wait for an answer. */
  pending: EditorEffect[] = [];
  /** Whether the page has posed handles, which is no step. */
  posedByPage = false;

  constructor(page: PageAttributes = PAGE) {
    this.state = initialState(page, MEDIA, initialOpening(nothingCarried));
  }

  dispatch(event: EditorEvent): void {
    const { state, effects } = update(this.state, event);
    this.state = state;
    this.effects.push(...effects);
    this.pending.push(...effects.filter(isAnswered));
    if (effects.some(({ type }) => type === 'release-input')) this.dispatch({ type: 'input-released' });
  }

  /** Opens a picture and solves it, with these figures in the solver's report. */
  open(picture = testPicture(), figures: Partial<SolveReport> = {}): void {
    this.dispatch({ type: 'stage-resized', size: { width: 400, height: 300 }, typing: false });
    this.dispatch({ type: 'files-received', files: [{ name: picture.name, file: picture.file }] });
    this.read(picture);
    this.solve(figures);
  }

  /** Answers the newest pending read. */
  read(
    picture: Picture | null,
    project: Project | null = null,
    carried: Project | Error | null = null,
  ): void {
    const effect = this.#take('read');
    if (effect)
      this.dispatch({
        type: 'read-ended',
        id: effect.id,
        picture,
        source: picture?.file ?? null,
        project,
        carried,
      });
  }

  /** Answers the newest pending read with an error. */
  failRead(error: Error): void {
    const effect = this.#take('read');
    if (effect) this.dispatch({ type: 'read-failed', id: effect.id, error });
  }

  /** Solves the newest request, with these figures in the solver's report. */
  solve(figures: Partial<SolveReport> = {}): void {
    const effect = this.#take('solve');
    if (!effect) return;
    const solution = solutionOf(effect.key, effect.project);
    this.dispatch({ type: 'solved', solution: { ...solution, report: { ...solution.report, ...figures } } });
  }

  /** Refuses the newest request; `failed`: the solver itself failed. */
  refuse(error: Error, failed = false): void {
    const effect = this.#take('solve');
    if (effect) this.dispatch({ type: 'solve-refused', key: effect.key, error, failed });
  }

  /** The notifications of the page so far, by their types. */
  get notified(): readonly string[] {
    return this.effects.flatMap((effect) =>
      effect.type === 'notify-page' ? [effect.notification.type] : [],
    );
  }

  #take<T extends EditorEffect['type']>(type: T): Extract<EditorEffect, { readonly type: T }> | undefined {
    const found = this.pending.findLast((effect) => effect.type === type);
    this.pending = this.pending.filter((effect) => effect !== found);
    return found as Extract<EditorEffect, { readonly type: T }> | undefined;
  }
}

const isAnswered = ({ type }: EditorEffect): boolean => type === 'read' || type === 'solve';

/** A ring in the picture of {@link testPicture}. */
export const RING = [
  [50, 50],
  [150, 50],
  [150, 150],
  [50, 150],
] as const;

/** An editor after a lasso along {@link RING}, solved. @param alphaThreshold null for an opaque picture. */
export function lassoed(alphaThreshold: number | null = null): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open({ ...testPicture(), alphaThreshold });
  runtime.dispatch({ type: 'lasso-drawn', ring: RING, hole: false });
  runtime.solve();
  return runtime;
}
