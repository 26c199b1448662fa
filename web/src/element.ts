/**
 * `<c2-warp>`: the editor as a custom element.
 *
 * Attributes: `src`, `project` (addresses), `tool`, `readonly`, `disabled`, `theme` (light, dark), `hint` and
 * `hint-for` (what a first visitor is told, and the handle it is about), `autosave` (a key of the browser's storage). Events: `ready`, `load`, `input` while dragging,
 * `change` once committed, `selectionchange`, `historychange`, `progress`, `error`. Several may live on one page; one that
 * is removed gives back its worker and its WebGL context, and has its document still when it comes back. Importing this
 * file where there is no DOM does nothing.
 */
import { LitElement, type PropertyValues, type TemplateResult } from 'lit';
import { handleById } from './document/document';
import { addHandle, changeHandles, freeId, removeHandles } from './document/edits';
import { checkedHandle } from './document/handle';
import {
  type Handle,
  type HandleFile,
  type Project,
  type ProjectFile,
  posedHandle,
  posedProject,
} from './document/project';
import { Desk } from './element/desk';
import type { ChangeKind } from './element/editing';
import { Focusing } from './element/focusing';
import { fits } from './element/picture';
import { Receiving } from './element/receiving';
import type { Kept } from './element/workbench';
import type { Vec } from './geometry/vec';
import { isToolName } from './tools/machine';
import { chromeStyle } from './ui/chrome-style';
import { layout } from './ui/layout';
import { shell } from './ui/shell';
import { stageStyle } from './ui/stage-style';
import { theme } from './ui/theme';

