/**
 * `<c2-warp>`: the editor as a custom element.
 *
 * Its manifest, types for frameworks and the tables of `web/docs/element.md` are made from the comments here, of
 * `element/events.ts` and of `error.ts`.
 *
 * `tool` is selected when it is set, when the element is connected, and when `readonly` or `posable` is removed. With
 * `posable` people can only pose the existing handles. The page keeps all wheel, touch and key input that acts on no
 * handle. `load` follows `src`, `load()`, work restored from `autosave`, and reconnection of an element that has a
 * document.
 *
 * Setting `readonly` or `disabled`, and setting or removing `posable`, cancels the drag, drawing or typed number in
 * progress. A page may have several elements. An element that is removed releases its worker and its WebGL context, and
 * keeps its document until it is connected again. Properties may be set before the element is connected, even before
 * it is defined. Servers and workers can import this file: it defines no element there.
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
 * An editor that warps a picture by handles.
 *
 * @slot toolbar - Controls of the page in the toolbar. They keep their keys. With `posable` they are not shown.
 * @slot panel - Controls of the page at the end of the panel.
 * @csspart stage - The picture with its handles, and the ground behind them.
 * @csspart handle - A point handle, the middle of a bar or polygon, or a corner: the square that a finger hits.
 * @csspart toolbar - The bar at the top.
 * @csspart status - The line at the bottom.
 * @csspart tools - The card of tools.
 * @csspart panel - The card of properties.
 * @csspart timeline - The card of the clips and their keys.
 * @csspart button - A button in any of these, or beside a drawing.
 * @csspart menu - The context menu, the list of keys, and the menu of a phone.
 * @csspart notice - A message of the editor, and the card that finishes a drawing.
 * @csspart hint - A few words over the picture, such as the purpose of a tool.
 * @cssprop {<color>} --c2-accent - The colour of the selection and the focus. Text on it is white, and nearly black on
 *   dark colours.
 * @cssprop {<color>} --c2-handle - The colour of handles, bars and polygons, on light and dark pictures alike.
 * @cssprop {<color>} --c2-ground - The first of two colours behind the picture: by default near the surface. With
 *   `posable`, none unless set.
 * @cssprop {<color>} --c2-checker - The second of them, in the squares of the pattern.
 * @cssprop {<color>} --c2-surface - The colour of bars, cards and hints. Tooltips have it as the colour of their text.
 * @cssprop {<color>} --c2-text - The colour of the text on them.
 * @cssprop {<length>} --c2-radius - The corner radius of cards. Those of buttons, fields and hints follow it.
 * @cssprop --c2-font - The font family.
 */
export class C2Warp extends TypedElement {
  /** @internal */
  static override readonly styles = editorStyle;

  /** It is a control of its form. */
  static readonly formAssociated = true;

  /**
   * The tags of all languages: those of the package, and those that the page has added.
   *
   * An element shows the language of its attribute `lang`, or of the nearest ancestor with one, as HTML has it. For
   * `de-AT` without texts of its own it shows `de`, and without any English. It follows `dir` in the same way.
   */
  static get languages(): readonly string[] {
    return languageTags();
  }

