/**
 * Picture, document and solution, kept consistent with one another.
 *
 * Nothing that the solver refuses stays. If a picture or project cannot be opened, the previous one comes back. A
 * handle that cannot be solved is taken back throughout the history, even that of a document just opened; any other
 * edit is taken back together with what was done since. The host shows the result.
 */
import { EngineError } from '../compute/errors';
import { checkedProject } from '../compute/module';
import type { Pixels } from '../compute/solution';
import { type Document, isSameWork, newProject, openDocument } from '../document/document';
import { checkedHandle } from '../document/handle';
import { History, type HistoryRecord } from '../document/history';
import type { Project, ProjectFile } from '../document/project';
import { projectText } from '../document/project_text';
import { solveKey } from '../document/solved';
import { alphaThreshold } from '../io/alpha';
import { preparePng } from '../io/encode';
import { PictureError } from '../io/picture_error';
import { isPixelArt } from '../io/pixel_art';
import type { Drawings } from '../tools/machine';
import { EditCommands } from './edit_commands';
import { Editing, type EditingHost } from './editing';
import { Guarding } from './guarding';
import { misfit, type Picture, stem } from './picture';
import { Posing } from './posing';
import { inEditorsWords } from './refusing';
import { type Solved, Solving } from './solving';
import type { Look } from './viewing';

export interface WorkbenchHost extends EditingHost {
  /** The current view. */
  readonly look: Look;
  /** Another picture is open, or none. @param look the view of this picture when it was last open. */
  opened(picture: Picture | null, look?: Look): void;
  /** @param first whether this is the first solution of the picture. */
  solved(solved: Solved, first: boolean): void;
  /** Shows a long operation; `cancel` is null if it cannot be cancelled. Returns a function that ends the display. */
  begin(label: string, cancel: (() => void) | null): () => void;
  report(error: Error): void;
}

/** A person's work on one picture. */
export interface Work {
  readonly record: HistoryRecord<Document>;
  /** Unfinished bars and polygons. */
  readonly drawings?: Drawings;
  readonly look?: Look;
  /** Whether it is drawn as pixel art; without it, the picture decides. */
  readonly pixelated?: boolean;
}

export const isWorkedOn = ({ record, drawings = [] }: Work): boolean =>
  record.past.length + drawings.length > 0;

/** Everything needed to open a closed picture again. */
export interface Kept extends Work {
  readonly file: Blob;
  readonly name: string;
  /** Whether the guard against folds was on. */
  readonly guarded: boolean;
}

interface Opening {
  readonly before: { readonly picture: Picture; readonly work: Work } | null;
  /** The picture if it came without a project, else null. */
  readonly fresh: Picture | null;
  resolve(): void;
  reject(error: Error): void;
}

const NOTHING = openDocument(newProject({ src: '', width: 1, height: 1 }, null));

export class Workbench {
  readonly solving: Solving;
  readonly posing: Posing;
  readonly guarding: Guarding;
  readonly editing: Editing;
  readonly commands: EditCommands;
  /** Whether the open picture is drawn as pixel art. */
  pixelated = false;
  readonly #host: WorkbenchHost;
  #picture: Picture | null = null;
  #opening: Opening | null = null;
  /** Whether the solver has started, so that `set` can check a project at once. */
  #started = false;

  constructor(host: WorkbenchHost) {
    this.#host = host;
    this.solving = new Solving({
      solved: (solved, first) => this.#solved(solved, first),
      refused: (key, error) => this.#refused(key, error),
      failed: (error) => this.#failed(error),
      // The first solve cannot be cancelled: there is no solution to return to.
      begin: (label) => host.begin(label, this.solving.current && (() => this.cancelSolve())),
    });
    const history = new History(NOTHING, isSameWork);
    this.posing = new Posing(history, this.solving);
    this.guarding = new Guarding(this.posing);
    this.editing = new Editing(history, this.posing, this.guarding, {
      edited: (kind) => {
        // A solver that has failed is asked again at the end of a drag, not at each of its moves.
        const solves = kind === 'input' ? !this.solving.failed : kind !== 'selection' && kind !== 'pose';
        if (solves) this.solving.want(this.editing.project);
        host.edited(kind);
      },
      say: (text) => host.say(text),
      carryOut: (effect) => host.carryOut(effect),
    });
    this.commands = new EditCommands(this.editing, this.posing, this.guarding, (text) => host.say(text));
  }

  get picture(): Picture | null {
    return this.#picture;
  }

  /** The open picture and its work; while another picture is being opened, the previous ones. */
  get kept(): Kept | null {
    const open = this.#opening ? this.#opening.before : this.#picture && this.#snapshot(this.#picture);
    if (!open) return null;
    const { file, name } = open.picture;
    return { file, name, ...open.work, guarded: this.guarding.on };
  }

  /**
   * Opens a picture, with earlier work on it or a new project. Resolves once the picture is solved.
   * @throws Error with a `code` if the solver refuses it; the previous picture comes back.
   */
  open(picture: Picture, work?: Work): Promise<void> {
    this.#opening?.reject(new DOMException('another picture was opened', 'AbortError'));
    // What is opened once more, as it could not be solved, is no way back from itself.
    const again = this.#picture?.file === picture.file && !this.solving.current;
    const last = again ? null : this.#picture;
    const before = last && !this.#opening ? this.#snapshot(last) : (this.#opening?.before ?? null);
    return new Promise((resolve, reject) => {
      this.#opening = { before, fresh: work ? null : picture, resolve, reject };
      this.#put(picture, work ?? this.#fresh(picture));
      this.solving.engine().then(
        () => {
          this.#started = true;
        },
        () => {},
      );
    });
  }

