/**
 * The solver of one editor: starts the engine at first use, and restarts it after a failure.
 *
 * Solutions hold memory of the WebAssembly module. Those that the state no longer names are freed.
 */

import type { Drawing } from '../compute/drawing';
import { type ClipMoment, Engine, type FittedProject } from '../compute/engine';
import type { Filming } from '../compute/filming';
import { loadedLater } from '../compute/loading';
import type { DrawingOptions, FilmOptions } from '../compute/messages';
import { checkedProject } from '../compute/module';
import type { PixelSource, SolutionData } from '../compute/solution';
import { checkedHandle } from '../document/handle';
import type { Clip, Project, ProjectFile } from '../document/project';
import { clipWithIdsOf, solveKey, withIdsOf } from '../document/solved';
import type { Dispatch } from '../editor/events';
import type { Solution, SolveReport } from '../editor/solution';
import type { EditorState } from '../editor/state';
import { asError, C2WarpError, codeOf, isAbort, isEngineFailure, TOO_MUCH } from '../error';
import type { Vec } from '../geometry/vec';
import type { TexturePatch } from '../render/picture';
import { say } from '../texts/wording';
import { SolutionDeformation } from './deformation';
import { editorError } from './editor_error';
import { fillPatch } from './fill_patch';

const gone = (): DOMException => new DOMException('the editor was removed', 'AbortError');

export class Solver {
  readonly #dispatch: Dispatch;
  readonly #solved = new Map<Solution, SolutionDeformation>();
  /** The last fill, by its key. */
  #fill: { readonly key: string; readonly patch: TexturePatch } | null = null;
  #engine: Promise<Engine> | null = null;
  #pixels: PixelSource | null = null;
  #disposed = false;

  constructor(dispatch: Dispatch) {
    this.#dispatch = dispatch;
  }

  /** The geometry of a solution that the state names. */
  deformationOf(solution: Solution): SolutionDeformation {
    const deformation = this.#solved.get(solution);
    if (!deformation) throw new Error('the solution was freed');
    return deformation;
  }

  usePicture(pixels: PixelSource | null): void {
    this.#pixels = pixels;
    this.#releaseFill();
    if (!pixels) return;
    this.#withEngine((engine) => engine.setPicture(pixels));
  }