/** A handle that may leave its name to the editor. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

export class C2Warp extends LitElement {
  static override styles = [theme, layout, stageStyle, chromeStyle];

  static override properties = {
    src: {},
    projectSource: { attribute: 'project' },
    tool: {},
    readonly: { type: Boolean, reflect: true },
    disabled: { type: Boolean, reflect: true },
    theme: { reflect: true },
    hint: {},
    hintFor: { attribute: 'hint-for' },
    autosave: {},
  };

  declare src: string | null;
  declare projectSource: string | null;
  declare tool: string | null;
  declare readonly: boolean;
  declare disabled: boolean;
  declare theme: string | null;
  declare hint: string | null;
  declare hintFor: string | null;
  declare autosave: string | null;

  #desk: Desk | null = null;
  /** What was open when the element left the page. */
  #left: Kept | null = null;
  #receiving: Receiving | null = null;
  #focusing: Focusing | null = null;
  #attached = false;
  #past: string | null = null;
  #future: string | null = null;

  constructor() {
    super();
    this.src = null;
    this.projectSource = null;
    this.tool = null;
    this.readonly = false;
    this.disabled = false;
    this.theme = null;
    this.hint = null;
    this.hintFor = null;
    this.autosave = null;
  }

  /** The project as it is now. Setting one for the open picture is a step that can be undone. */
  get project(): Project {
    return this.#present.workbench.editing.project;
  }

  set project(given: ProjectFile) {
    const { workbench } = this.#present;
    const project = posedProject(given);
    project.handles.forEach(checkedHandle);
    if (!workbench.picture || !fits(workbench.picture, project)) {
      throw new RangeError('the project is for a picture of another size: load both together');
    }
    workbench.adopt(project, 'Set project');
  }

  /** Ids of the selected handles. */
  get selection(): readonly string[] {
    return this.#present.workbench.editing.document.selection;
  }

  set selection(ids: readonly string[]) {
    this.#present.workbench.editing.select(ids);
  }

  /**
   * Opens a picture, with a project for it or a new one. Done once it is solved.
   * @throws Error with a code where it cannot be opened; what was open before stays. DOMException AbortError where another is
   * opened, or the element removed, before that.
   */
  async load(source: string | Blob, project?: string | ProjectFile): Promise<void> {
    await this.#present.files.load(source, typeof project === 'object' ? posedProject(project) : project);
    this.#emit('load');
  }

  /**
   * Adds a handle; without an id it gets one. Returns the id.
   * @throws RangeError for an id that is taken, and where a number is none or out of its range.
   */
  addHandle(handle: NewHandle): string {
    const { editing } = this.#present.workbench;
    const id = handle.id ?? freeId(editing.project);
    if (handleById(editing.document, id)) throw new RangeError(`there is a handle "${id}" already`);
    const added = checkedHandle(posedHandle({ ...handle, id } as HandleFile));
    editing.step('Add handle', addHandle(editing.document, added));
    return id;
  }

  /** @throws RangeError where there is no such handle, and where a number is none or out of its range. */
  updateHandle(id: string, change: Partial<Omit<Handle, 'id' | 'kind'>>): void {
    const { editing } = this.#present.workbench;
    const changed = checkedHandle({ ...this.#handle(id), ...change } as Handle);
    editing.step(
      'Change handle',
      changeHandles(editing.document, [id], () => changed),
    );
  }

  /** @throws RangeError where there is no such handle. */
  removeHandle(id: string): void {
    const { editing } = this.#present.workbench;
    editing.step('Delete handle', removeHandles(editing.document, [this.#handle(id).id]));
  }

  undo(): void {
    this.#present.workbench.editing.undo();
  }

  redo(): void {
    this.#present.workbench.editing.redo();
  }

  /** Puts all handles back to rest. */
  reset(): void {
    this.#present.workbench.editing.reset(true);
  }

  /** Where a point of the original goes, in image pixels; null outside what is warped. */
  mapPoint(point: Vec): Vec | null {
    return this.#present.posing.map(point)?.rest ?? null;
  }

  /** The warped picture as PNG with alpha, at `scale` times the source's size. */
  toBlob(scale = 1): Promise<Blob> {
    return this.#present.workbench.png(scale);
  }

  /** The whole picture into view. */
  fit(): void {
    this.#present.run('fit');
  }

  /** Leaves the page for good. */
  destroy(): void {
    this.remove();
    this.#left = null;
  }

  /** Keys go to the editor. */
  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>('.shell')?.focus(options);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const element = this;
    this.#attached = false;
    this.#desk = new Desk(
      {
        get root() {
          return element.renderRoot as ShadowRoot;
        },
        get readonly() {
          return element.readonly;
        },
        get disabled() {
          return element.disabled;
        },
        get dark() {
          return element.#dark;
        },
        get hint() {
          return element.hint ? { text: element.hint, handle: element.hintFor } : null;
        },
        changed: () => this.requestUpdate(),
        edited: (kind) => this.#edited(kind),
        emit: (type, detail) => this.#emit(type, detail),
        switchTheme: () => {
          this.theme = this.#dark ? 'light' : 'dark';
        },
      },
      this.autosave,
    );
    this.#receiving = new Receiving(
      this,
      () => !this.readonly && !this.disabled,
      (files) => void this.#desk?.files.receive(files),
    );
    this.#focusing = new Focusing(this);
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#receiving?.release();
    this.#focusing?.release();
    this.#left = this.#desk?.workbench.kept ?? this.#left;
    this.#desk?.dispose();
    this.#desk = null;
  }

  protected override render(): TemplateResult | null {
    const desk = this.#desk;
    if (!desk) return null;
    return shell({ ...desk.model, platform: navigator.platform }, desk.actions, desk.canvas);
  }

  protected override updated(changes: PropertyValues): void {
    const desk = this.#desk;
    if (!desk) return;
    this.#focusing?.repair();
    if (isToolName(this.tool) && changes.has('tool')) desk.choose(this.tool);
    if (!this.#attached) {
      this.#attached = true;
      const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
      if (stage) desk.attach(stage);
      void this.#begin(desk);
    } else if (changes.has('src') && this.src) {
      void this.#open(desk, this.src);
    }
  }

  #handle(id: string): Handle {
    const handle = handleById(this.#present.workbench.editing.document, id);
    if (!handle) throw new RangeError(`there is no handle "${id}"`);
    return handle;
  }

  get #present(): Desk {
    if (!this.#desk) throw new Error('<c2-warp> is not on a page');
    return this.#desk;
  }

  get #dark(): boolean {
    if (this.theme === 'dark' || this.theme === 'light') return this.theme === 'dark';
    return matchMedia('(prefers-color-scheme: dark)').matches;
  }

  /** What was open before, what was kept, or what the attributes name. */
  async #begin(desk: Desk): Promise<void> {
    try {
      if (this.#left) await desk.files.restore(this.#left);
      else if (!(await desk.restore()) && this.src)
        await desk.files.load(this.src, this.projectSource ?? undefined);
      this.#emit('load');
    } catch (error) {
      if (desk !== this.#desk) return;
      desk.talking.report(error);
    }
    this.#emit('ready');
  }

  async #open(desk: Desk, source: string): Promise<void> {
    try {
      await desk.files.load(source, this.projectSource ?? undefined);
      this.#emit('load');
    } catch (error) {
      desk.talking.report(error);
    }
  }

  #edited(kind: ChangeKind): void {
    if (kind === 'selection') this.#emit('selectionchange', { selection: this.selection });
    else if (kind !== 'open') this.#emit(kind, { project: this.project });
    const { undoLabel, redoLabel } = this.#present.workbench.editing;
    if (undoLabel === this.#past && redoLabel === this.#future) return;
    [this.#past, this.#future] = [undoLabel, redoLabel];
    this.#emit('historychange', { undo: undoLabel, redo: redoLabel });
  }

  #emit(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

if (typeof customElements !== 'undefined' && !customElements.get('c2-warp')) {
  customElements.define('c2-warp', C2Warp);
}

declare global {
  interface HTMLElementTagNameMap {
    'c2-warp': C2Warp;
  }
}
