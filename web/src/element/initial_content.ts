/**
 * What the element opens by itself: its attributes, stored work, and what was open when it was disconnected.
 *
 * Outlives the desk, so that nothing is lost when the element is moved, or set up before it is connected.
 */
import { isEngineFailure } from '../compute/errors';
import type { ProjectFile } from '../document/project';
import type { Desk } from './desk';
import type { Emit } from './events';
import type { Aside } from './files';
import type { Kept } from './workbench';

export interface InitialContentHost {
  readonly src: string | null;
  readonly projectSource: string | null;
  /** The current desk; null while the element is not connected. */
  readonly desk: Desk | null;
  readonly emit: Emit;
}

const nothing = (): Aside => ({ awaiting: null, left: [] });

export class InitialContent {
  /** Set by the page before there was a picture. */
  project: ProjectFile | null = null;
  selection: readonly string[] | null = null;
  aside = nothing();
  readonly #host: InitialContentHost;
  #left: Kept | null = null;
  /** Identifies the last change of the attributes that is not open yet; null if there is none. */
  #asked: symbol | null = null;

  constructor(host: InitialContentHost) {
    this.#host = host;
  }

  /** Notes that the attributes have changed, for `open` or, while disconnected, the next `begin`. */
  ask(): void {
    this.#asked = Symbol();
  }

  leave(kept: Kept | null): void {
    this.#left = kept ?? this.#left;
  }

  forget(): void {
    this.#left = null;
    this.aside = nothing();
  }

  /** Takes the project that was set before there was a picture: later calls return undefined. */
  taken(): ProjectFile | undefined {
    const { project } = this;
    this.project = null;
    return project ?? undefined;
  }

  /** Opens the initial content after a connection, and emits `ready`. */
  async begin(desk: Desk, signal: AbortSignal): Promise<void> {
    const left = this.#left;
    const asked = this.#asked;
    const opened = await this.#open(desk, async () => {
      if (asked) return this.#attributes(desk, signal);
      if (left) await desk.reopen(left, signal);
      else if (!(await desk.restore(signal))) return this.#attributes(desk, signal);
      return true;
    });
    // The new picture could not be opened: return to the previous one.
    if (asked && left && !opened) {
      await this.#open(desk, async () => {
        await desk.reopen(left, signal);
        return true;
      });
    }
    if (desk === this.#host.desk) this.#host.emit('ready', null);
  }

  /** Opens what the changed attributes name. */
  async open(desk: Desk): Promise<void> {
    const signal = desk.files.overtake();
    await this.#open(desk, () => this.#attributes(desk, signal));
  }

  /** Opens again what the solver has failed at: the shown picture with the work on it, or what the attributes name. */
  async again(desk: Desk): Promise<void> {
    const signal = desk.files.overtake();
    const { kept } = desk.workbench;
    await this.#open(desk, async () => {
      if (!kept) return this.#attributes(desk, signal);
      await desk.reopen(kept, signal);
      return true;
    });
  }

  /** Applies to the open picture what the page set before. */
  settle({ workbench, notices }: Desk): void {
    const [project, selection] = [this.taken(), this.selection];
    this.selection = null;
    try {
      if (project) workbench.set(project);
    } catch (error) {
      notices.report(error);
    }
    if (selection) workbench.editing.select(selection);
  }

  /**
   * Emits `load` or reports the error.
   * @param opening resolves to false if there was nothing to open.
   * @returns whether something was opened.
   */
  async #open(desk: Desk, opening: () => Promise<boolean>): Promise<boolean> {
    try {
      if (!(await desk.files.shown(opening)) || desk !== this.#host.desk) return false;
    } catch (error) {
      // After a disconnection the next `begin` tries again.
      if (desk === this.#host.desk) desk.notices.report(error);
      return false;
    }
    this.#host.emit('load', null);
    return true;
  }

  async #attributes(desk: Desk, signal: AbortSignal): Promise<boolean> {
    const { src, projectSource } = this.#host;
    if (!src) return false;
    const [asked, project] = [this.#asked, this.taken()];
    try {
      await desk.files.load(src, project ?? projectSource ?? undefined, signal);
    } catch (error) {
      // After a disconnection, or without a solver, the project is still needed, unless the page has set a newer one.
      if (desk !== this.#host.desk || isEngineFailure(error)) this.project ??= project ?? null;
      throw error;
    } finally {
      if (desk === this.#host.desk && asked === this.#asked) this.#asked = null;
    }
    return true;
  }
}
