/**
 * `<c2-warp>`: the editor as a custom element.
 *
 * Its manifest, types for frameworks and the tables of `web/docs/element.md` are generated from the comments in this
 * file, in `element/events.ts` and in `error.ts`.
 *
 * `tool` is selected when it is set, when the element is connected, and when `readonly` or `posable` is removed. With
 * `posable`, people can only pose the existing handles. The page keeps all wheel, touch and key input that does not act
 * on a handle. `load` follows `src`, `load()`, work restored from `autosave`, and reconnection of an element that has a
 * document.
 *
 * Setting `readonly` or `disabled`, and setting or removing `posable`, cancels the drag, drawing or typed number in
 * progress. A page may have several elements. An element that is removed releases its worker and its WebGL context, and
 * keeps its document until it is connected again. Properties may be set before the element is connected, or even
 * defined. Servers and workers can import this file, but it defines no element there.
 */
import type { Drawing } from './compute/drawing';
import { withNewRotation } from './document/bending';
import { checkDefaults, type ProjectDefaults } from './document/defaults';
import { type Document, handleById } from './document/document';
import { freeId } from './document/edits';
import { checkedHandle } from './document/handle';
import { redoLabel, undoLabel } from './document/history';
import {
  deepCopy,
  type Handle,
  type HandleFile,
  type Project,
  type ProjectFile,
  posedHandle,
} from './document/project';
import type { PageNotification } from './editor/effects';
import { attributesPending, type Carried, nothingCarried } from './editor/opening_state';
import type { PageAttributes, Sample } from './editor/page';
import type { PageQuestion } from './editor/page_question';
import { mayReceive } from './editor/permissions';
import { stem } from './editor/picture';
import { hasPlayed, playedClip, playedDuration } from './editor/played_clip';
import { documentOf, filedProject, projectOf } from './editor/state';
import { viewModel } from './editor/view_model';
import type {
  BlobOptions,
  HandlePose,
  LoadOptions,
  NewHandle,
  PictureSource,
  WarpOptions,
} from './element/api';
import { attributeFaults } from './element/attribute_faults';
import { changedHandle, namedHandle } from './element/changed_handle';
import { checkedPairs } from './element/checked_pairs';
import { coded } from './element/coded';
import { emitter, TypedElement } from './element/events';
import { checkDrawn, checkWritten, drawingSettings, fileSettings } from './element/export_options';
import { FormControl, SUBMITTED } from './element/form_control';
import { addLanguage, languageTags } from './element/languages';
import { Loading } from './element/loading';
import { mediaOf } from './element/media';
import { emitNotification } from './element/notification';
import { pageAttributes } from './element/page_attributes';
import { namedSource } from './element/picture_source';
import type { Properties } from './element/properties';
import { ask } from './element/questions';
import { ShownLanguage } from './element/shown_language';
import type { Changes } from './element/updating_element';
import { asC2WarpError, C2WarpError, isAbort } from './error';
import type { Vec } from './geometry/vec';
import { EditorRuntime } from './runtime/editor_runtime';
import { drawOn, writtenFile } from './runtime/exporting';
import { notLoaded } from './runtime/lazy_view';
import type { PartialTexts } from './texts/texts';
import { TOOL_NAMES, type ToolName } from './tools/machine';
import { shell } from './ui/shell';
import { editorStyle } from './ui/style/editor';

export type { ProjectDefaults } from './document/defaults';
export type { Handle, HandleFile, Project, ProjectFile } from './document/project';
export type { Origin } from './editor/effects';
export type { ExportKind } from './editor/export_choices';
export type { Sample } from './editor/page';
export type * from './element/api';
export type { C2WarpEventMap } from './element/events';
export { C2WarpError, type C2WarpErrorCode, type SolverErrorCode } from './error';
export type { Vec } from './geometry/vec';
export type { PictureType } from './io/encoding';
export type { PartialTexts, Texts } from './texts/texts';
export type { ToolName } from './tools/machine';

