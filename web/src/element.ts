/**
 * `<c2-warp>`: the editor as a custom element.
 *
 * | attribute | |
 * |---|---|
 * | `src` | the address of the picture; a new one is opened in place of what is open |
 * | `project` | the address of the project file that goes with `src`: the two are opened together, and anew when either is set to another |
 * | `tool` | `select`, `point`, `bar`, `polygon` or `hand`: taken up when it is set, when the element comes to a page, and when it is no longer `readonly` or `play` |
 * | `readonly` | people look, pan and zoom, and change nothing; methods do |
 * | `disabled` | people can do nothing |
 * | `play` | the picture and its handles alone, for an article: people pose the handles that are there and nothing else, and the page keeps the wheel, the fingers and the keys that hold none. `readonly` as well: the picture alone |
 * | `theme` | `light` or `dark`; left out: as the system has it |
 * | `hint`, `hint-for` | what a first visitor is told, and the id of the handle that it is about |
 * | `autosave` | a key of the browser's storage: what is open is kept there after every step, and comes back in place of the first `src` |
 *
 * | event | |
 * |---|---|
 * | `ready` | the element has come to a page, and what it begins with is open, or there is nothing, or it could not be opened or was given up |
 * | `load` | a picture is open and solved: by `src`, by `load()`, kept by `autosave`, or again where the element was moved; not where a person opens one |
 * | `input` | within a drag; `detail.project` is a copy of the project |
 * | `change` | a step was done, undone or redone, by a person or by a method; `detail.project` likewise |
 * | `selectionchange` | `detail.selection`: the ids, whatever changed them |
 * | `historychange` | `detail.undo`, `detail.redo`: what would be undone or redone, or null |
 * | `progress` | `detail.label`: what the solver is at, or that a PNG is being exported; null when it is done; for what takes longer than a person notices |
 * | `error` | `detail`: the Error of what went wrong that no method was asked for, or that was known only once it had returned |
 *
 * The `code` of an Error says why something cannot be opened: `address` (no such file, or no network), `file` (a folder, or a file that
 * is gone), `picture` (no picture, or none that can be opened), `project` (its message names the key), `image-size` (a project for a picture of another size), `engine`
 * (the solver could not be started), or what the solver refuses, such as `handle-outside`; then `handles` are the ids of the handles that
 * its message names.
 *
 * Setting `readonly`, `disabled` or `play`, and taking `play` away, gives up the drag, the drawing or the number that a person is in the
 * midst of. Several elements may live on one page; one that is removed gives back its worker and its WebGL context, and has its document
 * still when it comes back. Properties may be set before the element is on a page, or known to it at all. Importing this file where there
 * is no DOM does nothing.
 */
import type { PropertyValues, TemplateResult } from 'lit';
import { handleById } from './document/document';
import { addHandle, changeHandles, freeId, removeHandles } from './document/edits';
import { checkedHandle } from './document/handle';
import {
  copied,
  type Handle,
  type HandleFile,
  type Project,
  type ProjectFile,
  posedHandle,
} from './document/project';
import { Beginning } from './element/beginning';
import { Desk } from './element/desk';
import type { ChangeKind } from './element/editing';
import { emitter, TypedElement } from './element/events';
import { Focusing } from './element/focusing';
import { Receiving } from './element/receiving';
import type { Turn } from './element/turn';
import type { Vec } from './geometry/vec';
import { isToolName } from './tools/machine';
import { chromeStyle } from './ui/chrome-style';
import { forcedStyle } from './ui/forced-style';
import { layout } from './ui/layout';
import { playStyle } from './ui/play-style';
import { shell } from './ui/shell';
import { stageStyle } from './ui/stage-style';
import { theme } from './ui/theme';
import { touchStyle } from './ui/touch-style';

export type { Handle, HandleFile, Project, ProjectFile } from './document/project';
export type { C2WarpEventMap } from './element/events';

