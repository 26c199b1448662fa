/**
 * The solver as the page uses it: a worker solves and exports; posing and checking projects are fast enough to run on
 * the page.
 *
 * A newer solve overtakes an older one. Placing a handle therefore never waits for more than one stage of the previous
 * solve, and the page itself never waits.
 */
import type { Lens } from '../document/generated/lens';
import type { Study } from '../document/generated/study';
import type { Clip, Project } from '../document/project';
import type { Suggestion } from '../document/suggestion';
import { ENGINE } from '../error';
import type { Vec } from '../geometry/vec';
import { startWorker } from '../start_worker';
import { say } from '../texts/wording';
import { Drawing } from './drawing';
import { engineError } from './engine_error';
import { superseded } from './errors';
import { Filming } from './filming';
import { Link } from './link';
import { loadedLater } from './loading';
import type { DrawingOptions, FilmOptions, Messages } from './messages';
import { checkedProject, loadModule } from './module';
import type { PosedPicture } from './posed_picture';
import type { CellBorders, FillData, PixelSource, SolutionData, Stage } from './solution';
import { createPosedPicture } from './wasm_picture';
import worker from './worker/worker?worker&url';

/** A time of a clip, whose tracks name the handles as the project does. */
export interface ClipMoment {
  readonly clip: Clip;
  /** Seconds. */
  readonly time: number;
}

/** A project for the present picture. */
export interface FittedProject {
  readonly project: Project;
  /** Ids of handles that were moved into the outline. */
  readonly moved: readonly string[];
}

export class Engine {
  readonly #link: Link;
  /** Rejects where the solver refuses the picture; every request awaits it. */
  #picture: Promise<unknown> = Promise.resolve();
  #newestSolve = 0;

  private constructor(link: Link) {
    this.#link = link;
  }

  /** @throws C2WarpError with the code `engine` where the module cannot be loaded, or the worker not be started. */
  static async start(): Promise<Engine> {
    const module = await loadModule();
    try {
      return new Engine(new Link(() => startWorker(worker), module, loadedLater, worker));
    } catch (error) {
      throw engineError(ENGINE, say('errors.engine.noWorkers'), { cause: error });
    }
  }

  /** Sets the picture of all later calls. If the solver refuses it, those calls reject. */
  setPicture(pixels: PixelSource): void {
    this.#newestSolve += 1;
    this.#link.abandon('solve');
    this.#picture = this.#link.send('picture', pixels);
    this.#picture.catch(() => {});
  }

  /**
   * @param onProgress Called with each stage once it is done.
   * @throws DOMException `AbortError` when a newer solve or picture overtakes this one; C2WarpError otherwise.
   */
  async solve(project: Project, onProgress?: (stage: Stage) => void): Promise<SolutionData> {
    const turn = ++this.#newestSolve;
    this.#link.abandon('solve');
    await this.#picture;
    if (turn !== this.#newestSolve) throw superseded();
    return this.#link.send('solve', { project: problemText(project) }, onProgress);
  }

  /**
   * Fills the picture behind the domain of a project that was solved; null if it has no fill. The newest call wins.
   * @param onProgress Called with the part that is done, from 0 to 1.
   * @throws DOMException `AbortError` when a newer fill or picture overtakes this one; C2WarpError otherwise.
   */
  async fill(project: Project, onProgress: (part: number) => void): Promise<FillData | null> {
    const picture = this.#picture;
    this.stopFilling();
    await Promise.all([picture, this.#link.extend()]);
    if (picture !== this.#picture) throw superseded();
    return this.#link.send('fill', { project: problemText(project) }, onProgress);
  }

  /** The answer to a fill under way is dropped. */
  stopFilling(): void {
    this.#link.abandon('fill');
  }

  /**
   * Fits a project that was made for another picture to the present one.
   * @param own the project's own picture, to align its outline with that of the present one.
   * @throws the errors of {@link cells}; C2WarpError if the project does not fit.
   */
  async fit(project: Project, own: PixelSource | null): Promise<FittedProject> {
    return JSON.parse(await this.#ask('fit', { project: JSON.stringify(project), own }));
  }

  /**
   * Handles where an animator would begin, beside those of a project. Ends a suggestion under way.
   * @throws DOMException `AbortError` when a newer one or {@link stopSuggesting} ends this one; else as {@link cells}.
   */
  async suggest(project: Project): Promise<Suggestion> {
    this.stopSuggesting();
    return JSON.parse(await this.#ask('suggest', { project: problemText(project) }));
  }

  /** The answer to a suggestion under way is dropped. */
  stopSuggesting(): void {
    this.#link.abandon('suggest');
  }

  /**
   * Prepares to draw the warped picture in straight alpha. Solves continue between its bands. With a moment the handles
   * are posed as there.
   * @throws DOMException `AbortError` when another picture comes before the worker has this one; C2WarpError otherwise.
   */
  async draw(project: Project, options: DrawingOptions, moment: ClipMoment | null = null): Promise<Drawing> {
    const picture = this.#picture;
    const at = moment && { clip: JSON.stringify(moment.clip), time: moment.time };
    const size = await this.#ask('draw', { project: problemText(project), history: at, ...options });
    return new Drawing(this.#link, size, () => picture === this.#picture);
  }

  /**
   * Prepares to draw the frames of a clip. Solves continue between their bands.
   * @param project with the poses of handles without a track.
   * @param clip names the handles as the project does.
   * @throws the errors of {@link draw}.
   */
  async film(project: Project, clip: Clip, options: FilmOptions): Promise<Filming> {
    const picture = this.#picture;
    const asked = { project: problemText(project), clip: JSON.stringify(clip), ...options };
    const size = await this.#ask('film', asked);
    return new Filming(this.#link, size, () => picture === this.#picture);
  }

  /**
   * The borders between the cells of a project's solution.
   * @throws DOMException `AbortError` when another picture comes before the worker has this one; C2WarpError otherwise.
   */
  cells(project: Project): Promise<CellBorders> {
    return this.#ask('cells', { project: problemText(project) });
  }

  /** A project's solution, explained. @throws the errors of {@link cells}. */
  study(project: Project): Promise<Study> {
    return this.#ask('study', { project: problemText(project) });
  }

  /** The weights and paths of a rest point; null outside the domain. @throws the errors of {@link cells}. */
  lens(project: Project, at: Vec): Promise<Lens | null> {
    return this.#ask('lens', { project: problemText(project), at });
  }

  /** The picture of a solution, to be posed. Free it with the solution. @param project The project that was solved. */
  posedPicture(solution: SolutionData, project: Project): PosedPicture {
    return createPosedPicture(solution, project);
  }

  /**
   * Reads a project file.
   * @throws Error with a code and a message that names the offending key.
   */
  checkProject(text: string): Project {
    return checkedProject(text);
  }

  /** Ends the worker; pending requests reject with `AbortError`. */
  dispose(): void {
    this.#newestSolve += 1;
    this.#link.dispose();
  }

  /** Asks about the present picture, once the worker has it. */
  async #ask<N extends 'fit' | 'suggest' | 'draw' | 'film' | 'cells' | 'study' | 'lens'>(
    name: N,
    body: Messages[N][0],
  ): Promise<Messages[N][1]> {
    const picture = this.#picture;
    await Promise.all([picture, this.#link.extend()]);
    if (picture !== this.#picture) throw superseded();
    return this.#link.send(name, body);
  }
}

/** What the solver needs of a project: all but the clips, whose tracks may have newer names of handles. */
const problemText = ({ clips: _, ...problem }: Project): string => JSON.stringify(problem);
