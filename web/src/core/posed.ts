/** A solution in one pose. It holds no resources. */
import type { Moment, Points } from '../compute/messages';
import type { PosedMesh } from '../compute/points';
import type { Environment } from './environment';
import type { Solver } from './solver';
import type { Cancellable, MappedPoints, RestPoints, WarpedPicture, WarpOptions } from './types';

/** A solution in one pose of its handles. */
export class PosedSolution {
  readonly #solver: Solver;
  readonly #environment: Environment;
  readonly #project: string;
  readonly #moment: Moment | null;

  /** @internal */
  constructor(solver: Solver, environment: Environment, project: string, moment: Moment | null) {
    this.#solver = solver;
    this.#environment = environment;
    this.#project = project;
    this.#moment = moment;
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
    return this.#solver.ask('posed-mesh', { project: this.#project, moment: this.#moment }, signal);
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
    const drawing = await this.#solver.draw(this.#project, this.#moment, settings, signal);
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

  #about = (points: Points) => ({ project: this.#project, moment: this.#moment, points });
}