  /**
   * Adds a language, or changes texts of one. Elements on the page show it at once.
   *
   * @param tag A BCP 47 tag, such as `pt-BR`. A second call with it replaces the first.
   * @param texts All texts, or some of them. The others are those of the package, or English.
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
  /** The address of the project file for `src`. Both are opened again when either changes. */
  declare projectSource: string;
  /** The tool that the page has set last. People may have chosen another one since: see the property `tool`. */
  declare toolSource: ToolName | null;
  /** People can look, pan and zoom, but change nothing. Methods still can. */
  declare readonly: boolean;
  /** People can do nothing. Methods still can. */
  declare disabled: boolean;
  /** Only the picture and its handles, for an article. With `readonly`, only the picture. */
  declare posable: boolean;
  /** The name of the clip that `play()` plays. Without it the first one. */
  declare clip: string;
  /** Plays the clip once the picture is open, unless people prefer reduced motion. */
  declare autoplay: boolean;
  /** The clip begins again at its end. */
  declare loop: boolean;
  /** Light or dark colours. By default, `auto`, those of the system. */
  declare theme: 'light' | 'dark' | 'auto';
  /** With `posable`: what the picture shows, for screen readers. Without it they read its name. */
  declare alt: string;
  /** A hint, shown until the first change. */
  declare hint: string;
  /** The id of the handle that the hint points to. Without it the first one. */
  declare hintFor: string;
  /**
   * A key in browser storage. Work is stored there after each step, and restored in place of the first `src`.
   */
  declare autosave: string;
  /** Pictures that the menu beside Open offers: a list of `{ name, src, project? }` with addresses. */
  declare samples: readonly Sample[];
  /** The parts that people get: words of `tools`, `open`, `save`, `export` and `animate`. Without it all. */
  declare features: string | null;
  /** A form is not submitted without a picture. */
  declare required: boolean;
  /** The name under which a form submits the value. */
  declare name: string;
  /** The value in a form: the project as JSON, which is the default, or the warped picture as a PNG file. */
  declare submits: 'project' | 'picture';
  /** Whether requests to other origins carry cookies. Without it, and by `anonymous`, they do not. */
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
  /** What a runtime starts with: what the page set before, and what the last runtime left. */
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
   * A project that is set earlier is applied to the next picture, whoever opens it. If the sizes differ, the element
   * emits an `error`. A string is the address of a project file, like the attribute.
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
   * Ids of the selected handles; null selects none. A selection that is set earlier is applied to the next picture.
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
   * and `loose_parts`. Those that are left out are the editor's. Projects that are opened keep their own.
   *
   * @throws RangeError that names an unknown key; TypeError for anything but an object or null. An invalid value is an
   *   `error` with the code `project`, and all settings are the editor's again.
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
   * The tool in hand, by whoever chose it. Setting one chooses it, where people could. A name that is none changes
   * nothing and emits an `error`.
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
   * With `notice`, a failure is told to the person too. `signal` gives it up.
   *
   * @param source An address, a file, or pixels.
   * @param project A project, or the address of a project file.
   * @param options With `notice`, the editor names a failure.
   * @throws C2WarpError if the picture cannot be opened. The previous one stays open. If there was none, the picture
   *   stays without the handles that the solver refuses.
   * @throws DOMException AbortError if another picture is opened or the element is removed first; the reason of
   *   `signal` if that is aborted.
   * @throws TypeError if `source` is none of these.
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
        throw new DOMException('another picture was asked for, or the editor is gone', 'AbortError');
      options.signal?.throwIfAborted();
      await coded(runtime.load(picture, copied, options), options.signal);
    };
    const opened = open();
    this.#loading.follow(opened);
    return opened;
  }

  /**
   * Opens files as if a person had dropped them here: a picture, a project, or both. The rest is named in a notice.
   *
   * Does nothing where people may not open files. The person hears of a failure.
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
   * Opens what a link or another program brings, once the person agrees if a picture is open.
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
   * Tells a person something in a notice, which passes after some seconds. With `posable` there are none.
   *
   * @param text A sentence for people.
   */
  inform(text: string): void {
    this.#present.dispatch({ type: 'person-informed', text: String(text) });
  }

  /**
   * Adds a handle, with a generated id if it has none, and returns the id. Without a rotation it turns as one that a
   * person adds: by itself in rigid mode. The solver may refuse the handle later, for example too close to another.
   * Then an `error` follows, and a `change` that removes this handle alone.
   *
   * @param handle Its places are in pixels of the picture.
   * @returns The id.
   * @throws RangeError if the id exists already, or the handle is invalid.
   * @throws C2WarpError `no-picture` if no picture is open, `handle-outside` for a point outside the picture.
   */
  addHandle(handle: NewHandle): string {
    const { state, dispatch } = this.#present;
    if (!state.picture) throw new C2WarpError('no-picture', 'there is no picture yet to put a handle on');
    if (typeof handle !== 'object' || handle === null) throw new RangeError('a handle: expected an object');
    const id = handle.id ?? freeId(projectOf(state));
    if (handleById(documentOf(state), id)) throw new RangeError(`there is a handle "${id}" already`);
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
   * Changes a handle, as a step. Keys that are left out stay.
   *
   * @param id The handle.
   * @param change Places in pixels of the picture, degrees, and a factor of the size.
   * @throws RangeError if there is no such handle, the id or kind would change, or the result is invalid.
   */
  updateHandle(id: string, change: Partial<Omit<Handle, 'id' | 'kind'>>): void {
    this.#present.dispatch({ type: 'handle-changed', handle: changedHandle(this.#document, id, change) });
  }

  /**
   * Poses any number of handles at once, for animation. Takes the handles of a project, or ids with changes.
   *
   * This is no undo step, emits nothing and is not stored until the next step. Handles that a person holds at the
   * moment are left alone.
   *
   * @param handles Places in pixels of the picture, degrees, and factors of the size.
   * @throws RangeError if there is no such handle, or a pose is invalid; TypeError without a list. Then nothing moves.
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
   * @throws RangeError if there is no such handle.
   */
  removeHandle(id: string): void {
    this.#present.dispatch({ type: 'handle-removed', id: namedHandle(this.#document, id).id });
  }

  /** Undoes the last step, if there is one. */
  undo(): void {
    this.#present.dispatch({ type: 'undo-asked' });
  }

  /** Redoes the step that was undone last, if there is one. */
  redo(): void {
    this.#present.dispatch({ type: 'redo-asked' });
  }

  /** Returns all handles to their rest pose. */
  reset(): void {
    this.#present.dispatch({ type: 'reset-asked' });
  }

  /**
   * Plays the clip, from its beginning if it has ended. Closes the timeline. People can go on to pose handles. These
   * ease back to the clip once they are let go.
   *
   * @throws C2WarpError `clip` if the project has no such clip.
   */
  async play(): Promise<void> {
    const { state, dispatch } = this.#present;
    if (!playedClip(state))
      throw new C2WarpError(
        'clip',
        this.clip === null ? 'there is no clip' : `there is no clip "${this.clip}"`,
      );
    dispatch({ type: 'play-asked' });
  }

  /** Pauses the clip. */
  pause(): void {
    this.#runtime?.dispatch({ type: 'pause-asked' });
  }

  /** Whether the clip does not play. */
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

  /** Seconds; NaN without a clip. A clip that alternates lasts there and back. */
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
   * The posed place of a point of the original, image pixels; null outside the warped area.
   *
   * @param point Pixels of the picture.
   */
  mapPoint(point: Vec): Vec | null {
    return this.#present.map(point)?.posed ?? null;
  }

  /**
   * The posed places of many points of the original: points × 2, image pixels, and NaN outside the warped area. All are
   * found in one walk over the mesh, which costs hardly more than that for a single point.
   *
   * @param points Points × 2, pixels of the picture.
   * @throws TypeError unless `points` is a Float64Array of pairs.
   */
  mapPoints(points: Float64Array): Float64Array {
    return this.#present.mapAll(checkedPairs('mapPoints', points));
  }

  /**
   * The points of the original that are drawn at many places of the warped picture: the inverse of `mapPoints`. NaN
   * where nothing is drawn. Where the picture covers itself, it is the part on top.
   *
   * @param places Places × 2, pixels of the picture.
   * @throws TypeError unless `places` is a Float64Array of pairs.
   */
  unmapPoints(places: Float64Array): Float64Array {
    return this.#present.locateAll(checkedPairs('unmapPoints', places));
  }

  /**
   * The place of the shown picture, image pixels, under a place in the window such as `[event.clientX, event.clientY]`.
   * It may lie beside the picture. Null without a picture.
   *
   * @param client CSS pixels in the window.
   */
  clientToImage(client: Vec): Vec | null {
    return this.#present.imageAt(client);
  }

  /**
   * The place in the window, CSS pixels, of a place of the shown picture such as that of `mapPoint`. Null without a
   * picture.
   *
   * @param image Pixels of the picture.
   */
  imageToClient(image: Vec): Vec | null {
    return this.#present.clientAt(image);
  }

  /**
   * The warped picture as a file, at `scale` times the source's size: a PNG with alpha, or a JPEG or WebP by `type`.
   *
   * With `grow` it is enlarged to hold the parts that are bent beyond the frame, with `crop` it holds only the drawn
   * part. `pixelated` is for pixel art: each pixel is one of the original, or transparent. By default it is drawn as it
   * is shown. `signal` stops it.
   *
   * @param options How it is drawn and written.
   * @throws C2WarpError `no-picture` if none is open; `scale`, `canvas` or `nothing-drawn` if the result would be
   *   empty or too large.
   * @throws TypeError for anything but an object of options, and for an unknown one; RangeError that names an invalid
   *   option.
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
   * @param options How it is drawn.
   * @throws as `toBlob`.
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
   * Resolves once the picture is open and solved that the page has asked for last, at once if it is. Each `src`, and
   * each `load()`, has a promise of its own. Without either, it is the picture that a person opens first.
   *
   * @throws C2WarpError as an `error` event has it, if the picture cannot be opened.
   * @throws DOMException AbortError if another picture is asked for first; otherwise as `load()`.
   */
  get loaded(): Promise<void> {
    return this.#loading.promise;
  }

  /** Tells the editor that the page has stored the present project, as after `beforesave`. */
  markSaved(): void {
    const { state, dispatch } = this.#present;
    dispatch({ type: 'project-saved', project: projectOf(state) });
  }

  /** The form that the element is a control of, or null. */
  get form(): HTMLFormElement | null {
    return this.#control.form;
  }

  /** Whether the form may be submitted, and why not, as on form controls. */
  get validity(): ValidityState {
    return this.#control.validity;
  }

  /** Why the form may not be submitted, for people; empty if it may. */
  get validationMessage(): string {
    return this.#control.validationMessage;
  }

  /** Whether the form may be submitted. Fires `invalid` if not. */
  checkValidity(): boolean {
    return this.#control.checkValidity();
  }

  /** Whether the form may be submitted. If not, the browser tells people why. */
  reportValidity(): boolean {
    return this.#control.reportValidity();
  }

  formAssociatedCallback(form: HTMLFormElement | null): void {
    this.#control.associate(form);
  }

  /** A form is reset: all handles return to their rest pose. */
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
   * Focuses the editor itself, which handles the keys.
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

  /** @internal The editor takes each change at once, and asks for a picture once all attributes are set. */
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

  /** @throws RangeError at once for an invalid option. */
  #drawing({ signal, pixelated, ...options }: WarpOptions): Promise<Drawing> {
    const settings = drawingSettings(options);
    if (signal?.aborted) return Promise.reject(signal.reason);
    return this.#present.drawing(settings, pixelated);
  }

  /** The warped picture, named as an export is. */
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
      throw new C2WarpError('disconnected', '<c2-warp> is not on a page, and has no picture there');
    return this.#runtime;
  }

  get #document(): Document {
    return documentOf(this.#present.state);
  }

  get #attributes(): PageAttributes {
    return pageAttributes(this, this.#defaults);
  }

  /** The layout goes the other way where another direction is asked for. */
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
