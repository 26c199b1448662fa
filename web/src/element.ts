/**
 * `<c2-warp>`: the editor as a custom element.
 *
 * | attribute | |
 * |---|---|
 * | `src` | the address of the picture; a new address replaces the open picture |
 * | `project` | the address of the project file for `src`. Both are opened again when either changes |
 * | `tool` | `select`, `point`, `bar`, `polygon`, `lasso` or `hand` |
 * | `readonly` | people can look, pan and zoom, but change nothing; methods still can |
 * | `disabled` | people can do nothing |
 * | `play` | only the picture and its handles, for an article; with `readonly`, only the picture |
 * | `theme` | `light` or `dark`; without it, the system's |
 * | `alt` | with `play`: what the picture shows, for screen readers; without it they read its name |
 * | `hint`, `hint-for` | a hint shown until the first change, and the id of the handle it points to |
 * | `autosave` | a key in browser storage: work is saved after each step, and restored instead of the first `src` |
 *
 * `tool` is selected when it is set, when the element is connected, and when `readonly` or `play` is removed. With
 * `play` people can only pose the existing handles; wheel, touches and keys that act on no handle are left to the page.
 *
 * | event | |
 * |---|---|
 * | `ready` | once after each connection, when the initial content is open, absent, failed or overtaken |
 * | `load` | a picture is open and solved, unless a person opened it |
 * | `input` | during a drag; `detail.project` is a copy of the project |
 * | `change` | a step was done, undone or redone, by a person or a method; `detail.project` is a copy of the project |
 * | `selectionchange` | `detail.selection`: the ids, whatever changed the selection |
 * | `historychange` | `detail.undo`, `detail.redo`: labels of the next undo and redo steps, or null |
 * | `progress` | `detail.label`: the solver's stage, once a wait is noticeable, or the PNG export; null when done |
 * | `error` | `detail`: an Error that no method call can throw or reject with |
 *
 * `load` follows `src`, `load()`, work restored from `autosave`, and reconnection of an element that has a document.
 *
 * The `code` of an Error says why something cannot be opened: `address` (no such file, or no network), `file` (a
 * folder, or a file that no longer exists), `picture` (not a picture, or not a readable one), `project` (the message
 * names the key), `image-size` (a project for a picture of another size), `engine` (the solver could not start), `webgl`
 * (the browser has no WebGL2 to draw with), or a refusal by the solver, such as `handle-outside`; its `handles` are then
 * the ids of the handles that the message names.
 *
 * Setting `readonly` or `disabled`, and setting or removing `play`, cancels the drag, drawing or typed number in
 * progress. A page may have several elements. An element that is removed releases its worker and its WebGL context, and
 * keeps its document until it is connected again. Properties may be set before the element is connected, even before
 * it is defined. Importing this file without a DOM does nothing.
 */
import type { PropertyDeclaration, PropertyValues, TemplateResult } from 'lit';
import { handleById } from './document/document';
import { addHandle, freeId, putHandles, removeHandles } from './document/edits';
import { checkedHandle } from './document/handle';
import {
  deepCopy,
  type Handle,
  type HandleFile,
  type Project,
  type ProjectFile,
  posedHandle,
} from './document/project';
import { Clipboard } from './element/clipboard';
import { Desk } from './element/desk';
import type { ChangeKind } from './element/editing';
import { type C2WarpEventMap, emitter, TypedElement } from './element/events';
import { FocusKeeper } from './element/focus_keeper';
import { InitialContent } from './element/initial_content';
import { Receiving } from './element/receiving';
import type { Vec } from './geometry/vec';
import { encodePng, pictureCanvas } from './io/encode';
import { isToolName } from './tools/machine';
import { shell } from './ui/shell';
import { editorStyle } from './ui/style/editor';

export type { Handle, HandleFile, Project, ProjectFile } from './document/project';
export type { C2WarpEventMap } from './element/events';

/** A handle whose id is optional: the editor generates a missing one. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

/** The pose of the handle with this id. What is left out stays; `kind` and `rest`, if given, are those of the handle. */
export type HandlePose = Pick<Handle, 'id'> & Partial<Handle>;

/** What the template of a framework may set on the tag: attributes, properties, and listeners such as `onchange`. */
export type C2WarpProps = {
  [T in keyof C2WarpEventMap as `on${T}`]?: ((event: C2WarpEventMap[T]) => void) | undefined;
} & {
  [T in 'src' | 'tool' | 'theme' | 'alt' | 'hint' | 'hint-for' | 'autosave']?: string | null | undefined;
} & {
  [T in 'readonly' | 'disabled' | 'play']?: boolean | undefined;
} & {
  project?: ProjectFile | string | null | undefined;
  selection?: readonly string[] | null | undefined;
};

