/**
 * What the element opens by itself: what its attributes name, what was kept, and what was open when it left a page.
 *
 * It outlasts the desk, so that nothing is lost where the element is moved or set up before it comes to a page.
 */
import type { ProjectFile } from '../document/project';
import type { Desk } from './desk';
import type { Emit } from './events';
import type { Aside } from './files';
import type { Turn } from './turn';
import type { Kept } from './workbench';

export interface BeginningHost {
  readonly src: string | null;
  readonly projectSource: string | null;
  /** Where the element is now; null while it is on no page. */
  readonly desk: Desk | null;
  readonly emit: Emit;
}

const nothing = (): Aside => ({ awaiting: null, left: [] });

export class Beginning {
  /** What a page has set while there was no picture for it. */
  project: ProjectFile | null = null;
  selection: readonly string[] | null = null;
  aside = nothing();
  readonly #host: BeginningHost;
  #left: Kept | null = null;
  /** What the attributes name anew since the element began, and that is not open yet. Each change is another. */
  #asked: symbol | null = null;

  constructor(host: BeginningHost) {
    this.#host = host;
  }

  /** What the attributes name is to be opened, as soon as the element is on a page. */
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

  /** The project that was set for a picture still to come; it is handed out once. */
  taken(): ProjectFile | undefined {
    const { project } = this;
    this.project = null;
    return project ?? undefined;
  }

  /** On a page. */
  async begin(desk: Desk, turn: Turn): Promise<void> {
    const left = this.#left;
    const asked = this.#asked;
    const opened = await this.#open(desk, async () => {
      if (asked) return this.#attributes(desk, turn);
      if (left) await desk.reopen(left, turn);
      else if (!(await desk.restore(turn))) return this.#attributes(desk, turn);
      return true;
    });
    // Where the new picture is not to be had, the one before it stays.
    if (asked && left && !opened) {
      await this.#open(desk, async () => {
        await desk.reopen(left, turn);
        return true;
      });
    }
    if (desk === this.#host.desk) this.#host.emit('ready', null);
  }

  /** On the same page, when the attributes have changed. */
  async open(desk: Desk): Promise<void> {
    const turn = desk.files.turn();
    await this.#open(desk, () => this.#attributes(desk, turn));
  }

  /** A picture is open: what the page has set meanwhile is for it. */
  settle({ workbench, talking }: Desk): void {
    const [project, selection] = [this.taken(), this.selection];
    this.selection = null;
    try {
      if (project) workbench.set(project);
    } catch (error) {
      talking.report(error);
    }
    if (selection) workbench.editing.select(selection);
  }

  /** Tells the page what came of it. @param opening whether there was anything to open. @returns whether it is open. */
  async #open(desk: Desk, opening: () => Promise<boolean>): Promise<boolean> {
    try {
      if (!(await desk.files.shown(opening)) || desk !== this.#host.desk) return false;
    } catch (error) {
      // Gone from the page, it is opened on the next.
      if (desk === this.#host.desk) desk.talking.report(error);
      return false;
    }
    this.#host.emit('load', null);
    return true;
  }

  async #attributes(desk: Desk, turn: Turn): Promise<boolean> {
    const { src, projectSource } = this.#host;
    if (!src) return false;
    const [asked, project] = [this.#asked, this.taken()];
    try {
      await desk.files.load(src, project ?? projectSource ?? undefined, turn);
    } catch (error) {
      // Gone from the page, it is asked for still; and what is newer by now stays.
      if (desk !== this.#host.desk) this.project ??= project ?? null;
      throw error;
    } finally {
      if (desk === this.#host.desk && asked === this.#asked) this.#asked = null;
    }
    return true;
  }
}