/**
 * An editor that warps a picture with handles.
 *
 * @slot toolbar - Controls of the page in the toolbar. They handle their own keys. They are hidden with `posable`.
 * @slot panel - Controls of the page at the end of the panel.
 * @csspart stage - The picture with its handles, and the background behind them.
 * @csspart handle - A point handle, the middle of a bar or polygon, or a corner: the square touch target.
 * @csspart toolbar - The bar at the top.
 * @csspart status - The line at the bottom.
 * @csspart tools - The card of tools.
 * @csspart panel - The card of properties.
 * @csspart timeline - The card of the clips and their keys.
 * @csspart button - A button in any of these, or beside a drawing.
 * @csspart menu - The context menu, the list of keys, and the menu of a phone.
 * @csspart notice - A message of the editor, and the card that finishes a drawing.
 * @csspart hint - A hint over the picture, such as the purpose of a tool.
 * @cssprop {<color>} --c2-accent - The colour of the selection and the focus. Text on it is white, or nearly black on
 *   dark colours.
 * @cssprop {<color>} --c2-handle - The colour of handles, bars and polygons, on both light and dark pictures.
 * @cssprop {<color>} --c2-ground - The first of two colours behind the picture. By default, it is near that of the
 *   surface. With `posable`, it is transparent unless set.
 * @cssprop {<color>} --c2-checker - The second colour, in the squares of the pattern.
 * @cssprop {<color>} --c2-surface - The colour of bars, cards and hints, and of the text of tooltips.
 * @cssprop {<color>} --c2-text - The colour of the text on bars, cards and hints.
 * @cssprop {<length>} --c2-radius - The corner radius of cards. Buttons, fields and hints have radii relative to it.
 * @cssprop --c2-font - The font family.
 */
export class C2Warp extends TypedElement {
  /** @internal */
  static override readonly styles = editorStyle;

  /** The element is a form control. */
  static readonly formAssociated = true;

  /**
   * The tags of all languages: those of the package, and those that the page has added.
   *
   * An element uses the language of its attribute `lang`, or of the nearest ancestor with one, as in HTML. For `de-AT`
   * without its own texts, it uses `de`; for an unknown language, English. It follows `dir` in the same way.
   */
  static get languages(): readonly string[] {
    return languageTags();
  }

  /**
   * Adds a language, or changes texts of one. Elements on the page show it at once.
   *
   * @param tag A BCP 47 tag, such as `pt-BR`. A second call with the same tag replaces the first.
   * @param texts All or some texts. Missing texts are those of the package, or English.
   */
  static addLanguage(tag: string, texts: PartialTexts): void {
    addLanguage(tag, texts);
  }

  /** @internal */
  static override readonly properties: Properties = {
    src: { kind: 'address' },
    projectSource: { attribute: 'project', kind: 'address' },
    toolSource: { attribute: 'tool', words: TOOL_NAMES },
    readonly: { kind: 'flag' },
    disabled: { kind: 'flag' },
    posable: { kind: 'flag' },
    clip: {},
    autoplay: { kind: 'flag' },
    loop: { kind: 'flag' },
    theme: { words: ['light', 'dark', 'auto'], initial: 'auto' },
    alt: {},
    hint: {},
    hintFor: { attribute: 'hint-for' },
    autosave: {},
    samples: { attribute: false, initial: [] },
    features: { kind: 'optional' },
    required: { kind: 'flag' },
    name: {},
    submits: { words: SUBMITTED, initial: 'project' },
    crossOrigin: { words: ['anonymous', 'use-credentials'], invalid: 'anonymous' },
  };

  /** @internal */
  static override readonly accessors = ['readOnly', 'project', 'selection', 'tool', 'defaults'];

  /** The address of the picture. A new address replaces the open picture. */
  declare src: string;
  /** The address of the project file for `src`. Both are reopened when either changes. */
  declare projectSource: string;
  /** The tool that the page set last. People may have chosen another tool since: see the property `tool`. */
  declare toolSource: ToolName | null;
  /** People can view, pan and zoom, but not change anything. Methods still work. */
  declare readonly: boolean;
  /** People cannot interact. Methods still work. */
  declare disabled: boolean;
  /** Shows only the picture and its handles, for an article. With `readonly`, only the picture. */
  declare posable: boolean;
  /** The name of the clip that `play()` plays. By default, the first clip. */
  declare clip: string;
  /** Plays the clip once the picture is open, unless the user prefers reduced motion. */
  declare autoplay: boolean;
  /** The clip repeats. */
  declare loop: boolean;
  /** Light or dark colours. By default, `auto`, those of the system. */
  declare theme: 'light' | 'dark' | 'auto';
  /** With `posable`: a description of the picture for screen readers. By default, they read its name. */
  declare alt: string;
  /** A hint, shown until the first change. */
  declare hint: string;
  /** The id of the handle that the hint points to. By default, the first handle. */
  declare hintFor: string;
  /**
   * A key in browser storage. Work is stored there after each step, and restored instead of the first `src`.
   */
  declare autosave: string;
  /** Pictures that the menu beside Open offers: a list of `{ name, src, project? }` with addresses. */
  declare samples: readonly Sample[];
  /** The available features: any of `tools`, `open`, `save`, `export` and `animate`. By default, all. */
  declare features: string | null;
  /** The form cannot be submitted without a picture. */
  declare required: boolean;
  /** The name under which a form submits the value. */
  declare name: string;
  /** The value in a form: the project as JSON, which is the default, or the warped picture as a PNG file. */
  declare submits: 'project' | 'picture';
  /** Whether requests to other origins carry cookies. By default, and with `anonymous`, they do not. */
  declare crossOrigin: 'anonymous' | 'use-credentials' | null;

