/**
 * A running editor, from the element's connection to its disconnection: the store, and every resource that carries out
 * its effects. `dispose` releases all of them.
 */

import type { Drawing } from '../compute/drawing';
import type { DrawingOptions } from '../compute/messages';
import type { Pose } from '../compute/posed_picture';
import type { ProjectDefaults } from '../document/defaults';
import { newProject } from '../document/document';
import type { Project, ProjectFile } from '../document/project';
import type { EditorEffect, PageNotification } from '../editor/effects';
import type { EditorEvent } from '../editor/events';
import { isLassoing, isStiffening } from '../editor/hit_areas';
import { initialState } from '../editor/initial_state';
import { type Carried, initialOpening } from '../editor/opening_state';
import type { Media, PageAttributes } from '../editor/page';
import { type PageQuestion, questionsOf } from '../editor/page_question';
import { mayReceive } from '../editor/permissions';
import { misfit, type NamedFile } from '../editor/picture';
import { isPlaying } from '../editor/played_clip';
import { type EditorState, overlaysOf, projectOf } from '../editor/state';
import { snapshotOf } from '../editor/update/autosave';
import { drawn } from '../editor/update/drawn';
import { asError, C2WarpError } from '../error';
import { deviceView } from '../geometry/camera';
import type { HeatMap } from '../geometry/heat';
import type { MappedPoint } from '../geometry/place';
import type { Vec } from '../geometry/vec';
import { type DropReceiver, DropTarget } from '../input/drop';
import type { Texts } from '../texts/texts';
import { say } from '../texts/wording';
import { isPressing } from '../tools/machine';
import { focusExport } from '../ui/export/menu';
import type { ExportPages } from '../ui/export_pages';
import type { LaterParts } from '../ui/shell';
import type { TimelineView } from '../ui/timeline_view';
import { CanvasView } from './canvas_view';
import { Clipboard } from './clipboard';
import { Clock } from './clock';
import { carryOut, type Resources } from './effects';
import { Exports } from './exports';
import { Files } from './files';
import { Focus } from './focus';
import { FocusKeeper } from './focus_keeper';
import { type Frame, Frames } from './frames';
import { Glide } from './glide';
import { LazyView } from './lazy_view';
import { MediaWatcher } from './media_watcher';
import { MenuPopover } from './menu_popover';
import { Pictures, withFileName } from './pictures';
import { ReachCache } from './reach_cache';
import { Solver } from './solver';
import { Storage } from './storage';
import { Store } from './store';
import { Study } from './study';
import { Timers } from './timers';

/** The element that the editor runs in, and its answers to the editor. */
export interface EditorElement {
  readonly node: HTMLElement;
  readonly root: ShadowRoot;
  /** All texts, in the language of the element. */
  texts(): Texts;
  /** The state has changed: render it. */
  render(): void;
  /** Resolves once the last state is rendered. */
  rendered(): Promise<unknown>;
  notifyPage(notification: PageNotification): void;
  /** Whether the page lets the action continue. */
  ask(question: PageQuestion): boolean;
  /** The picture of the attributes cannot be opened, or a person has opened another one first. */
  sourceFailed(reason: unknown): void;
  setTheme(theme: 'light' | 'dark'): void;
  /** The system switched between light and dark colours. */
  schemeChanged(): void;
}

/** From a place to itself and to places a pixel away. */
const BESIDE: readonly Vec[] = [
  [0, 0],
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
];

export class EditorRuntime {
  readonly canvas = document.createElement('canvas');
  readonly dispatch: (event: EditorEvent) => void;
  readonly #element: EditorElement;
  readonly #store: Store;
  readonly #pictures = new Pictures();
  readonly #solver: Solver;
  readonly #files: Files;
  readonly #exports: Exports;
  readonly #storage: Storage;
  readonly #timers: Timers;
  readonly #clock: Clock;
  readonly #focus: Focus;
  readonly #focusKeeper: FocusKeeper;
  readonly #menu: MenuPopover;
  readonly #clipboard: Clipboard;
  readonly #drop: DropTarget;
  readonly #media: MediaWatcher;
  readonly #reach: ReachCache;
  readonly #study: Study;
  readonly #timeline: LazyView<TimelineView>;
  readonly #exportPages: LazyView<ExportPages>;
  readonly #listening = new AbortController();
  readonly #loads = new Map<number, { resolve(): void; reject(reason: unknown): void }>();
  #lastReply = 0;
  #view: CanvasView | null = null;
  #frames: Frames | null = null;
  readonly #glide = new Glide();
  /** The last project in whose pose the picture came to rest. */
  #rested: Project | null = null;

