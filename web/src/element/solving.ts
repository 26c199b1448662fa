/**
 * Keeps the solution in step with the project: solves when its dependencies have changed, poses otherwise.
 *
 * The newest project wins. The last few solutions are cached, so that undo and redo across an added handle are
 * immediate. Progress is reported only once a wait is noticeable.
 */
import { Engine } from '../compute/engine';
import { ENGINE, EngineError } from '../compute/errors';
import type { PosedPicture } from '../compute/posed_picture';
import type { CellBorders, Pixels, SolutionData, Stage } from '../compute/solution';
import type { Project } from '../document/project';
import { solveKey } from '../document/solved';
import type { Size } from '../geometry/camera';
import type { SolvedLabel } from '../ui/model';
import { isAbort } from './latest';

/** A solution and the project that was solved. */
export interface Solved {
  readonly key: string;
  readonly project: Project;
  readonly data: SolutionData;
  readonly posed: PosedPicture;
}

export interface SolvingHost {
  /** Shows another solution. @param first whether this is the first solution of the picture. */
  solved(solved: Solved, first: boolean): void;
  /** The solver refuses the project of this key. */
  refused(key: string, error: Error): void;
  /** The solver itself failed or could not start. */
  failed(error: Error): void;
  /** Shows the stage of a long solve. Returns a function that ends the display. */
  begin(label: string): () => void;
}

/** Number of cached solutions, some 6 MB each at 10,000 samples. */
const KEPT = 6;
/** From here on a wait is noticeable. */
const PATIENCE_MS = 200;

const LABELS: Readonly<Record<Stage | 'begin', string>> = {
  begin: 'Finding the outline',
  domain: 'Sampling',
  sampling: 'Measuring distances',
  regions: 'Weighting',
  weights: 'Weighting',
};

export class Solving {
  readonly #host: SolvingHost;
  #engine: Promise<Engine> | null = null;
  #pixels: Pixels | null = null;
  #disposed = false;
  #kept: Solved[] = [];
  #current: Solved | null = null;
  #wanted: string | null = null;
  /** The current stage; null between solves. */
  #label: string | null = null;
  /** Ends the display of progress. */
  #end: (() => void) | null = null;
  #failed = false;
  #patience: ReturnType<typeof setTimeout> | undefined;

  constructor(host: SolvingHost) {
    this.#host = host;
  }

  /** The solver itself failed at the last solve, or could not start. */
  get failed(): boolean {
    return this.#failed;
  }

  get current(): Solved | null {
    return this.#current;
  }

  /** The key being solved; null if the shown solution is that of the newest project. */
  get pending(): string | null {
    return this.#current?.key === this.#wanted ? null : this.#wanted;
  }

  /** The shown solution in numbers, for the status line. */
  get label(): SolvedLabel | null {
    if (!this.#current) return null;
    const { samples, virtual_sites: virtualSites, ms } = this.#current.data.report;
    return { samples, virtualSites, ms: Object.values(ms).reduce((sum, stage) => sum + stage, 0) };
  }

  /** The picture that is solved. */
  get picture(): Size | null {
    return this.#pixels;
  }

  setPicture(pixels: Pixels | null): void {
    this.#forget();
    this.#pixels = pixels;
    if (!pixels) return;
    this.#engine?.then(
      (engine) => engine.setPicture(pixels.width, pixels.height, pixels.rgba),
      () => {},
    );
  }

  /** Shows the solution of a project: at once if it is cached, else when solved. */
  want(project: Project): void {
    const key = solveKey(project);
    if (key === this.#wanted || !this.#pixels || this.#disposed) return;
    this.#wanted = key;
    this.#failed = false;
    const known = this.#kept.find((solved) => solved.key === key);
    if (known) this.#show(known);
    else void this.#solve(project, key);
  }

  /** The borders between the cells of a solution. */
  async cells(solved: Solved): Promise<CellBorders> {
    const engine = await this.engine();
    return engine.cells(solved.project);
  }

  /** The solver; the first call starts it. */
  engine(): Promise<Engine> {
    if (this.#disposed) return Promise.reject(new DOMException('the editor is gone', 'AbortError'));
    this.#engine ??= this.#start();
    return this.#engine;
  }

  dispose(): void {
    this.#disposed = true;
    this.#forget();
    this.#stop();
  }

  #stop(): void {
    this.#engine?.then(
      (engine) => engine.dispose(),
      () => {},
    );
    this.#engine = null;
  }

  async #start(): Promise<Engine> {
    try {
      const engine = await Engine.start();
      if (this.#pixels) engine.setPicture(this.#pixels.width, this.#pixels.height, this.#pixels.rgba);
      return engine;
    } catch (error) {
      this.#engine = null;
      throw error;
    }
  }

  async #solve(project: Project, key: string): Promise<void> {
    this.#expect(LABELS.begin);
    let solved: Solved;
    try {
      const engine = await this.engine();
      if (key !== this.#wanted) return;
      const data = await engine.solve(project, (stage) => {
        if (key === this.#wanted) this.#expect(LABELS[stage]);
      });
      solved = { key, project, data, posed: engine.posedPicture(data, project) };
    } catch (thrown) {
      this.#fail(key, thrown);
      return;
    }
    this.#keep(solved);
    if (key !== this.#wanted) return;
    try {
      this.#show(solved);
    } catch (thrown) {
      // Such as graphics that are gone: the solver is not to blame.
      this.#host.failed(thrown as Error);
    }
  }

  #fail(key: string, thrown: unknown): void {
    const error = thrown instanceof Error ? thrown : new Error(String(thrown));
    if (isAbort(error) || key !== this.#wanted) return;
    this.#done();
    this.#wanted = this.#current?.key ?? null;
    if (error instanceof EngineError && error.code !== ENGINE) this.#host.refused(key, error);
    else {
      // It may have given up the picture: the next solve starts another, which gets the picture anew.
      this.#stop();
      this.#failed = true;
      this.#host.failed(error);
    }
  }

  #show(solved: Solved): void {
    this.#done();
    const first = this.#current === null;
    this.#current = solved;
    this.#host.solved(solved, first);
  }

  #keep(solved: Solved): void {
    this.#kept = [solved, ...this.#kept.filter((other) => other.key !== solved.key)];
    const dropped = this.#kept.slice(KEPT).filter((other) => other !== this.#current);
    this.#kept = this.#kept.filter((other) => !dropped.includes(other));
    for (const { posed } of dropped) posed.free();
  }

  #forget(): void {
    this.#done();
    for (const { posed } of this.#kept) posed.free();
    this.#kept = [];
    this.#current = null;
    this.#wanted = null;
    this.#pixels = null;
  }

  /** Starts a stage, which is shown once the solve has taken `PATIENCE_MS`. */
  #expect(label: string): void {
    const begins = this.#label === null;
    this.#label = label;
    if (begins) this.#patience = setTimeout(() => this.#tell(), PATIENCE_MS);
    else if (this.#patience === undefined) this.#tell();
  }

  #tell(): void {
    this.#patience = undefined;
    if (this.#label === null) return;
    const end = this.#host.begin(this.#label);
    this.#end?.();
    this.#end = end;
  }

  #done(): void {
    clearTimeout(this.#patience);
    this.#patience = undefined;
    this.#label = null;
    this.#end?.();
    this.#end = null;
  }
}