  readonly #emit = emitter(this);
  readonly #control = new FormControl({
    node: this,
    project: () => (this.naturalWidth > 0 ? this.project : null),
    picture: () => this.#picture(),
    failed: (error) => this.#emit('error', asC2WarpError(error)),
  });
  #defaults: ProjectDefaults = {};
  readonly #loading = new Loading();
  /** Attributes that name another picture have changed: it is asked for once all of them are set. */
  #asksSource = false;
  /** Calls of `load()`. */
  #asked = 0;
  /** Runs while the element is connected. */
  #runtime: EditorRuntime | null = null;
  readonly #language = new ShownLanguage(this, {
    asked: () => this.#takeDirection(),
    changed: () => this.requestUpdate(),
    failed: (cause) => this.#runtime?.dispatch({ type: 'error-reported', error: notLoaded(cause) }),
  });
  /** While the element is connected. */
  #following = new AbortController();
  /** The initial state of a runtime: values that the page set earlier, and the state of the last runtime. */
  #carried: Carried = nothingCarried;
  readonly #media = mediaOf(this);

  /**
   * The same as `readonly`, by the name that form controls have.
   *
   * @default false
   */
  get readOnly(): boolean {
    return this.readonly;
  }

  set readOnly(on: boolean) {
    this.readonly = on;
  }

  /**
   * A copy of the current project. Setting a project for the open picture is an undoable step.
   *
   * A project that is set earlier is applied to the next opened picture. If the sizes differ, the element emits an
   * `error`. A string is the address of a project file, as in the attribute.
   *
   * @throws C2WarpError `project` that names the invalid key, `image-size` for another size, `disconnected` when read
   *   while the element is not connected.
   */
  get project(): Project {
    return deepCopy(filedProject(this.#present.state));
  }

  set project(given: ProjectFile | string | null) {
    if (given === null || typeof given !== 'object') {
      this.#setPageProject(null);
      Reflect.set(this, 'projectSource', given);
      return;
    }
    const runtime = this.#runtime;
    const isOpen = runtime?.state.picture && runtime.state.solution.ready;
    if (!isOpen || attributesPending(runtime.state.opening)) this.#setPageProject(deepCopy(given));
    else {
      this.#setPageProject(null);
      runtime.adopt(given);
    }
  }

  /**
   * Ids of the selected handles; null selects none. A selection that is set earlier is applied to the next opened
   * picture.
   *
   * @throws TypeError for anything but a list.
   */
  get selection(): readonly string[] {
    return [...documentOf(this.#present.state).selection];
  }

  set selection(given: readonly string[] | null) {
    // Frameworks take a property back by setting it to undefined.
    const ids = given ?? [];
    if (!Array.isArray(ids)) throw new TypeError('selection: expected a list of ids');
    if (this.#runtime) this.#runtime.dispatch({ type: 'selection-set', ids: [...ids] });
    else this.#carried = { ...this.#carried, pageSelection: [...ids] };
  }

  /**
   * Settings of new projects, with the keys of a project file: `samples`, `weighting`, `pose`, `fix_boundary`, `edges`
   * and `loose_parts`. Missing settings keep the defaults of the editor. Opened projects keep their own settings.
   *
   * @throws RangeError that names an unknown key; TypeError for anything but an object or null. An invalid value emits
   * an `error` with the code `project`, and resets all settings to the editor's.
   */
  get defaults(): ProjectDefaults {
    return deepCopy(this.#defaults);
  }

  set defaults(given: ProjectDefaults | null) {
    const settings = given ?? {};
    checkDefaults(settings);
    this.#setDefaults(deepCopy(settings));
    void this.#checkDefaults();
  }

  /**
   * The current tool, chosen by the page or by the user. Setting it selects a tool if people could select it. Unknown
   * names are ignored and emit an `error`.
   */
  get tool(): ToolName {
    const runtime = this.#runtime;
    return runtime?.isAttached ? runtime.state.tools.tool : (this.toolSource ?? 'select');
  }

  set tool(name: ToolName | null) {
    const before = this.toolSource;
    this.toolSource = name;
    // The attribute has named it before, and a person has chosen another one since.
    if (before === this.toolSource) this.#takeTool();
  }

  /**
   * Opens a picture, with the given project or a new one. Resolves once the picture is solved. The newest call wins.
   * With `notice`, the editor also shows failures. `signal` cancels the call.
   *
   * @param source An address, a file, or pixels.
   * @param project A project, or the address of a project file.
   * @param options With `notice`, the editor also shows failures.
   * @throws C2WarpError if the picture cannot be opened. The previous picture remains open. Without a previous picture,
   * the new one remains open without the handles that the solver rejects.
   * @throws DOMException AbortError if another picture is opened or the element is removed first; the reason of
   *   `signal` if that is aborted.
   * @throws TypeError for any other `source`.
   */
  async load(
    source: PictureSource,
    project?: string | URL | ProjectFile | null,
    options: LoadOptions = {},
  ): Promise<void> {
    options.signal?.throwIfAborted();
    const runtime = this.#present;
    const given = project instanceof URL ? project.href : (project ?? null);
    // Copied now: the page may change its object later.
    const copied = typeof given === 'object' && given ? deepCopy(given) : given;
    const asked = ++this.#asked;
    const named = namedSource(source);
    // A picture that the page has named before this one is superseded, not asked for later.
    this.#askSource();
    const open = async () => {
      // An address or a file is asked for at once.
      const picture = named instanceof Promise ? await coded(named) : named;
      if (asked !== this.#asked || runtime !== this.#runtime)
        throw new DOMException('another picture was requested, or the editor was removed', 'AbortError');
      options.signal?.throwIfAborted();
      await coded(runtime.load(picture, copied, options), options.signal);
    };
    const opened = open();
    this.#loading.follow(opened);
    return opened;
  }

  /**
   * Opens files as if they were dropped on the editor: a picture, a project, or both. A notice names the other files.
   *
   * Does nothing if people may not open files. The editor shows failures.
   *
   * @param files At least a picture or a project.
   * @throws TypeError for anything but a list of files.
   */
  openFiles(files: Iterable<File>): void {
    const { state, dispatch } = this.#present;
    const given = [...files];
    if (!given.every((file) => file instanceof File))
      throw new TypeError('openFiles: expected a list of files');
    if (!mayReceive(state)) return;
    dispatch({ type: 'files-received', files: given.map((file) => ({ name: file.name, file })) });
  }

  /**
   * Opens content of a link or another program. If a picture is open, a notice asks the person first.
   *
   * @internal
   */
  offer(brought: readonly File[] | Sample): void {
    const opening = Array.isArray(brought)
      ? ({ type: 'files-received', files: brought.map((file) => ({ name: file.name, file })) } as const)
      : ({ type: 'sample-chosen', sample: brought as Sample } as const);
    const names = Array.isArray(brought) ? brought.map(({ name }) => name) : [(brought as Sample).name];
    this.#present.dispatch({ type: 'offered', names, opening });
  }

  /**
   * Shows a notice for some seconds. With `posable`, notices are not shown.
   *
   * @param text A sentence for the user.
   */
  inform(text: string): void {
    this.#present.dispatch({ type: 'person-informed', text: String(text) });
  }

  /**
   * Adds a handle, with a generated id if it has none, and returns the id. Without a rotation, it turns like a handle
   * that a person adds: automatically in rigid mode. The solver may reject the handle later, for example if it is too
   * close to another. Then an `error` follows, and a `change` that removes only this handle.
   *
   * @param handle Positions are in pixels of the picture.
   * @returns The id.
   * @throws RangeError if the id exists already, or the handle is invalid.
   * @throws C2WarpError `no-picture` if no picture is open, `handle-outside` for a point outside the picture.
   */
  addHandle(handle: NewHandle): string {
    const { state, dispatch } = this.#present;
    if (!state.picture) throw new C2WarpError('no-picture', 'open a picture before you add a handle');
    if (typeof handle !== 'object' || handle === null) throw new RangeError('addHandle: expected an object');
    const id = handle.id ?? freeId(projectOf(state));
    if (handleById(documentOf(state), id)) throw new RangeError(`a handle "${id}" exists already`);
    const given = checkedHandle(posedHandle({ ...handle, id } as HandleFile));
    const added = deepCopy(withNewRotation(projectOf(state), given));
    if (added.kind === 'point' && this.#present.isOutside(added.rest))
      throw new C2WarpError(
        'handle-outside',
        `handle "${id}": ${added.rest.join(', ')} is outside the picture`,
        {
          handles: [id],
        },
      );
    dispatch({ type: 'handle-added', handle: added });
    return id;
  }

  /**
   * Changes a handle, as a step. Missing keys do not change.
   *
   * @param id The handle.
   * @param change Positions in pixels of the picture, degrees, and a scale factor.
   * @throws RangeError if the handle does not exist, the id or kind would change, or the result is invalid.
   */
  updateHandle(id: string, change: Partial<Omit<Handle, 'id' | 'kind'>>): void {
    this.#present.dispatch({ type: 'handle-changed', handle: changedHandle(this.#document, id, change) });
  }

  /**
   * Poses any number of handles at once, for animation. Takes the handles of a project, or ids with changes.
   *
   * This is not an undo step, emits no events, and is not stored until the next step. Handles that the user is dragging
   * are not changed.
   *
   * @param handles Positions in pixels of the picture, degrees, and scale factors.
   * @throws RangeError if a handle does not exist, or a pose is invalid; TypeError without a list. On an error,
   *   no handle moves.
   */
  pose(handles: readonly HandlePose[]): void {
    const { state, dispatch } = this.#present;
    if (!Array.isArray(handles)) throw new TypeError('pose: expected a list of handles');
    const document = documentOf(state);
    const posed = handles.map(({ id, ...pose }) => changedHandle(document, id, pose, ['kind', 'rest']));
    dispatch({ type: 'handles-posed', handles: posed });
  }

  /**
   * Removes a handle, as a step.
   *
   * @param id The handle.
   * @throws RangeError if the handle does not exist.
   */
  removeHandle(id: string): void {
    this.#present.dispatch({ type: 'handle-removed', id: namedHandle(this.#document, id).id });
  }

  /** Undoes the last step, if there is one. */
  undo(): void {
    this.#present.dispatch({ type: 'undo-asked' });
  }

  /** Redoes the last undone step, if there is one. */
  redo(): void {
    this.#present.dispatch({ type: 'redo-asked' });
  }

  /** Returns all handles to their rest pose. */
  reset(): void {
    this.#present.dispatch({ type: 'reset-asked' });
  }

  /**
   * Plays the clip, from its beginning if it has ended. Closes the timeline. People can still pose handles, which ease
   * back to the clip when released.
   *
   * @throws C2WarpError `clip` if the project lacks the clip.
   */
  async play(): Promise<void> {
    const { state, dispatch } = this.#present;
    if (!playedClip(state))
      throw new C2WarpError(
        'clip',
        this.clip === null ? 'the project has no clip' : `there is no clip "${this.clip}"`,
      );
    dispatch({ type: 'play-asked' });
  }

  /** Pauses the clip. */
  pause(): void {
    this.#runtime?.dispatch({ type: 'pause-asked' });
  }

  /** Whether the clip is paused. */
  get paused(): boolean {
    return !this.#runtime?.state.playback.playing;
  }

  /** Whether the clip has played to its end. */
  get ended(): boolean {
    return this.#runtime !== null && hasPlayed(this.#runtime.state);
  }

  /**
   * Seconds. Setting it shows that time of the clip.
   *
   * @default 0
   * @throws TypeError for anything but a finite number.
   */
  get currentTime(): number {
    return this.#runtime?.state.playback.time ?? 0;
  }

  set currentTime(seconds: number) {
    if (!Number.isFinite(seconds)) throw new TypeError('currentTime: expected seconds');
    this.#present.dispatch({ type: 'seek-asked', time: seconds });
  }

  /** Seconds; NaN without a clip. For a clip that alternates, forwards and backwards together. */
  get duration(): number {
    const clip = this.#runtime && playedClip(this.#runtime.state);
    return clip ? playedDuration(clip) : Number.NaN;
  }

  /**
   * The speed of the clip. Below 0 it plays backwards, and stands still at the beginning, as videos do.
   *
   * @default 1
   * @throws TypeError for anything but a finite number.
   */
  get playbackRate(): number {
    return this.#runtime?.state.playback.rate ?? 1;
  }

  set playbackRate(rate: number) {
    if (!Number.isFinite(rate)) throw new TypeError('playbackRate: expected a number');
    this.#present.dispatch({ type: 'rate-asked', rate });
  }

  /**
   * The posed position of a point of the original, image pixels; null outside the warped area.
   *
   * @param point Pixels of the picture.
   */
  mapPoint(point: Vec): Vec | null {
    return this.#present.map(point)?.posed ?? null;
  }

  /**
   * The posed positions of many points of the original: points × 2, image pixels, and NaN outside the warped area. One
   * walk over the mesh finds all of them, and takes hardly longer than for a single point.
   *
   * @param points Points × 2, pixels of the picture.
   * @throws TypeError unless `points` is a Float64Array of pairs.
   */
  mapPoints(points: Float64Array): Float64Array {
    return this.#present.mapAll(checkedPairs('mapPoints', points));
  }

  /**
   * The points of the original that are drawn at many points of the warped picture: the inverse of `mapPoints`. NaN
   * where nothing is drawn. Where the picture covers itself, the part on top.
   *
   * @param places Points × 2, pixels of the picture.
   * @throws TypeError unless `places` is a Float64Array of pairs.
   */
  unmapPoints(places: Float64Array): Float64Array {
    return this.#present.locateAll(checkedPairs('unmapPoints', places));
  }

  /**
   * The position in the shown picture, image pixels, under a position in the window such as `[event.clientX,
   * event.clientY]`. It may lie outside the picture. Null without a picture.
   *
   * @param client CSS pixels in the window.
   */
  clientToImage(client: Vec): Vec | null {
    return this.#present.imageAt(client);
  }

  /**
   * The position in the window, CSS pixels, of a position in the shown picture, such as a result of `mapPoint`. Null
   * without a picture.
   *
   * @param image Pixels of the picture.
   */
  imageToClient(image: Vec): Vec | null {
    return this.#present.clientAt(image);
  }

  /**
   * The warped picture as a file, at `scale` times the source's size: a PNG with alpha, or a JPEG or WebP by `type`.
   *
   * With `grow`, it is enlarged to contain parts that are bent beyond the frame; with `crop`, it contains only the
   * drawn part. `pixelated` is for pixel art: each pixel is one of the original, or transparent. By default, it is
   * drawn as shown. `signal` cancels the export.
   *
   * @param options How the picture is drawn and written.
   * @throws C2WarpError `no-picture` if no picture is open; `scale`, `canvas` or `nothing-drawn` if the result would be
   * empty or too large.
   * @throws TypeError for anything but an object of options, and for an unknown option; RangeError that names an
   * invalid option.
   * @throws DOMException AbortError if another picture is opened, or the element is removed, first. The reason of
   *   `signal` if that is aborted.
   */
  async toBlob(options: BlobOptions = {}): Promise<Blob> {
    checkWritten(options);
    const settings = fileSettings(options);
    return coded(writtenFile(this.#drawing(options), settings, options), options.signal);
  }

  /**
   * The warped picture on a canvas of the page's document.
   *
   * @param options How the picture is drawn.
   * @throws the errors of `toBlob`.
   */
  async toCanvas(options: WarpOptions = {}): Promise<HTMLCanvasElement> {
    checkDrawn(options);
    const canvas = this.ownerDocument.createElement('canvas');
    await coded(drawOn(canvas, this.#drawing(options), options.signal), options.signal);
    return canvas;
  }

  /** The width of the open picture, pixels; 0 without one. */
  get naturalWidth(): number {
    return this.#runtime?.state.picture?.width ?? 0;
  }

  /** The height of the open picture, pixels; 0 without one. */
  get naturalHeight(): number {
    return this.#runtime?.state.picture?.height ?? 0;
  }

  /**
   * CSS pixels per pixel of the picture, from 0.01 to 64. Setting it keeps the middle of the view.
   *
   * @default 1
   * @throws RangeError for anything but a number above 0.
   */
  get zoom(): number {
    return this.#runtime?.state.view.camera.scale ?? 1;
  }

  set zoom(scale: number) {
    if (!(Number.isFinite(scale) && scale > 0)) throw new RangeError('zoom: expected a number above 0');
    this.#present.dispatch({ type: 'zoom-asked', scale });
  }

  /** Whether there is a step to undo. */
  get canUndo(): boolean {
    return this.#runtime !== null && undoLabel(this.#runtime.state.document.history) !== null;
  }

  /** Whether there is a step to redo. */
  get canRedo(): boolean {
    return this.#runtime !== null && redoLabel(this.#runtime.state.document.history) !== null;
  }

  /**
   * Resolves once the picture that the page requested last is open and solved. Each `src`, and each `load()`, has its
   * own promise. Without either, it waits for the first picture that a person opens.
   *
   * @throws C2WarpError the error of the `error` event, if the picture cannot be opened.
   * @throws DOMException AbortError if another picture is requested first, or if `load()` is aborted.
   */
  get loaded(): Promise<void> {
    return this.#loading.promise;
  }

  /** Tells the editor that the page has stored the present project, as after `beforesave`. */
  markSaved(): void {
    const { state, dispatch } = this.#present;
    dispatch({ type: 'project-saved', project: projectOf(state) });
  }

  /** The form of the element, or null. */
  get form(): HTMLFormElement | null {
    return this.#control.form;
  }

  /** The validity state, as on form controls. */
  get validity(): ValidityState {
    return this.#control.validity;
  }

  /** The reason why the form cannot be submitted, for people; empty if it can. */
  get validationMessage(): string {
    return this.#control.validationMessage;
  }

  /** Whether the form can be submitted. Fires `invalid` if not. */
  checkValidity(): boolean {
    return this.#control.checkValidity();
  }

  /** Whether the form can be submitted. If not, the browser tells people why. */
  reportValidity(): boolean {
    return this.#control.reportValidity();
  }

  formAssociatedCallback(form: HTMLFormElement | null): void {
    this.#control.associate(form);
  }

  /** Called on a form reset: all handles return to their rest pose. */
  formResetCallback(): void {
    if (this.naturalWidth > 0) this.reset();
  }

  /** Fits the whole picture into view. */
  fit(): void {
    this.#present.dispatch({ type: 'fit-asked' });
  }

  /** Removes the element and discards its document. */
  destroy(): void {
    this.remove();
    this.#carried = nothingCarried;
  }

  /**
   * Focuses the editor, so that it receives keys.
   *
   * @param options As those of other elements.
   */
  override focus(options?: FocusOptions): void {
    this.shadowRoot?.querySelector<HTMLElement>('.shell')?.focus(options);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#loading.reopen();
    this.#asksSource = false;
    const element = {
      node: this,
      root: this.shadowRoot as ShadowRoot,
      texts: () => this.#language.current.texts,
      render: () => this.requestUpdate(),
      rendered: () => this.updateComplete,
      notifyPage: (notification: PageNotification) => {
        if (notification.type === 'load') this.#loading.opened();
        emitNotification(this.#emit, notification);
      },
      sourceFailed: (reason: unknown) =>
        this.#loading.failed(isAbort(reason) ? reason : asC2WarpError(reason)),
      ask: (question: PageQuestion) => ask(question, this.#emit),
      setTheme: (theme: 'light' | 'dark') => {
        this.theme = theme;
      },
      schemeChanged: () => this.#runtime?.dispatch({ type: 'media-changed', media: this.#media() }),
    };
    this.#runtime = new EditorRuntime(element, this.#attributes, this.#media(), this.#carried);
    this.#following = new AbortController();
    this.#language.follow(this.#following.signal);
    void this.#checkDefaults();
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#following.abort();
    const runtime = this.#runtime;
    this.#runtime = null;
    if (!runtime) return;
    this.#carried = runtime.carried(this.#carried);
    runtime.dispose();
  }

  /** @internal */
  protected override render(): unknown {
    const runtime = this.#runtime;
    if (!runtime) return null;
    const { tag, texts } = this.#language.current;
    return shell(viewModel(runtime.state, texts), tag, runtime.dispatch, runtime.canvas, runtime.laterParts);
  }

  /** @internal The editor receives each change immediately, and requests a picture once all attributes are set. */
  protected override propertyChanged(name: string): void {
    super.propertyChanged(name);
    const runtime = this.#runtime;
    const asks = (name === 'src' || (name === 'projectSource' && this.hasAttribute('project'))) && this.src;
    if (asks) this.#loading.renew();
    // The attributes of the first update are the initial content, not a change.
    if (asks && this.hasUpdated) {
      if (runtime) runtime.dispatch({ type: 'source-changed' });
      else this.#carried = { ...this.#carried, revision: this.#carried.revision + 1 };
      this.#asksSource = runtime?.isAttached === true;
    }
    if (!runtime) return;
    const locks = name === 'posable' || name === 'readonly';
    // A field that goes commits what is typed.
    if (locks || name === 'disabled') runtime.untype();
    runtime.dispatch({ type: 'page-changed', page: this.#attributes });
    if (name === 'theme') runtime.dispatch({ type: 'media-changed', media: this.#media() });
    if (runtime.isAttached && (locks || name === 'toolSource')) this.#takeTool();
  }

  /** @internal */
  protected override updated(changes: Changes): void {
    const runtime = this.#runtime;
    if (!runtime) return;
    runtime.repairFocus();
    const isFirst = !runtime.isAttached;
    if (isFirst || changes.has('autosave'))
      runtime.dispatch({ type: 'autosave-key-set', key: this.autosave || null });
    if (!isFirst && (changes.has('posable') || (this.posable && changes.has('readonly'))))
      runtime.rearrange();
    if (isFirst) this.#takeTool();
    for (const fault of attributeFaults(this, C2Warp.properties, changes)) this.#emit('error', fault);
    this.#control.validate(
      this.required && this.naturalWidth === 0 ? this.#language.current.texts.stage.required : null,
    );
    const stage = this.shadowRoot?.querySelector<HTMLElement>('.stage');
    if (isFirst && stage) runtime.attach(stage, this.#carried.work);
    else this.#askSource();
  }

  /** Opens what changed attributes name. */
  #askSource(): void {
    if (this.#asksSource) this.#runtime?.dispatch({ type: 'source-asked' });
    this.#asksSource = false;
  }

  /** @throws RangeError immediately for an invalid option. */
  #drawing({ signal, pixelated, ...options }: WarpOptions): Promise<Drawing> {
    const settings = drawingSettings(options);
    if (signal?.aborted) return Promise.reject(signal.reason);
    return this.#present.drawing(settings, pixelated);
  }

  /** The warped picture, with the file name of an export. */
  async #picture(): Promise<File> {
    const blob = await this.toBlob();
    return new File([blob], `${stem(this.#present.state.picture?.name ?? '')}-warped.png`, {
      type: blob.type,
    });
  }

  /** Chooses the tool that the page has set. */
  #takeTool(): void {
    const { toolSource: tool } = this;
    if (tool) this.#runtime?.dispatch({ type: 'tool-set', tool });
  }

  get #present(): EditorRuntime {
    if (!this.#runtime)
      throw new C2WarpError('disconnected', '<c2-warp> is not on a page, so it has no picture');
    return this.#runtime;
  }

  get #document(): Document {
    return documentOf(this.#present.state);
  }

  get #attributes(): PageAttributes {
    return pageAttributes(this, this.#defaults);
  }

  /** Mirrors the layout if the direction changes. */
  #takeDirection(): void {
    const runtime = this.#runtime;
    const media = this.#media();
    if (runtime && media.rtl !== runtime.state.media.rtl) runtime.dispatch({ type: 'media-changed', media });
  }

  #setDefaults(settings: ProjectDefaults): void {
    this.#defaults = settings;
    this.propertyChanged('defaults');
  }

  /** The solver checks the values, once it has started. */
  async #checkDefaults(): Promise<void> {
    const settings = this.#defaults;
    try {
      await this.#runtime?.checkDefaults(settings);
    } catch (error) {
      if (this.#defaults === settings) this.#setDefaults({});
      this.#emit('error', asC2WarpError(error));
    }
  }

  #setPageProject(project: ProjectFile | null): void {
    if (this.#runtime) this.#runtime.dispatch({ type: 'page-project-set', project });
    else this.#carried = { ...this.#carried, pageProject: project };
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
