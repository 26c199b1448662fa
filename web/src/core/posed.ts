/** A solution in one pose. It holds no resources. */
import type { Moment, Points, SiteMotions } from '../compute/messages';
import type { PosedMesh } from '../compute/points';
import { readPoses, withPose } from '../document/handle_poses';
import { type HandleFile, type ProjectFile, posedHandle } from '../document/project';
import { C2WarpError } from '../error';
import type { Environment } from './environment';
import type { Solver } from './solver';
import type { Cancellable, HandlePose, MappedPoints, RestPoints, WarpedPicture, WarpOptions } from './types';

/** A solution in one pose of its handles. */
export class PosedSolution {
  readonly #solver: Solver;
  readonly #environment: Environment;
  readonly #project: ProjectFile;
  readonly #history: Moment | SiteMotions | null;

  /** @internal */
  constructor(
    solver: Solver,
    environment: Environment,
    project: ProjectFile,
    history: Moment | SiteMotions | null,
  ) {
    this.#solver = solver;
    this.#environment = environment;
    this.#project = project;
    this.#history = history;
  }

  /**
   * The next frame of a drag. `poses` moves handles, by id, a little from this pose. Other handles stay. No
   * part moves much farther than the moved handles. In the harmonic mode, the result is that of {@link
   * Solution.pose}.
   *
   * @throws C2WarpError with the code `pose` if a handle does not exist.
   * @throws the errors of {@link map}.
   */
  async follow(
    poses: Readonly<Record<string, HandlePose>>,
    { signal }: Cancellable = {},
  ): Promise<PosedSolution> {
    return this.#next(posedBy(await this.#present(signal), poses), false, signal);
  }

  /**
   * The pose in which a drag comes to rest, with the handles of this pose.
   *
   * @throws the errors of {@link map}.
   */
  async settled({ signal }: Cancellable = {}): Promise<PosedSolution> {
    return this.#next(await this.#present(signal), true, signal);
  }

  /**
   * The posed positions of points of the picture, as in `c2warp map`.
   *
   * @param points Points × 2, in image pixels.
   * @throws C2WarpError with the code `pose` for a pose that cannot be computed.
   * @throws the reason of the signal if that is aborted.
   */
  async map(points: Float64Array, { signal }: Cancellable = {}): Promise<MappedPoints> {
    const posed = new Float64Array(points.length);
    const det = new Float64Array(points.length / 2);
    let at = 0;
    for await (const batch of this.#solver.batches('map', points, this.#about, signal)) {
      for (let from = 0; from < batch.length; from += 3) {
        posed.set(batch.subarray(from, from + 2), 2 * at);
        det[at++] = batch[from + 2] ?? Number.NaN;
      }
    }
    return { posed, det };
  }

  /**
   * The points of the picture that are drawn at points of the warped picture, as in `c2warp map --inverse`. Where parts
   * of the picture cover others, the part in front.
   *
   * @param points Points × 2, in pixels of the warped picture at scale 1.
   * @throws the errors of {@link map}.
   */
  async inverse(points: Float64Array, { signal }: Cancellable = {}): Promise<RestPoints> {
    const rest = new Float64Array(points.length);
    let at = 0;
    for await (const batch of this.#solver.batches('inverse', points, this.#about, signal)) {
      rest.set(batch, at);
      at += batch.length;
    }
    return { rest };
  }

  /** The posed mesh, for your own renderer. @throws the errors of {@link map}. */
  mesh({ signal }: Cancellable = {}): Promise<PosedMesh> {
    return this.#solver.ask('posed-mesh', this.#request, signal);
  }

  /**
   * Draws the warped picture at full quality, as in `c2warp warp`.
   *
   * @throws C2WarpError with the code `scale` or `canvas` for a result without pixels or with too many.
   * @throws the errors of {@link map}.
   */
  async warp(options: WarpOptions = {}): Promise<WarpedPicture> {
    const { scale = 1, area = 'picture', pixelated = false, signal, onProgress } = options;
    const settings = { scale, area, pixelated };
    const drawing = await this.#solver.draw(this.#request, settings, signal);
    const { width, height, origin } = drawing;
    const rgba = new Uint8Array(width * height * 4);
    let at = 0;
    for await (const band of drawing.bands()) {
      signal?.throwIfAborted();
      rgba.set(band, at);
      at += band.length;
      onProgress?.(at / rgba.length);
    }
    return { image: this.#environment.image({ width, height, rgba }), origin };
  }

  #about = (points: Points) => ({ ...this.#request, points });

  get #request() {
    return { project: problemText(this.#project), history: this.#history };
  }

  /** The project with its handles as in this pose. */
  async #present(signal: AbortSignal | undefined): Promise<ProjectFile> {
    const [project, moment] = [this.#project, this.#history];
    if (!moment || 'motions' in moment) return project;
    const handles = JSON.stringify(project.handles);
    const poses = readPoses(await this.#solver.ask('clip-poses', { handles, moment }, signal));
    const posed = (handle: HandleFile, k: number) => {
      const pose = poses[k];
      return pose ? withPose(posedHandle(handle), pose) : handle;
    };
    return { ...project, handles: project.handles.map(posed) };
  }

  async #next(project: ProjectFile, settles: boolean, signal: AbortSignal | undefined) {
    const next = problemText(project);
    const motions = await this.#solver.ask('next-pose', { ...this.#request, next, settles }, signal);
    return new PosedSolution(this.#solver, this.#environment, project, { motions });
  }
}

/** Poses handles of a project, by their ids. @throws C2WarpError with the code `pose` if a handle does not exist. */
export function posedBy(project: ProjectFile, poses: Readonly<Record<string, HandlePose>>): ProjectFile {
  const unknown = Object.keys(poses).find((id) => project.handles.every((handle) => handle.id !== id));
  if (unknown !== undefined) {
    throw new C2WarpError('pose', `There is no handle ${JSON.stringify(unknown)}.`, { handles: [unknown] });
  }
  const handles = project.handles.map((handle) => ({ ...handle, ...poses[handle.id] }) as HandleFile);
  return { ...project, handles };
}

/** Clips were checked with the solve, and only one of them is used for the pose. */
export const problemText = ({ clips: _, ...problem }: ProjectFile): string => JSON.stringify(problem);