/** How a warped picture is drawn. */
export interface WarpOptions {
  /** As much larger as it takes to hold what is bent beyond the picture. */
  readonly grow?: boolean;
  /** For pixel art: no colours are mixed. As it is shown unless given. */
  readonly pixelated?: boolean | undefined;
}

export class C2Warp extends TypedElement {
  static override styles = editorStyle;

  static override properties = {
    src: {},
    projectSource: { attribute: 'project' },
    tool: {},
    readonly: { type: Boolean, reflect: true },
    disabled: { type: Boolean, reflect: true },
    play: { type: Boolean, reflect: true },
    theme: { reflect: true },
    alt: {},
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
  declare alt: string | null;
  declare hint: string | null;
  declare hintFor: string | null;
  declare autosave: string | null;

  readonly #emit = emitter(this);
  readonly #initial: InitialContent;
  #desk: Desk | null = null;
  /** For the initial content. Taken on connection, so that every later request overtakes it. */
  #signal: AbortSignal | null = null;
  #receiving: Receiving | null = null;
  #clipboard: Clipboard | null = null;
  #focusKeeper: FocusKeeper | null = null;
  /** One query, kept: every frame of an animation asks it. */
  readonly #darkness = matchMedia('(prefers-color-scheme: dark)');
  /** Values of the last `selectionchange` and `historychange`. */
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
    this.alt = null;
    this.hint = null;
    this.hintFor = null;
    this.autosave = null;
    const element = this;
    this.#initial = new InitialContent({
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
   * A copy of the current project. Setting a project for the open picture is an undoable step. A project that is set
   * before there is a picture is applied to the next one, whoever opens it; if its size differs, an `error` is emitted.
   * A string is the address of a project file, like the attribute.
   * @throws RangeError that names what is invalid; Error when read while the element is not connected.
   */
  get project(): Project {
    return deepCopy(this.#present.workbench.editing.project);
  }

  set project(given: ProjectFile | string | null) {
    this.#initial.project = null;
    if (given === null || typeof given !== 'object') this.projectSource = given ?? null;
    else if (this.#desk?.workbench.isOpen && !this.#initial.asks) this.#desk.workbench.set(given);
    else this.#initial.project = deepCopy(given);
  }

  /**
   * Ids of the selected handles; null selects none. A selection that is set before there is a picture is applied to the
   * next one.
   */
  get selection(): readonly string[] {
    return [...this.#present.workbench.editing.document.selection];
  }

  set selection(given: readonly string[] | null) {
    // Frameworks take a property back by setting it to undefined.
    const ids = given ?? [];
    if (!Array.isArray(ids)) throw new TypeError('selection: expected a list of ids');
    if (this.#desk?.workbench.picture && !this.#initial.asks) this.#desk.workbench.editing.put(ids);
    else this.#initial.selection = [...ids];
  }

  /**
   * Opens a picture, with the given project or a new one. Resolves once the picture is solved. The newest call wins.
   * @throws Error with a `code` if the picture cannot be opened; the previous one stays open, and where there was none, the
   * picture without the handles that the solver refuses. DOMException AbortError if another is opened or the element is
   * removed first. TypeError if `source` is neither an address nor a Blob.
   */
  async load(source: string | URL | Blob, project?: string | URL | ProjectFile | null): Promise<void> {
    const desk = this.#present;
    const picture = source instanceof URL ? source.href : source;
    if (typeof picture !== 'string' && !(picture instanceof Blob)) {
      throw new TypeError('load: expected the address of a picture, or a Blob such as a File');
    }
    const given = project instanceof URL ? project.href : project;
    await desk.files.shown(() => this.#initial.load(desk, picture, given));
    if (desk !== this.#desk) return;
    this.#emit('load', null);
  }

  /**
   * Adds a handle, with a generated id if it has none, and returns the id. The solver may refuse the handle later, for
   * example outside the picture: then an `error`, and a `change` that removes this handle but keeps later steps.
   * @throws RangeError if the id exists already, the handle is invalid, or no picture is open.
   */
  addHandle(handle: NewHandle): string {
    const { editing, picture } = this.#present.workbench;
    if (!picture) throw new RangeError('there is no picture yet to put a handle on');
    if (typeof handle !== 'object' || handle === null) throw new RangeError('a handle: expected an object');
    const id = handle.id ?? freeId(editing.project);
    if (handleById(editing.document, id)) throw new RangeError(`there is a handle "${id}" already`);
    const added = deepCopy(checkedHandle(posedHandle({ ...handle, id } as HandleFile)));
    editing.step('Add handle', addHandle(editing.document, added));
    return id;
  }

  /** @throws RangeError if there is no such handle, the id or kind would change, or the result is invalid. */
  updateHandle(id: string, change: Partial<Omit<Handle, 'id' | 'kind'>>): void {
    const { editing } = this.#present.workbench;
    editing.step('Change handle', putHandles(editing.document, [this.#changed(id, change)]));
  }

  /**
   * Poses any number of handles at once, for animation: the handles of a project, or their ids with what changes. This is
   * no undo step, emits nothing and is not stored until the next step. While a person presses or drags handles,
   * these are left to them, and the others are posed.
   * @throws RangeError if there is no such handle, or a pose is invalid; TypeError without a list. Then none is posed.
   */
  pose(handles: readonly HandlePose[]): void {
    const { editing } = this.#present.workbench;
    if (!Array.isArray(handles)) throw new TypeError('pose: expected a list of handles');
    editing.pose(handles.map(({ id, ...pose }) => this.#changed(id, pose, ['kind', 'rest'])));
  }

  /** @throws RangeError if there is no such handle. */
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

  /** Returns all handles to their rest pose. */
  reset(): void {
    this.#present.workbench.commands.reset(true);
  }

  /** Maps a point of the original to the warped picture as shown, in image pixels; null outside the warped area. */
  mapPoint(point: Vec): Vec | null {
    return this.#present.workbench.posing.map(point)?.posed ?? null;
  }

  /**
   * Where a place in the window, such as `[event.clientX, event.clientY]`, lies in the picture as it is shown, image
   * pixels; null without a picture. It may lie beside the picture.
   */
  clientToImage(client: Vec): Vec | null {
    return this.#present.imageAt(client);
  }

  /** Where a place of the picture as it is shown, such as that of `mapPoint`, lies in the window, CSS pixels; null without a picture. */
  imageToClient(image: Vec): Vec | null {
    return this.#present.clientAt(image);
  }

  /**
   * The warped picture as PNG with alpha, at `scale` times the source's size; with `grow`, as much larger as it takes to
   * hold what is bent beyond that. `pixelated` is for pixel art: each pixel is one of the original, or transparent. Without
   * a word of that it is as it is shown: pixelated where it is pixel art, or the page's style says `image-rendering: pixelated`.
   * @throws Error if no picture is open, the element is not connected, or the result would be too large. DOMException
   * AbortError if another picture is opened, or the element is removed, first.
   */
  async toBlob(scale = 1, { grow = false, pixelated }: WarpOptions = {}): Promise<Blob> {
    const { width, height, rgba } = await this.#present.warped(scale, grow, pixelated);
    return encodePng(width, height, rgba);
  }

  /**
   * The same on a canvas of the page's document, to be drawn on, or given on as an image of another type.
   * @throws as `toBlob`.
   */
  async toCanvas(scale = 1, { grow = false, pixelated }: WarpOptions = {}): Promise<HTMLCanvasElement> {
    const { width, height, rgba } = await this.#present.warped(scale, grow, pixelated);
    return pictureCanvas(this.ownerDocument, width, height, rgba);
  }

  /** Fits the whole picture into view. */
  fit(): void {
    this.#present.fit();
  }

  /** Removes the element and discards its document. */
  destroy(): void {
    this.remove();
    this.#initial.forget();
  }

  /** Focuses the editor itself, which handles the keys. */
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
      get alt() {
        return element.alt;
      },
      get tool() {
        return element.tool;
      },
      get hint() {
        return element.hint ? { text: element.hint, handle: element.hintFor } : null;
      },
      aside: this.#initial.aside,
      changed: () => this.requestUpdate(),
      opened: (given) => this.#desk && this.#initial.settle(this.#desk, given),
      again: () => this.#desk && void this.#initial.again(this.#desk),
      edited: (kind) => this.#edited(kind),
      emit: this.#emit,
      copy: () => void this.#clipboard?.copy(),
      paste: () => void this.#clipboard?.paste(),
      switchTheme: () => {
        this.theme = this.#dark ? 'light' : 'dark';
      },
    });
    this.#signal = this.#desk.files.overtake();
    const willing = () => !this.readonly && !this.disabled && !this.play;
    const receive = (files: readonly File[]) => void this.#desk?.files.receive(files);
    this.#receiving = new Receiving(this, willing, receive);
    this.#clipboard = new Clipboard(this, {
      willing,
      receive,
      copied: () => this.#desk?.commands.copied() ?? null,
      pasted: (text) => this.#desk?.commands.paste(text) ?? false,
      tell: (text) => this.#desk?.notices.notify({ kind: 'info', text }),
    });
    this.#focusKeeper = new FocusKeeper(this);
    this.requestUpdate();
  }

  /** Called when the element is moved to another document. */
  adoptedCallback(): void {
    if (this.shadowRoot) this.#dress(this.shadowRoot);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#receiving?.release();
    this.#clipboard?.release();
    this.#focusKeeper?.release();
    const desk = this.#desk;
    this.#desk = null;
    this.#initial.leave(desk?.workbench.kept ?? null);
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
    return shell(desk.model, desk.actions, desk.canvas);
  }

  /** Asks at once for what the attributes name, so that what a page sets next is for that. */
  override requestUpdate(name?: PropertyKey, before?: unknown, options?: PropertyDeclaration): void {
    super.requestUpdate(name, before, options);
    // The attributes of the first update are the initial content, not a change.
    const asks = name === 'src' || (name === 'projectSource' && this.projectSource !== null);
    if (asks && this.hasUpdated && this.src && this[name] !== before) this.#initial.ask();
  }

  protected override willUpdate(changes: PropertyValues<this>): void {
    // A field that goes commits what is typed.
    if (changes.has('play') || changes.has('readonly') || changes.has('disabled')) this.#desk?.untype();
  }

  protected override updated(changes: PropertyValues<this>): void {
    const desk = this.#desk;
    if (!desk) return;
    this.#focusKeeper?.repair();
    const signal = this.#signal;
    this.#signal = null;
    const fresh = signal !== null;
    if (fresh || changes.has('autosave')) desk.autosave.use(this.autosave);
    if (this.readonly || this.disabled) {
      if (changes.has('readonly') || changes.has('disabled')) desk.stop();
    }
    const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
    const rearranged = changes.has('play') || (this.play && changes.has('readonly'));
    if (!fresh && rearranged) desk.rearrange();
    const freed = changes.has('readonly') || changes.has('play');
    if (isToolName(this.tool) && (fresh || freed || changes.has('tool'))) desk.commands.choose(this.tool);
    if (fresh) {
      if (stage) desk.attach(stage);
      void this.#initial.begin(desk, signal);
    } else if (this.#asks(changes)) {
      void this.#initial.open(desk);
    }
  }

  /** Constructed style sheets work only in the document that made them: another document needs new ones. */
  #dress(root: ShadowRoot): void {
    const view = this.ownerDocument.defaultView;
    if (!view) return;
    root.adoptedStyleSheets = C2Warp.elementStyles.map((style) => {
      const sheet = new view.CSSStyleSheet();
      sheet.replaceSync(String(style));
      return sheet;
    });
  }

  /** Whether the changed attributes name something to open. */
  #asks(changes: PropertyValues<this>): boolean {
    const named = changes.has('src') || (changes.has('projectSource') && this.projectSource !== null);
    return named && Boolean(this.src);
  }

  #handle(id: string): Handle {
    const handle = handleById(this.#present.workbench.editing.document, id);
    if (!handle) throw new RangeError(`there is no handle "${id}"`);
    return handle;
  }

  /** A handle with a page's changes. @throws RangeError if the result is invalid, or a `fixed` key would change. */
  #changed(id: string, change: object, fixed: readonly ('id' | 'kind' | 'rest')[] = ['id', 'kind']): Handle {
    const handle = this.#handle(id);
    const changed = deepCopy(checkedHandle({ ...handle, ...change } as Handle));
    for (const key of fixed) {
      if (String(changed[key]) !== String(handle[key]))
        throw new RangeError(`handle "${id}", ${key}: cannot be changed`);
    }
    return changed;
  }

  get #present(): Desk {
    if (!this.#desk) throw new Error('<c2-warp> is not on a page, and has no picture there');
    return this.#desk;
  }

  get #dark(): boolean {
    if (this.theme === 'dark' || this.theme === 'light') return this.theme === 'dark';
    return this.#darkness.matches;
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
      // Copied only when read: a drag emits many events.
      const detail = {
        get project() {
          return deepCopy(project);
        },
      };
      this.#emit(kind, detail);
    }
    if (undoLabel === this.#past && redoLabel === this.#future) return;
    [this.#past, this.#future] = [undoLabel, redoLabel];
    this.#emit('historychange', { undo: undoLabel, redo: redoLabel });
  }

  /** Sets a property again that the page set before the element was upgraded: it would hide the accessor. */
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
