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
import { isAbort } from './latest';
import type { Kept } from './workbench';

export interface InitialContentHost {
  readonly src: string | null;
  readonly projectSource: string | null;
  /** The current desk; null while the element is not connected. */
  readonly desk: Desk | null;
  readonly emit: Emit;
}

/** Whether an error is about the project, not about its picture, the solver, or something newer. */
const isOfProject = (error: unknown): boolean =>
  !isAbort(error) &&
  !isEngineFailure(error) &&
  !['address', 'file', 'picture'].includes((error as { code?: string }).code ?? '');

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

  /** Whether the attributes have changed, and what they name is not open yet. */
  get asks(): boolean {
    return this.#asked !== null;
  }

  /**
   * Opens a picture with the given project, or else with the one that was set before. That one waits on where it was not
   * to blame.
   */
  async load(
    { files }: Desk,
    source: string | Blob,
    given?: string | ProjectFile | null,
    signal?: AbortSignal,
  ): Promise<void> {
    const { project } = this;
    try {
      await files.load(source, given ?? project ?? undefined, signal);
    } catch (error) {
      if (!given && project === this.project && isOfProject(error)) this.project = null;
      throw error;
    }
  }

  /** Opens the initial content after a connection, and emits `ready`. */
  async begin(desk: Desk, signal: AbortSignal): Promise<void> {
    const left = this.#left;
    const asked = this.#asked;
    let unread: unknown;
    const opened = await this.#open(desk, async () => {
      if (asked) return this.#attributes(desk, signal);
      if (left) await desk.reopen(left);
      else if (!(await desk.restore((error) => (unread = error)))) return this.#attributes(desk, signal);
      return true;
    });
    // The new picture could not be opened: return to the previous one.
    if (asked && left && !opened && !signal.aborted) {
      await this.#open(desk, async () => {
        await desk.reopen(left);
        return true;
      });
    }
    if (unread && desk === this.#host.desk) desk.notices.report(unread);
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
      await desk.reopen(kept);
      return true;
    });
  }

  /** Applies to the open picture what the page set before; `given`, it came with a project. */
  settle({ workbench, notices }: Desk, given: boolean): void {
    const { project, selection } = this;
    this.project = null;
    this.selection = null;
    try {
      if (project && !given) workbench.set(project);
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
    // What is overtaken asks for nothing, and is no answer to what was asked since.
    signal.throwIfAborted();
    const asked = this.#asked;
    try {
      await this.load(desk, src, this.project ?? projectSource, signal);
    } finally {
      if (desk === this.#host.desk && asked === this.#asked) this.#asked = null;
    }
    return true;
  }
}