  constructor(element: EditorElement, page: PageAttributes, media: Media, carried: Carried) {
    this.#element = element;
    this.#store = new Store(initialState(page, media, initialOpening(carried)), {
      changed: (state, event) => this.#changed(state, event),
      admits: (before, after, event) =>
        questionsOf(before, after, event).every((question) => element.ask(question)),
      carryOut: (effect) => carryOut(effect, resources),
    });
    const { dispatch } = this.#store;
    this.dispatch = dispatch;
    this.#solver = new Solver(dispatch);
    this.#files = new Files(dispatch, this.#pictures, this.#solver);
    this.#exports = new Exports(dispatch);
    this.#storage = new Storage(dispatch);
    this.#timers = new Timers((timer) => dispatch({ type: 'timer-elapsed', timer }));
    // Out of sight time stands still.
    this.#clock = new Clock((seconds) => {
      if (this.#frames?.seen) dispatch({ type: 'clock-ticked', seconds });
    });
    this.#focus = new Focus(element.root);
    this.#focus.watch(dispatch, this.#listening.signal);
    this.#focusKeeper = new FocusKeeper(element.node);
    this.#menu = new MenuPopover(element.root, () => dispatch({ type: 'menu-command-run', command: null }));
    const receive: DropReceiver = {
      files: (files) => dispatch({ type: 'files-received', files }),
      address: (text) =>
        dispatch(
          text === null
            ? { type: 'person-informed', text: say('notices.nothingDropped') }
            : { type: 'address-given', text },
        ),
    };
    this.#drop = new DropTarget(element.node, () => mayReceive(this.state), receive);
    this.#clipboard = new Clipboard(element.node, this.#store, this.#focus, element.texts);
    this.#media = new MediaWatcher({
      schemeChanged: () => element.schemeChanged(),
      pixelRatioChanged: () => this.#frames?.request(),
    });
    this.#reach = new ReachCache(() => this.#frames?.request());
    this.#study = new Study(element.root, this.#store, this.#pictures, element.texts);
    this.#timeline = new LazyView(
      element.root,
      async () => (await import('../ui/timeline/timeline')).timelineView,
    );
    this.#exportPages = new LazyView(
      element.root,
      async () => (await import('../ui/export/pages')).exportPages,
    );
    const resources = this.#resourcesOf(element);
  }

  get state(): EditorState {
    return this.#store.state;
  }

  get laterParts(): LaterParts {
    return { study: this.#study.view, timeline: this.#timeline.view, exportPages: this.#exportPages.view };
  }

  /** Whether the stage is on the page. */
  get isAttached(): boolean {
    return this.#view !== null;
  }

  /** Starts input and drawing, once the stage is on the page, and opens the first content. */
  attach(stage: HTMLElement, work: Carried['work']): void {
    this.#view = new CanvasView(this.#element.root, stage, this.#store, this.#focus);
    try {
      this.#frames = new Frames(this.canvas, {
        frame: () => this.#frame(),
        seen: () => this.#element.render(),
        lost: () => this.dispatch({ type: 'graphics-lost' }),
        restored: () => this.dispatch({ type: 'graphics-restored' }),
        failed: (error) => this.dispatch({ type: 'error-reported', error: asError(error) }),
      });
    } catch (error) {
      this.dispatch({ type: 'error-reported', error: asError(error) });
    }
    this.dispatch({ type: 'started', work });
  }

  /** Adapts the input to the current `posable` and `readonly`, after they were rendered. */
  rearrange(): void {
    this.#view?.rearrange();
  }

  /** Restores a lost focus; called after each render. */
  repairFocus(): void {
    this.#focusKeeper.repair();
  }

  /** Drops a number that is being typed. */
  untype(): void {
    this.#focus.untypeField();
  }

  /**
   * Opens a picture for the page. Resolves once it is solved. The newest call wins.
   *
   * @throws the reason of the signal if that is aborted first. The picture before stays open.
   */
  load(
    source: string | NamedFile,
    project: string | ProjectFile | null,
    { notice = false, signal }: { readonly notice?: boolean; readonly signal?: AbortSignal | undefined },
  ): Promise<void> {
    const reply = ++this.#lastReply;
    const cancel = () => {
      this.#settleLoad(reply, signal?.reason);
      this.dispatch({ type: 'load-cancelled', reply });
    };
    const loaded = new Promise<void>((resolve, reject) => {
      this.#loads.set(reply, { resolve, reject });
      this.dispatch({ type: 'load-asked', reply, source, project, notice });
      signal?.addEventListener('abort', cancel);
    });
    return loaded.finally(() => signal?.removeEventListener('abort', cancel));
  }

  /** Adopts a project of the page. @throws C2WarpError that names the invalid key, or both sizes. */
  adopt(given: ProjectFile): void {
    const { picture, solution } = this.state;
    if (!picture || !solution.ready)
      throw new C2WarpError('no-picture', 'open a picture before you set a project');
    const project = this.#solver.checkProject(given);
    const error = misfit(picture, project);
    if (error) throw error;
    this.dispatch({ type: 'project-adopted', project });
  }

  /** @throws C2WarpError `project` that names an invalid value in settings of new projects. */
  async checkDefaults(defaults: ProjectDefaults): Promise<void> {
    if (Object.keys(defaults).length === 0) return;
    const project = newProject({ src: '', width: 1, height: 1 }, null, defaults);
    try {
      await this.#solver.readProject(JSON.stringify(project));
    } catch (error) {
      throw withFileName('defaults', error);
    }
  }

  /** Where a point of the original is posed; null outside the warped area. */
  map(rest: Vec): MappedPoint | null {
    const { shown } = this.state.solution;
    return shown && this.#solver.deformationOf(shown).map(projectOf(this.state), rest);
  }

  /** Whether a point of the original is certainly outside the domain. Near the outline, the solver decides. */
  isOutside([x, y]: Vec): boolean {
    const { shown, ready } = this.state.solution;
    if (!shown || !ready) return false;
    const deformation = this.#solver.deformationOf(shown);
    return !BESIDE.some(([right, down]) => deformation.bends([x + right, y + down]));
  }

  /** Points × 2: where points of the original are posed, or NaN outside the warped area. */
  mapAll(rest: Float64Array): Float64Array {
    return this.#pose?.mapPoints(rest) ?? rest.map(() => Number.NaN);
  }

  /** Points × 2: the points of the original that are drawn at places, or NaN beside the picture. */
  locateAll(posed: Float64Array): Float64Array {
    return this.#pose?.locatePoints(posed) ?? posed.map(() => Number.NaN);
  }

  /** Null without a picture. */
  imageAt(client: Vec): Vec | null {
    return (this.state.picture && this.#view?.imageAt(client)) ?? null;
  }

  /** Null without a picture. */
  clientAt(image: Vec): Vec | null {
    return (this.state.picture && this.#view?.clientAt(image)) ?? null;
  }

  /** The warped picture, ready to be drawn, see `Engine.draw`; by default as pixel art if it is shown so. */
  async drawing(asked: Omit<DrawingOptions, 'pixelated'>, pixelated = this.#isPixelated): Promise<Drawing> {
    if (!this.state.picture) throw new C2WarpError('no-picture', 'Open a picture first.');
    // The pose at this moment: the page may set the next one meanwhile.
    const { project, moment } = drawn(this.state);
    return this.#solver.draw(project, { ...asked, pixelated }, moment);
  }

  /** What the next runtime of the element continues with. */
  carried(before: Carried): Carried {
    const { awaiting, recent, revision, openedRevision, pageProject, pageSelection } = this.state.opening;
    const work = snapshotOf(this.state) ?? before.work;
    return { awaiting, recent, revision, openedRevision, pageProject, pageSelection, work };
  }

  dispose(): void {
    this.#store.dispose();
    this.#listening.abort();
    this.#timers.dispose();
    this.#clock.run(false);
    this.#study.dispose();
    this.#reach.dispose();
    this.#media.dispose();
    this.#drop.dispose();
    this.#clipboard.dispose();
    this.#menu.dispose();
    this.#focusKeeper.dispose();
    this.#view?.dispose();
    this.#frames?.dispose();
    this.#storage.dispose();
    this.#files.dispose();
    this.#exports.cancel();
    this.#solver.dispose();
    this.#pictures.dispose();
    for (const { reject } of this.#loads.values())
      reject(new DOMException('the editor was removed', 'AbortError'));
    this.#loads.clear();
  }

  get #pose(): Pose | null {
    const { shown } = this.state.solution;
    return shown && this.#solver.deformationOf(shown).pose(projectOf(this.state));
  }

  #changed(state: EditorState, event: EditorEvent): void {
    this.#pictures.releaseUnused(state);
    this.#solver.freeUnused(state);
    if (!isPressing(state.tools) && event.type !== 'handles-posed') this.#rest(state);
    // The clock ticks at the beginning of a frame: a later one would show the picture behind its handles.
    if (event.type === 'clock-ticked') this.#frames?.drawNow();
    else this.#frames?.request();
    this.#study.follow(() => this.#element.render());
    if (state.timeline.open) this.#loadTimeline();
    if (state.display.popover === 'export' && state.exporting.kind !== 'picture') this.#loadExportPages();
    // An animation out of sight is rendered once it is seen.
    const moves = event.type === 'handles-posed' || event.type === 'clock-ticked';
    if (!moves || this.#frames?.seen) this.#element.render();
  }

  /** Shows the pose that depends on the project only, after the last frame of a drag or a step. */
  #rest(state: EditorState): void {
    const project = projectOf(state);
    const { shown } = state.solution;
    if (!shown || project === this.#rested) return;
    this.#rested = project;
    const deformation = this.#solver.deformationOf(shown);
    const last = deformation.pose(project);
    const pose = deformation.rest(project);
    const now = performance.now();
    if (last && pose && pose !== last && !state.media.still) this.#glide.begin(last, pose, now);
  }

  #loadTimeline(): void {
    const failed = (error: Error) => {
      this.dispatch({ type: 'timeline-opened', open: false });
      this.dispatch({ type: 'error-reported', error });
    };
    const loaded = () => {
      this.#element.render();
      this.#element.rendered().then(() => this.#focus.moveToControl('timeline'));
    };
    this.#timeline.want(loaded, failed);
  }

  #loadExportPages(): void {
    const failed = (error: Error) => {
      this.dispatch({ type: 'export-kind-chosen', kind: 'picture' });
      this.dispatch({ type: 'error-reported', error });
    };
    const loaded = () => {
      this.#element.render();
      this.#element.rendered().then(() => focusExport(this.#element.root));
    };
    this.#exportPages.want(loaded, failed);
  }

  #frame(): Frame {
    const { state } = this;
    const { picture, solution, view, stage, display } = state;
    const deformation = solution.shown && this.#solver.deformationOf(solution.shown);
    const project = projectOf(state);
    const pose = deformation?.pose(project) ?? null;
    const drawn = pose && this.#glide.at(pose, performance.now());
    const bare = display.preview !== null || isLassoing(state);
    return {
      picture: picture && this.#pictures.opened(picture).texture,
      fill: this.#solver.fillOf(state),
      solution: deformation?.data ?? null,
      pose: drawn,
      heat: bare ? null : this.#heat(),
      moves: isPressing(state.tools) || state.timeline.playing || isPlaying(state) || this.#glide.gliding,
      glides: this.#glide.gliding,
      view: {
        ...deviceView(view.camera, stage, devicePixelRatio),
        compare: display.preview === 'compare' || isLassoing(state),
        overlays: bare ? {} : overlaysOf(state),
        pixelated: this.#isPixelated,
        exportScale: state.exporting.choices.percent / 100,
      },
    };
  }

  #heat(): HeatMap | null {
    const { shown } = this.state.solution;
    const { reach, coverage, stiffness } = overlaysOf(this.state);
    const stiff = stiffness || isStiffening(this.state);
    if (!shown || !(reach || coverage || stiff)) return null;
    const deformation = this.#solver.deformationOf(shown);
    if (stiff) return { values: deformation.stiffness(projectOf(this.state)), lines: false };
    const values = coverage ? deformation.coverage() : this.#reach.reach(this.state, deformation);
    return values && { values, lines: reach };
  }

  /** Whether the picture is drawn as pixel art: as the person says, or the page's `image-rendering`. */
  get #isPixelated(): boolean {
    return this.state.pixelated || getComputedStyle(this.canvas).imageRendering === 'pixelated';
  }

  #settleLoad(reply: number, error: unknown): void {
    const load = this.#loads.get(reply);
    this.#loads.delete(reply);
    if (error === null) load?.resolve();
    else load?.reject(asReason(error));
  }

  #adoptPageProject({ project, selection }: Extract<EditorEffect, { type: 'adopt-page-project' }>): void {
    try {
      this.adopt(project);
    } catch (error) {
      this.dispatch({ type: 'error-reported', error: asError(error) });
    }
    if (selection) this.dispatch({ type: 'handles-selected', ids: selection });
  }

  #resourcesOf(element: EditorElement): Resources {
    const runtime = this;
    return {
      root: element.root,
      get state() {
        return runtime.state;
      },
      get pixelated() {
        return runtime.#isPixelated;
      },
      clipboard: this.#clipboard,
      clock: this.#clock,
      dispatch: this.dispatch,
      exports: this.#exports,
      files: this.#files,
      focus: this.#focus,
      menu: this.#menu,
      pictures: this.#pictures,
      solver: this.#solver,
      storage: this.#storage,
      study: this.#study,
      timers: this.#timers,
      rendered: () => element.rendered(),
      notifyPage: (notification) => element.notifyPage(notification),
      ask: (question) => element.ask(question),
      settleLoad: (reply, error) => this.#settleLoad(reply, error),
      adoptPageProject: (effect) => this.#adoptPageProject(effect),
      sourceFailed: (error) => element.sourceFailed(asReason(error)),
      setTheme: (theme) => element.setTheme(theme),
      releaseInput: () => element.rendered().then(() => this.dispatch({ type: 'input-released' })),
    };
  }
}

const asReason = (error: unknown): unknown =>
  error === 'superseded' ? new DOMException('another picture was opened', 'AbortError') : error;
