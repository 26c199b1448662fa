/// <reference lib="esnext.disposable" preserve="true" />
/** A picture with its solver. */
import { Link } from '../compute/link';
import { LocalPort } from '../compute/local_port';
import type { PixelSource } from '../compute/solution';
import type { ProjectFile } from '../document/project';
import { C2WarpError } from '../error';
import type { Environment } from './environment';
import { pixelsOf } from './picture';
import { Solution } from './solution';
import { Solver } from './solver';
import type { PictureInput, ProjectInput, SolveOptions, WarperOptions } from './types';

/** Older browsers lack the symbol. `using` needs the symbol of the runtime. */
const DISPOSE: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/**
 * A picture with its solver. It holds WebAssembly memory, and possibly a worker, until it is disposed of.
 *
 * A warper keeps only its last solution. Posing an older solution solves again, so use two warpers rather than
 * alternate between two solutions of one.
 */
export class Warper {
  /** Width of the picture, in pixels. */
  readonly width: number;
  readonly height: number;
  readonly #solver: Solver;
  readonly #environment: Environment;

  private constructor({ width, height }: PixelSource, solver: Solver, environment: Environment) {
    this.width = width;
    this.height = height;
    this.#solver = solver;
    this.#environment = environment;
  }

  /** @internal */
  static async create(
    environment: Environment,
    input: PictureInput,
    options: WarperOptions = {},
  ): Promise<Warper> {
    const { signal, worker = environment.usesWorker, module, laterModule } = options;
    const [pixels, compiled] = await Promise.all([
      pixelsOf(input, environment, options),
      (module as WebAssembly.Module | undefined) ?? environment.loadModule(),
    ]);
    signal?.throwIfAborted();
    const { width, height, rgba } = pixels;
    const source: PixelSource = { width, height, sendTo: (port) => port.postMessage(rgba) };
    const solver = new Solver(
      new Link(
        worker ? () => environment.spawn() : () => new LocalPort(),
        compiled,
        laterModule ? async () => laterModule as WebAssembly.Module : environment.loadLater,
        environment.workerAddress,
      ),
    );
    try {
      await solver.ask('picture', source, signal);
    } catch (error) {
      solver.dispose();
      throw error;
    }
    return new Warper(source, solver, environment);
  }

  /**
   * Solves a project: finds how its handles move each point of the picture. Solves run one after another.
   *
   * @throws C2WarpError with the code `project` and the path of the offending key, or another code of the solver such
   *   as `handle-outside`.
   * @throws the reason of the signal if that is aborted.
   */
  async solve(project: ProjectInput, options: SolveOptions = {}): Promise<Solution> {
    const whole = this.#whole(project);
    const data = await this.#solver.solve(JSON.stringify(whole), options);
    return new Solution(this.#solver, this.#environment, whole, data);
  }

  /** Frees the memory and ends the worker. Pending calls reject with an `AbortError`. */
  dispose(): void {
    this.#solver.dispose();
  }

  [DISPOSE](): void {
    this.dispose();
  }

  /** A copy of a project, with all required keys. */
  #whole(input: ProjectInput): ProjectFile {
    const { width, height } = this;
    const given: unknown = typeof input === 'string' ? parsed(input) : input;
    if (typeof given !== 'object' || given === null) {
      throw new C2WarpError(
        'project',
        'Expected the project as an object with handles, or as the text of a project file.',
      );
    }
    const image = { src: '', width, height };
    return copied({ format: 'c2warp/1', image, handles: [], ...given }) as ProjectFile;
  }
}

const parsed = (text: string): unknown => asProject(() => JSON.parse(text));
const copied = (project: object): unknown => asProject(() => JSON.parse(JSON.stringify(project)));

function asProject(read: () => unknown): unknown {
  try {
    return read();
  } catch (cause) {
    throw new C2WarpError('project', `The project is not valid JSON: ${(cause as Error).message}`, { cause });
  }
}