  /** Replaces the project of the open picture, as an undoable step. */
  adopt(project: Project, label: string): void {
    this.editing.step(label, openDocument(project));
  }

  /** Whether the shown solution, if any, is not that of the present project. */
  get isUnsolved(): boolean {
    return this.solving.current?.key !== solveKey(this.editing.project);
  }

  /** Whether a project can be set: a picture is open and the solver has started. */
  get isOpen(): boolean {
    return this.#picture !== null && this.#started;
  }

  /**
   * Adopts a copy of a page's own project object, after checking it.
   * @throws RangeError that names the invalid key, or if no picture of that size is open.
   */
  set(given: ProjectFile): void {
    if (!this.#started || !this.#picture)
      throw new RangeError('there is no picture yet to set a project for');
    const project = this.#made(given);
    const error = misfit(this.#picture, project);
    if (error) throw error;
    this.adopt(project, 'Set project');
  }

  /** Parses a project file. @throws Error with a `code` and a message that names the invalid key. */
  async readProject(text: string): Promise<Project> {
    if (text.trim() === '') throw Object.assign(new Error('the file is empty'), { code: 'project' });
    await this.solving.engine();
    return checked(checkedProject(text));
  }

  /** The open project as a file, named after the picture. */
  projectFile(): { readonly name: string; readonly blob: Blob } {
    const { project } = this.editing;
    const image = { ...project.image, src: this.#picture?.name ?? project.image.src };
    const blob = new Blob([projectText({ ...project, image })], { type: 'application/json' });
    return { name: `${stem(image.src)}.c2warp.json`, blob };
  }

  /**
   * The warped picture in straight alpha, at `scale` times the source's size, or grown to what is bent beyond that;
   * `pixelated`, no colours are mixed.
   */
  async warped(scale: number, grow: boolean, pixelated: boolean): Promise<Pixels> {
    if (!this.#picture) throw new PictureError('There is no picture yet.');
    // The pose of the call: the page may go on to the next one meanwhile.
    const { project } = this.editing;
    const engine = await this.solving.engine();
    return engine.warp(project, scale, grow, pixelated);
  }

  /** Cancels the running solve, and takes back the edit, undo or redo that required it. */
  cancelSolve(): void {
    const { pending, current } = this.solving;
    if (pending === null || this.#opening) return;
    if (!current || !this.editing.turnBack(current.key)) this.editing.withdraw(pending);
    this.#host.say('Cancelled');
  }

  dispose(): void {
    this.#opening?.before?.picture.bitmap.close();
    this.#opening?.reject(new DOMException('the editor is gone', 'AbortError'));
    this.solving.dispose();
    this.#picture?.bitmap.close();
  }

  #made(given: ProjectFile): Project {
    try {
      return checked(checkedProject(JSON.stringify(given)));
    } catch (cause) {
      throw cause instanceof RangeError ? cause : new RangeError((cause as Error).message, { cause });
    }
  }

  #snapshot(picture: Picture): NonNullable<Opening['before']> {
    const { editing } = this;
    const { drawings } = editing.machine;
    const { pixelated } = this;
    const work = { record: editing.record(), drawings, look: this.#host.look, pixelated };
    return { picture, work };
  }

  #fresh(picture: Picture): Work {
    const { name: src, width, height } = picture;
    const present = openDocument(newProject({ src, width, height }, alphaThreshold(picture)));
    return { record: { past: [], present, future: [] } };
  }

  #put(picture: Picture, { record, drawings, look, pixelated }: Work): void {
    this.pixelated = pixelated ?? isPixelArt(picture);
    // First, so that this picture is not fitted with the bounds of the previous one.
    this.solving.setPicture(picture);
    this.#show(picture, look);
    this.editing.open(record, drawings);
  }

  #show(picture: Picture | null, look?: Look): void {
    const last = this.#picture;
    this.#picture = picture;
    this.posing.forget();
    this.#host.opened(picture, look);
    if (last !== picture && last !== this.#opening?.before?.picture) last?.bitmap.close();
  }

  #solved(solved: Solved, first: boolean): void {
    const opening = this.#opening;
    this.#opening = null;
    this.#started = true;
    this.posing.forget();
    this.#host.solved(solved, first);
    if (!opening) return;
    opening.before?.picture.bitmap.close();
    opening.resolve();
    preparePng();
  }

  #refused(key: string, error: Error): void {
    const opening = this.#opening;
    const named = error instanceof EngineError ? error.handles : [];
    // Restored work may contain a step that was never solved: only that step goes.
    const left = this.editing.withdraw(key, named, this.solving.current?.project ?? null);
    if (left || !opening) {
      // Neither with the project that it came with nor without: there is nothing to hold.
      if (!left && !this.solving.current) this.#close();
      this.#host.report(error);
      return;
    }
    this.#opening = null;
    if (opening.before) this.#put(opening.before.picture, opening.before.work);
    else if (this.#picture && this.editing.project.handles.length > 0) {
      this.#put(this.#picture, this.#fresh(this.#picture));
    } else this.#close();
    opening.reject(opening.fresh ? inEditorsWords(error, opening.fresh.name) : error);
  }

  #close(): void {
    this.solving.setPicture(null);
    this.#show(null);
  }

  #failed(error: Error): void {
    const opening = this.#opening;
    this.#opening = null;
    if (opening?.before) this.#put(opening.before.picture, opening.before.work);
    if (opening) opening.reject(error);
    else this.#host.report(error);
  }
}

/** Refuses a project that is valid as a file but has a handle that cannot be drawn. */
function checked(project: Project): Project {
  try {
    project.handles.forEach(checkedHandle);
    return project;
  } catch (error) {
    throw Object.assign(error as Error, { code: 'project' });
  }
}