/** A handle that may leave its name to the editor. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

export class C2Warp extends TypedElement {
  static override styles = [theme, layout, stageStyle, chromeStyle, touchStyle, playStyle, forcedStyle];

  static override properties = {
    src: {},
    projectSource: { attribute: 'project' },
    tool: {},
    readonly: { type: Boolean, reflect: true },
    disabled: { type: Boolean, reflect: true },
    play: { type: Boolean, reflect: true },
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
  declare play: boolean;
  declare theme: string | null;
  declare hint: string | null;
  declare hintFor: string | null;
  declare autosave: string | null;

  readonly #emit = emitter(this);
  readonly #beginning: Beginning;
  #desk: Desk | null = null;
  /** To open what the element begins with. Whatever is asked for from its arrival on comes after that. */
  #turn: Turn | null = null;
  #receiving: Receiving | null = null;
  #focusing: Focusing | null = null;
  /** What was last told of. */
  #selected = '';
  #past: string | null = null;
  #future: string | null = null;

  constructor() {
    super();
    this.src = null;
    this.projectSource = null;
    this.tool = null;
    this.readonly = false;
    this.disabled = false;
    this.play = false;
    this.theme = null;
    this.hint = null;
    this.hintFor = null;
    this.autosave = null;
    const element = this;
    this.#beginning = new Beginning({
      get src() {
        return element.src;
      },
      get projectSource() {
        return element.projectSource;
      },
      get desk() {
        return element.#desk;
      },
      emit: this.#emit,
    });
    this.#adopt('project');
    this.#adopt('selection');
  }

  /**
   * A copy of the project as it is now. Setting one for the open picture is a step that can be undone; one that is set before there
   * is a picture waits for it, whoever brings it; one of another size is an `error` then. A text is the address of a project file, as the attribute is.
   * @throws RangeError that names what is wrong with it; Error when read while the element is on no page.
   */
  get project(): Project {
    return copied(this.#present.workbench.editing.project);
  }

  set project(given: ProjectFile | string | null) {
    this.#beginning.project = null;
    if (given === null || typeof given !== 'object') this.projectSource = given ?? null;
    else if (this.#desk?.workbench.isOpen) this.#desk.workbench.set(given);
    else this.#beginning.project = copied(given);
  }

  /** Ids of the selected handles. Those set before there is a picture wait for it likewise. */
  get selection(): readonly string[] {
    return [...this.#present.workbench.editing.document.selection];
  }

  set selection(ids: readonly string[]) {
    if (!Array.isArray(ids)) throw new TypeError('selection: expected a list of ids');
    if (this.#desk?.workbench.picture) this.#desk.workbench.editing.select(ids);
    else this.#beginning.selection = [...ids];
  }

  /**
   * Opens a picture, with a project for it or a new one. Done once it is solved. The newest call wins.
   * @throws Error with a code where it cannot be opened; what was open before stays. DOMException AbortError where another is
   * opened, or the element removed, before that. TypeError for what is neither an address nor a Blob.
   */
  async load(source: string | URL | Blob, project?: string | URL | ProjectFile | null): Promise<void> {
    const desk = this.#present;
    const picture = source instanceof URL ? source.href : source;
    if (typeof picture !== 'string' && !(picture instanceof Blob)) {
      throw new TypeError('load: expected the address of a picture, or a Blob such as a File');
    }
    const given = project instanceof URL ? project.href : project;
    await desk.files.shown(() => desk.files.load(picture, given ?? this.#beginning.taken()));
    if (desk !== this.#desk) return;
    this.#emit('load', null);
  }

  /**
   * Adds a handle; without an id it gets one. Returns the id. What only the solver can tell, such as that it lies outside the picture,
   * comes later: an `error`, and a `change` that takes this handle back and leaves what was done since.
   * @throws RangeError for an id that is taken, for what no handle can be, and where there is no picture yet.
   */
  addHandle(handle: NewHandle): string {
    const { editing, picture } = this.#present.workbench;
    if (!picture) throw new RangeError('there is no picture yet to put a handle on');
    if (typeof handle !== 'object' || handle === null) throw new RangeError('a handle: expected an object');
    const id = handle.id ?? freeId(editing.project);
    if (handleById(editing.document, id)) throw new RangeError(`there is a handle "${id}" already`);
    const added = copied(checkedHandle(posedHandle({ ...handle, id } as HandleFile)));
    editing.step('Add handle', addHandle(editing.document, added));
    return id;
  }

  /** @throws RangeError where there is no such handle, for another id or kind, and for what no handle can be. */
  updateHandle(id: string, change: Partial<Omit<Handle, 'id' | 'kind'>>): void {
    const { editing } = this.#present.workbench;
    const handle = this.#handle(id);
    const changed = copied(checkedHandle({ ...handle, ...change } as Handle));
    for (const key of ['id', 'kind'] as const) {
      if (changed[key] !== handle[key]) throw new RangeError(`handle "${id}", ${key}: cannot be changed`);
    }
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

  /** Where a point of the original goes by the solution that is shown, in image pixels; null outside what is warped. */
  mapPoint(point: Vec): Vec | null {
    return this.#present.posing.map(point)?.rest ?? null;
  }

  /**
   * The warped picture as PNG with alpha, at `scale` times the source's size.
   * @throws Error where there is no picture, or the element is on no page. DOMException AbortError where another
   * picture, or the element's removal, overtakes it.
   */
  async toBlob(scale = 1): Promise<Blob> {
    return this.#present.workbench.png(scale);
  }

  /** The whole picture into view. */
  fit(): void {
    this.#present.fit();
  }

  /** Leaves the page for good. */
  destroy(): void {
    this.remove();
    this.#beginning.forget();
  }

  /** Keys go to the editor. */
  override focus(options?: FocusOptions): void {
    this.shadowRoot?.querySelector<HTMLElement>('.shell')?.focus(options);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const element = this;
    this.#desk = new Desk({
      get root() {
        return element.renderRoot as ShadowRoot;
      },
      get readonly() {
        return element.readonly;
      },
      get disabled() {
        return element.disabled;
      },
      get play() {
        return element.play;
      },
      get dark() {
        return element.#dark;
      },
      get tool() {
        return element.tool;
      },
      get hint() {
        return element.hint ? { text: element.hint, handle: element.hintFor } : null;
      },
      aside: this.#beginning.aside,
      changed: () => this.requestUpdate(),
      opened: () => this.#desk && this.#beginning.settle(this.#desk),
      edited: (kind) => this.#edited(kind),
      emit: this.#emit,
      switchTheme: () => {
        this.theme = this.#dark ? 'light' : 'dark';
      },
    });
    this.#turn = this.#desk.files.turn();
    this.#receiving = new Receiving(
      this,
      () => !this.readonly && !this.disabled && !this.play,
      (files) => void this.#desk?.files.receive(files),
    );
    this.#focusing = new Focusing(this);
    this.requestUpdate();
  }

  /** Moved to another document. */
  adoptedCallback(): void {
    if (this.shadowRoot) this.#dress(this.shadowRoot);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#receiving?.release();
    this.#focusing?.release();
    const desk = this.#desk;
    this.#desk = null;
    this.#beginning.leave(desk?.workbench.kept ?? null);
    desk?.dispose();
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    if (this.ownerDocument === document) return super.createRenderRoot();
    const root = this.attachShadow(C2Warp.shadowRootOptions);
    this.#dress(root);
    return root;
  }

  protected override render(): TemplateResult | null {
    const desk = this.#desk;
    if (!desk) return null;
    return shell({ ...desk.model, platform: navigator.platform }, desk.actions, desk.canvas);
  }

  protected override willUpdate(changes: PropertyValues<this>): void {
    // What the first update finds is what the element begins with.
    if (this.hasUpdated && this.#asks(changes)) this.#beginning.ask();
  }

  protected override updated(changes: PropertyValues<this>): void {
    const desk = this.#desk;
    if (!desk) return;
    this.#focusing?.repair();
    const turn = this.#turn;
    this.#turn = null;
    const fresh = turn !== null;
    if (fresh || changes.has('autosave')) desk.keepUnder(this.autosave);
    if (this.readonly || this.disabled) {
      if (changes.has('readonly') || changes.has('disabled')) desk.stop();
    }
    const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
    const rearranged = changes.has('play') || (this.play && changes.has('readonly'));
    if (stage && !fresh && rearranged) desk.rearrange(stage);
    const freed = changes.has('readonly') || changes.has('play');
    if (isToolName(this.tool) && (fresh || freed || changes.has('tool'))) desk.choose(this.tool);
    if (fresh) {
      if (stage) desk.attach(stage);
      void this.#beginning.begin(desk, turn);
    } else if (this.#asks(changes)) {
      void this.#beginning.open(desk);
    }
  }

  /** Style sheets are of one document: another than that of this file needs its own. */
  #dress(root: ShadowRoot): void {
    const view = this.ownerDocument.defaultView;
    if (!view) return;
    root.adoptedStyleSheets = C2Warp.elementStyles.map((style) => {
      const sheet = new view.CSSStyleSheet();
      sheet.replaceSync(String(style));
      return sheet;
    });
  }

  /** Whether the attributes now name something else to open. */
  #asks(changes: PropertyValues<this>): boolean {
    const named = changes.has('src') || (changes.has('projectSource') && this.projectSource !== null);
    return named && Boolean(this.src);
  }

  #handle(id: string): Handle {
    const handle = handleById(this.#present.workbench.editing.document, id);
    if (!handle) throw new RangeError(`there is no handle "${id}"`);
    return handle;
  }

  get #present(): Desk {
    if (!this.#desk) throw new Error('<c2-warp> is not on a page, and has no picture there');
    return this.#desk;
  }

  get #dark(): boolean {
    if (this.theme === 'dark' || this.theme === 'light') return this.theme === 'dark';
    return matchMedia('(prefers-color-scheme: dark)').matches;
  }

  #edited(kind: ChangeKind): void {
    const desk = this.#desk;
    if (!desk) return;
    const { project, undoLabel, redoLabel } = desk.workbench.editing;
    const selection = this.selection.join('\n');
    if (selection !== this.#selected) {
      this.#selected = selection;
      this.#emit('selectionchange', { selection: this.selection });
    }
    if (kind === 'input' || kind === 'change') {
      // Copied for those who ask: a drag has many.
      const detail = {
        get project() {
          return copied(project);
        },
      };
      this.#emit(kind, detail);
    }
    if (undoLabel === this.#past && redoLabel === this.#future) return;
    [this.#past, this.#future] = [undoLabel, redoLabel];
    this.#emit('historychange', { undo: undoLabel, redo: redoLabel });
  }

  /** What a page set before it knew this class hides the accessor of the same name. */
  #adopt(name: 'project' | 'selection'): void {
    if (!Reflect.getOwnPropertyDescriptor(this, name)) return;
    const value = Reflect.get(this, name);
    Reflect.deleteProperty(this, name);
    Reflect.set(this, name, value);
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