  async solve(key: string, project: Project): Promise<void> {
    try {
      const engine = await this.#started();
      const data = await engine.solve(project, (stage) =>
        this.#dispatch({ type: 'solve-progressed', key, stage }),
      );
      if (this.#disposed) return;
      const deformation = new SolutionDeformation(engine.posedPicture(data, project), data);
      const solution: Solution = { key, project, report: reportOf(data), deformation };
      this.#solved.set(solution, deformation);
      this.#dispatch({ type: 'solved', solution });
    } catch (thrown) {
      this.#fail(key, asError(thrown));
    }
  }

  /** Fills the picture behind the rings of a solved project, unless the fill exists. */
  async fill(key: string, project: Project): Promise<void> {
    try {
      const engine = await this.#started();
      if (this.#fill?.key !== key) {
        const data = await engine.fill(project, (part) =>
          this.#dispatch({ type: 'fill-progressed', key, part }),
        );
        const patch = data && (await fillPatch(data));
        if (this.#disposed) return patch?.bitmap.close();
        this.#releaseFill();
        this.#fill = patch && { key, patch };
      }
      this.#dispatch({ type: 'filled', key });
    } catch (thrown) {
      const error = asError(thrown);
      if (!isAbort(error)) this.#dispatch({ type: 'fill-failed', key, error });
    }
  }

  stopFilling(): void {
    this.#withEngine((engine) => engine.stopFilling());
  }

  /** The fill that the state names, once it is available. */
  fillOf({ solution: { fill } }: EditorState): TexturePatch | null {
    return fill?.done && this.#fill?.key === fill.key ? this.#fill.patch : null;
  }

  #releaseFill(): void {
    this.#fill?.patch.bitmap.close();
    this.#fill = null;
  }

  async findBorders(solution: Solution): Promise<void> {
    try {
      const engine = await this.#started();
      const borders = await engine.cells(solution.project);
      this.#dispatch({ type: 'borders-found', solution, borders });
    } catch {
      // The picture was replaced, or the solver failed. The newest request reports that.
    }
  }

  /** Answers with null where the picture was replaced, or the solver failed: the newest request reports that. */
  async findStudy(solution: Solution): Promise<void> {
    const study = await this.#asked((engine) => engine.study(solution.project));
    this.#dispatch({ type: 'study-found', solution, study });
  }

  /** As {@link findStudy}. */
  async findLens(solution: Solution, at: Vec): Promise<void> {
    const lens = await this.#asked((engine) => engine.lens(solution.project, at));
    this.#dispatch({ type: 'lens-found', solution, at, lens });
  }

  /** Answers unless a newer suggestion, another picture or {@link stopSuggesting} ends this one. */
  async suggestHandles(project: Project): Promise<void> {
    try {
      const suggestion = await (await this.#started()).suggest(project);
      this.#dispatch({ type: 'handles-suggested', project, suggestion });
    } catch (thrown) {
      const error = asError(thrown);
      if (!isAbort(error)) this.#dispatch({ type: 'suggestion-failed', project, error });
    }
  }

  stopSuggesting(): void {
    this.#withEngine((engine) => engine.stopSuggesting());
  }

  /** A project for another picture, fitted to the present one: see `Engine.fit`. */
  async fit(project: Project, own: PixelSource | null): Promise<FittedProject> {
    return (await this.#started()).fit(project, own);
  }

  async #asked<T>(ask: (engine: Engine) => Promise<T>): Promise<T | null> {
    try {
      return await ask(await this.#started());
    } catch {
      return null;
    }
  }

  /**
   * Loads the part of the solver that draws, while the network is available. The first drawing reports why it is
   * missing.
   */
  prepareDrawing(): void {
    loadedLater().catch(() => {});
  }

  /** The warped picture, ready to be drawn: see `Engine.draw`. */
  async draw(project: Project, options: DrawingOptions, moment: ClipMoment | null = null): Promise<Drawing> {
    const engine = await this.#started();
    const known = this.#known(project);
    const at = moment && { ...moment, clip: known.clip(moment.clip) };
    return engine.draw(known.project, options, at);
  }

  /** The frames of a clip, ready to be drawn: see `Engine.film`. */
  async film(project: Project, clip: Clip, options: FilmOptions): Promise<Filming> {
    const engine = await this.#started();
    const known = this.#known(project);
    return engine.film(known.project, known.clip(clip), options);
  }

  /**
   * A project, and clips for it, with the ids that it was solved with. The worker compares ids too, and would solve
   * again for a handle that was only renamed.
   */
  #known(project: Project): { readonly project: Project; clip(clip: Clip): Clip } {
    const key = solveKey(project);
    const solved = [...this.#solved.keys()].findLast((solution) => solution.key === key)?.project;
    if (!solved) return { project, clip: (clip) => clip };
    return {
      project: withIdsOf(solved, project),
      clip: (clip) => clipWithIdsOf(solved, project, clip),
    };
  }

  /** Parses a project file. @throws C2WarpError with a message that names the invalid key. */
  async readProject(text: string): Promise<Project> {
    if (text.trim() === '') throw editorError('project', say('errors.emptyProject'));
    await this.#started();
    try {
      return drawable(checkedProject(text));
    } catch (error) {
      throw isEngineFailure(error)
        ? error
        : new C2WarpError('project', asError(error).message, { cause: error });
    }
  }

  /** Checks a project of the page. The engine must have started. @throws C2WarpError that names the invalid key. */
  checkProject(given: ProjectFile): Project {
    try {
      return drawable(checkedProject(JSON.stringify(given)));
    } catch (cause) {
      throw new C2WarpError('project', asError(cause).message, { cause });
    }
  }

  /** Frees the solutions that the state does not name. */
  freeUnused({ solution: { shown, recent } }: EditorState): void {
    for (const [solution, deformation] of this.#solved) {
      if (solution === shown || recent.includes(solution)) continue;
      deformation.free();
      this.#solved.delete(solution);
    }
  }

  dispose(): void {
    this.#disposed = true;
    this.#stop();
    this.#releaseFill();
    for (const deformation of this.#solved.values()) deformation.free();
    this.#solved.clear();
  }

  #started(): Promise<Engine> {
    if (this.#disposed) return Promise.reject(gone());
    this.#engine ??= this.#start();
    return this.#engine;
  }

  async #start(): Promise<Engine> {
    try {
      const engine = await Engine.start();
      if (this.#pixels) engine.setPicture(this.#pixels);
      this.#dispatch({ type: 'solver-started' });
      return engine;
    } catch (error) {
      this.#engine = null;
      throw error;
    }
  }

  #fail(key: string, error: Error): void {
    if (isAbort(error)) return;
    const failed = isEngineFailure(error);
    // An error without a code is one of the page's module. The solution causes the failure, for any reason.
    const reported =
      codeOf(error) === '' ? editorError(TOO_MUCH, say('errors.tooMuch.solve'), { cause: error }) : error;
    // The engine may have given up the picture: the next solve starts another.
    if (failed || reported !== error) this.#stop();
    this.#dispatch({ type: 'solve-refused', key, error: reported, failed });
  }

  /** Calls the engine, unless it has failed to start. */
  #withEngine(act: (engine: Engine) => void): void {
    this.#engine?.then(act, () => {});
  }

  #stop(): void {
    this.#withEngine((engine) => engine.dispose());
    this.#engine = null;
  }
}

const reportOf = ({ report }: SolutionData): SolveReport => ({
  samples: report.samples,
  virtualSites: report.virtual_sites,
  outside: report.outside ?? [],
  outline: report.outline,
  bridgedGap: report.bridged_gap,
  looseParts: report.loose_islands,
  ms: Object.values(report.ms).reduce((sum, stage) => sum + stage, 0),
  times: report.ms,
});

/** Refuses a project that is valid as a file but has a handle that cannot be drawn. */
function drawable(project: Project): Project {
  project.handles.forEach(checkedHandle);
  return project;
}
