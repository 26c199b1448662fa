/**
 * A running editor, from the element's `connectedCallback` to its `disconnectedCallback`: the workbench and everything
 * that shows it.
 *
 * The element hosts the desk and renders its model. Everything that holds a worker, a WebGL context or a listener
 * belongs to the desk, so that `dispose` releases all of it.
 */
import { blendOf } from '../document/bending';
import { selectedHandles } from '../document/document';
import { anchor, corners, nameOf } from '../document/handle';
import { deviceView, panned } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { ToolName } from '../tools/machine';
import type { Effect } from '../tools/state';
import type { CommandName } from '../ui/commands';
import type { EditorActions, EditorModel, Hint, Notice, OverlayFlags } from '../ui/model';
import { showSelected } from '../ui/panel';
import { Drawing } from './drawing';
import type { EditCommands } from './edit_commands';
import type { ChangeKind } from './editing';
import type { Emit } from './events';
import { type Aside, Files } from './files';
import { Input } from './input';
import { Keeping } from './keeping';
import { Notices } from './notices';
import type { Picture } from './picture';
import { PoseChecks } from './pose_checks';
import { Reaching } from './reaching';
import { run } from './running';
import { Surroundings } from './surroundings';
import type { Turn } from './turn';
import { type Look, Viewing } from './viewing';
import { type Kept, Workbench } from './workbench';

export interface DeskHost {
  readonly root: ShadowRoot;
  readonly readonly: boolean;
  readonly disabled: boolean;
  readonly play: boolean;
  readonly dark: boolean;
  /** The tool set by the page. */
  readonly tool: string | null;
  readonly aside: Aside;
  /** Shown until the first change, beside this handle, or beside the first if there is none of this id. */
  readonly hint: { readonly text: string; readonly handle: string | null } | null;
  /** The model has changed: render again. */
  changed(): void;
  /** A picture is open, whether the page or a person opened it. */
  opened(): void;
  edited(kind: ChangeKind): void;
  readonly emit: Emit;
  switchTheme(): void;
}

/** Room for the hint beside a handle, CSS pixels. */
const HINT_WIDTH = 170;

const NO_OVERLAYS: OverlayFlags = { mesh: false, sites: false, graph: false, folds: false, reach: false };

/** The undo and redo label while something is being drawn. */
const SET_CORNER = 'Set a corner';

/** Nudges merge into one undo step unless the pause between them is longer. */
const SETTLE_MS = 800;

export class Desk {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly files: Files;
  readonly notices: Notices;
  readonly canvas = document.createElement('canvas');
  readonly #host: DeskHost;
  readonly #checks: PoseChecks;
  readonly #reaching: Reaching;
  #keeping: Keeping | null = null;
  #drawing: Drawing | null = null;
  #input: Input | null = null;
  #sizing: ResizeObserver | null = null;
  readonly #surroundings: Surroundings;
  #settling: ReturnType<typeof setTimeout> | undefined;
  #box: EditorModel['box'] = null;
  #comparing = false;
  #overlays = NO_OVERLAYS;
  #settings = false;
  #numbers = false;
  #touched = false;
  #restoring = false;
  /** The selection that the list was last scrolled to. */
  #listed: readonly string[] = [];

  constructor(host: DeskHost) {
    this.#host = host;
    const desk = this;
    this.viewing = new Viewing({
      bounds: () => this.workbench.posing.bounds(),
      get coarse() {
        return matchMedia('(pointer: coarse)').matches;
      },
      get sheet() {
        return desk.#settings || desk.workbench.editing.document.selection.length > 0;
      },
      get bare() {
        if (!host.play) return null;
        return host.readonly ? 'picture' : 'handles';
      },
    });
    this.notices = new Notices({
      changed: () => host.changed(),
      emit: host.emit,
      get answerable() {
        return !host.readonly && !host.disabled;
      },
    });
    this.#surroundings = new Surroundings({ coloured: () => host.changed(), scaled: () => this.#looked() });
    this.#checks = new PoseChecks({
      folds: () => this.workbench.posing.folds(),
      beyond: () => this.workbench.posing.beyond(),
      changed: () => host.changed(),
      outside: (ids) => this.#tellOutside(ids),
    });
    this.workbench = new Workbench({
      get look() {
        return desk.viewing.now;
      },
      opened: (picture, look) => this.#opened(picture, look),
      solved: ({ data }, first) => {
        this.#drawing?.setSolution(data);
        this.#checks.solved(data.report);
        // The bounds of the posed picture are known only now.
        if (first) this.viewing.refit();
        // Restored work is stored already, or has been replaced by newer work of another tab.
        if (first && !this.#restoring) this.#keep();
        this.#host.changed();
      },
      edited: (kind) => this.#edited(kind),
      say: (text) => this.notices.say(text),
      carryOut: (effect) => this.#carryOut(effect),
      begin: (label, cancel) => this.notices.begin(label, cancel && (() => this.#edit(cancel))),
      report: (error) => this.notices.report(error),
    });
    this.#reaching = new Reaching({ workbench: this.workbench, changed: () => this.#drawing?.look() });
    this.files = new Files(this.workbench, host.aside, {
      changed: () => host.changed(),
      opened: () => host.opened(),
      notify: (notice) => this.notices.notify(notice),
      report: (error) => this.notices.report(error),
      begin: (label) => this.notices.begin(label),
      cuts: () => this.workbench.posing.beyond(),
      received: (ignored) => this.#welcome(ignored),
    });
  }

  /** Starts input and drawing; called once the stage is on the page. */
  attach(stage: HTMLElement): void {
    this.#sizing = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const { width, height } = entry.contentRect;
      // A hidden stage receives no more pointer moves.
      if (width === 0 || height === 0) this.#cancel();
      const typing = this.#host.root.activeElement instanceof HTMLInputElement;
      this.viewing.resize({ width, height }, typing && this.#input?.press === 'tap');
      this.#looked();
    });
    this.#sizing.observe(stage);
    this.viewing.resize({ width: stage.clientWidth, height: stage.clientHeight });
    this.#input = this.#listen(stage);
    try {
      this.#drawing = new Drawing(this.canvas, {
        view: () => ({
          ...deviceView(this.viewing.camera, this.viewing.stage, devicePixelRatio),
          compare: this.#comparing,
          overlays: this.#shown,
        }),
        motions: () => this.workbench.posing.motions(),
        blend: () => blendOf(this.workbench.editing.project),
        reach: () => (this.#shown.reach ? this.#reaching.reach() : null),
      });
    } catch (error) {
      this.notices.report(error);
    }
  }

  /** Adapts to the host's current `play` and `readonly`, and cancels a drag, drawing or input in progress. */
  rearrange(stage: HTMLElement): void {
    this.stop();
    const { editing } = this.workbench;
    if (this.#host.play) editing.apply(editing.machine.choose('select'));
    this.#input?.release();
    this.#input = this.#listen(stage);
    this.viewing.resize({ width: stage.clientWidth, height: stage.clientHeight });
    this.viewing.fit();
    this.#looked();
  }

  #listen(stage: HTMLElement): Input {
    const desk = this;
    return new Input(this.#host.root, stage, {
      editing: this.workbench.editing,
      commands: this.workbench.commands,
      viewing: this.viewing,
      posing: this.workbench.posing,
      get editable() {
        return desk.#editable;
      },
      get disabled() {
        return desk.#host.disabled;
      },
      get readonly() {
        return desk.#host.readonly;
      },
      playing: this.#host.play,
      get comparing() {
        return desk.#comparing;
      },
      looked: () => this.#looked(),
      run: (command) => this.run(command),
      compare: (on) => this.#compare(on),
      bail: () => !this.#host.disabled && this.#bail(),
      say: (text) => this.notices.say(text),
      held: (id, corner) => this.#focus(id, corner),
    });
  }

  /** Stores the open work under this key from now on; null stops that. */
  keepUnder(key: string | null): void {
    this.#keeping = key ? new Keeping(key) : null;
    this.#keep();
  }

  /** Opens the stored work. Returns whether there was any that could be opened. */
  async restore(turn: Turn): Promise<boolean> {
    const kept = await this.#keeping?.restore();
    if (!kept) return false;
    this.#restoring = true;
    try {
      await this.reopen(kept, turn);
    } catch (error) {
      // Without a solver nothing can be opened. Any other error means a document that this version does not accept.
      if (error instanceof Error && 'code' in error && error.code === 'engine') throw error;
      return false;
    } finally {
      this.#restoring = false;
    }
    this.#touched = kept.record.past.length > 0;
    // The solver refused the last stored step: store the work without it.
    if (this.workbench.editing.document !== kept.record.present) this.#keep();
    return true;
  }

  /** Opens earlier work, with the guard as it was then. */
  async reopen(kept: Kept, turn: Turn): Promise<void> {
    this.workbench.guarding.on = kept.guarded;
    await this.files.restore(kept, turn);
  }

  dispose(): void {
    clearTimeout(this.#settling);
    this.notices.dispose();
    this.#checks.dispose();
    this.#reaching.dispose();
    this.#sizing?.disconnect();
    this.#surroundings.release();
    this.#input?.release();
    this.#drawing?.dispose();
    this.files.dispose();
    this.workbench.dispose();
  }

  /** Cancels a drag, drawing or input in progress, and the comparison with the original. */
  stop(): void {
    this.#input?.stop();
    this.#compare(false);
  }

  /** Fits the whole picture into view. */
  fit(): void {
    this.viewing.fit();
    this.#looked();
  }

  run(command: CommandName): void {
    if (this.#host.disabled) return;
    run(command, {
      editing: this.workbench.editing,
      commands: this.workbench.commands,
      viewing: this.viewing,
      files: this.files,
      readonly: this.#host.readonly,
      editable: this.#editable,
      choose: (tool) => this.choose(tool),
      flip: () => this.#compare(!this.#comparing),
      bail: () => void this.#bail(),
      say: (text) => this.notices.say(text),
      addCorner: () => this.#input?.addCorner(),
      removeCorner: () => this.#input?.removeCorner(),
      settings: () => this.#openSettings(!this.#settings),
      looked: () => this.#looked(),
    });
  }

  choose(tool: ToolName): void {
    const { editing } = this.workbench;
    if (this.#host.play || (this.#host.readonly && tool !== 'hand')) return;
    editing.apply(editing.machine.choose(tool));
    // Arrow keys move the crosshair of a line tool only while nothing is selected.
    if (tool === 'bar' || tool === 'polygon') {
      editing.select([]);
      this.#settings = false;
    }
    // With a placing tool Enter must reach the stage, not the focused handle.
    const places = tool !== 'select' && tool !== 'hand';
    if (places && this.#host.root.activeElement?.closest('.handles')) this.#focus(undefined);
    this.#aim(null);
  }

  get model(): Omit<EditorModel, 'platform'> {
    const { editing, solving, picture } = this.workbench;
    const { machine } = editing;
    const { readonly, disabled, play: playing, dark } = this.#host;
    const overlays = this.#shown;
    return {
      document: editing.document,
      turns: this.workbench.posing.turns(),
      picture,
      opening: this.files.opening,
      tool: machine.tool,
      readonly,
      disabled,
      playing,
      dark,
      camera: this.viewing.camera,
      stage: this.viewing.stage,
      grips: this.#input?.grips ?? { handle: 0, line: 0, ring: 0, band: 0, slop: 0 },
      pressing: machine.busy,
      press: this.#input?.press ?? 'click',
      undo: machine.draft ? SET_CORNER : editing.undoLabel,
      redo: machine.takenBack ? SET_CORNER : machine.draft ? null : editing.redoLabel,
      solved: solving.label,
      progress: this.notices.progress,
      notice: this.#notice,
      hint: this.#hint,
      announcement: this.notices.announcement,
      comparing: this.#comparing,
      overlays,
      sites: overlays.sites || overlays.graph ? this.workbench.posing.graph() : null,
      folded: overlays.folds ? this.workbench.posing.folded() : null,
      folds:
        overlays.folds || this.workbench.guarding.on ? this.workbench.posing.folds() : this.#checks.folds,
      beyond: this.#checks.beyond,
      guarded: this.workbench.guarding.on,
      holding: this.workbench.guarding.holding,
      settings: this.#settings,
      numbers: this.#numbers,
      draft: machine.draft,
      waiting: machine.waiting,
      box: this.#box,
      crosshair: this.#input?.crosshair ?? null,
      cursor: this.workbench.picture ? (this.#input?.cursor ?? 'default') : 'default',
    };
  }

  readonly actions: EditorActions = {
    run: (command) => this.run(command),
    compare: (on) => this.#compare(on),
    overlay: (name, on) => {
      this.#overlays = { ...this.#overlays, [name]: on };
      this.#looked();
    },
    field: (field, value) => this.#edit((commands) => commands.field(field, value)),
    automatic: (on) => this.#edit((commands) => commands.automatic(on)),
    bend: (mode) => this.#edit((commands) => commands.bend(mode)),
    detail: (detail) => this.#edit((commands) => commands.detail(detail)),
    blend: (blend) => this.#edit((commands) => commands.blend(blend)),
    holdBoundary: (held) => this.#edit((commands) => commands.holdBoundary(held)),
    guard: (on) => {
      this.workbench.guarding.on = on;
      this.#keep();
      this.#host.changed();
    },
    finish: () => this.#input?.finish(),
    back: () => this.workbench.editing.apply(this.workbench.editing.machine.back()),
    settings: (on) => this.#openSettings(on),
    numbers: (on) => {
      this.#numbers = on;
      this.#host.changed();
    },
    select: (ids) => this.workbench.editing.select(ids),
    toggle: (id) => this.workbench.editing.toggle(id),
    hold: (id) => this.#focus(id),
    refuse: (text) => this.notices.notify({ kind: 'info', text }),
    reveal: (at) => {
      if (this.#host.play) this.viewing.contain([at]);
      else this.viewing.reveal(at);
      this.#looked();
    },
    dismiss: () => this.notices.dismiss(),
    theme: () => this.#host.switchTheme(),
  };

  /** Applies an edit of a control, or renders the control's old value again if editing is no longer allowed. */
  #edit(change: (commands: EditCommands) => void): void {
    if (this.#editable) change(this.workbench.commands);
    else this.#host.changed();
  }

  get #editable(): boolean {
    return !this.#host.readonly && !this.#host.disabled && this.workbench.picture !== null;
  }

  /** With `play` there are no overlays. */
  get #shown(): OverlayFlags {
    return this.#host.play ? NO_OVERLAYS : this.#overlays;
  }

  /** With `play` only errors are shown. */
  get #notice(): Notice | null {
    return this.#host.play ? this.notices.error : this.notices.notice;
  }

  /** Null after the first change. */
  get #hint(): Hint | null {
    const { hint, readonly } = this.#host;
    const { editing, solving } = this.workbench;
    const handle =
      editing.project.handles.find(({ id }) => id === hint?.handle) ?? editing.project.handles[0];
    if (!hint || !handle || this.#touched || readonly || !solving.current || editing.machine.draft)
      return null;
    const at = anchor(handle);
    if (!this.viewing.shows(at)) return null;
    return { text: hint.text, at, above: !this.viewing.shows(at, HINT_WIDTH) };
  }

  #opened(picture: Picture | null, look?: Look): void {
    this.notices.clear();
    if (picture && !this.#host.play) this.notices.say(`${picture.name} is open`);
    this.#drawing?.setPicture(picture?.bitmap ?? null);
    this.viewing.show(picture, look);
    this.#looked();
  }

  /** Names ignored files. Selects the point tool for a picture without handles, unless the page sets a tool. */
  #welcome(ignored: readonly string[]): void {
    const { editing, picture } = this.workbench;
    const [first, ...more] = ignored;
    if (first !== undefined) {
      const others = more.length === 0 ? first : `${first} and ${more.length} more`;
      this.notices.notify({
        kind: 'info',
        text: `One picture is open at a time: ${others} ${more.length === 0 ? 'was' : 'were'} not opened.`,
      });
    }
    const bare = picture !== null && editing.project.handles.length === 0;
    if (bare && editing.machine.tool === 'select' && !this.#host.tool) this.run('point');
  }

  #edited(kind: ChangeKind): void {
    const { selection } = this.workbench.editing.document;
    if (selection !== this.#listed) requestAnimationFrame(() => showSelected(this.#host.root));
    this.#listed = selection;
    if (kind === 'selection') {
      this.#settings = false;
      if (this.#shown.reach) this.#drawing?.look();
    } else {
      this.#drawing?.pose();
      this.#checks.posed();
      if (this.workbench.editing.undoLabel !== null) this.#touched = true;
    }
    if (kind === 'change') {
      clearTimeout(this.#settling);
      this.#settling = setTimeout(() => this.workbench.editing.settle(), SETTLE_MS);
      if (this.#host.play) this.#contain();
    }
    if (kind !== 'input') this.#keep();
    this.#host.edited(kind);
    this.#host.changed();
  }

  /** Keeps the selected handles within view, so that they can be moved back. */
  #contain(): void {
    const selected = selectedHandles(this.workbench.editing.document);
    this.viewing.contain(selected.flatMap((handle) => corners(handle)));
    this.#looked();
  }

  #keep(): void {
    const { kept } = this.workbench;
    if (kept) this.#keeping?.keep(kept);
  }

  #carryOut(effect: Effect): void {
    if (effect.type === 'box') this.#box = effect.box;
    else if (effect.type === 'pan') {
      this.viewing.look(panned(this.viewing.camera, effect.by));
    } else if (effect.type === 'miss') {
      this.notices.notify({
        kind: 'info',
        text: 'There is nothing to hold here: place the handle on the picture.',
      });
    }
  }

  #cancel(): void {
    const { editing } = this.workbench;
    editing.apply(editing.machine.cancel());
  }

  /** Cancels or dismisses the innermost thing in progress. Returns whether there was any. */
  #bail(): boolean {
    const { editing } = this.workbench;
    const notice = this.#notice;
    if (editing.machine.busy || editing.machine.draft) {
      editing.apply(editing.machine.bail());
      this.#looked();
    } else if (this.#input?.crosshair) this.#aim(null);
    else if (this.#settings) this.#openSettings(false);
    else if (notice && !notice.action) this.notices.dismiss();
    else if (editing.document.selection.length > 0) editing.select([]);
    else if (notice) this.notices.dismiss();
    else return false;
    return true;
  }

  #aim(crosshair: Vec | null): void {
    if (this.#input) this.#input.crosshair = crosshair;
    this.#looked();
  }

  /** Names handles that lie partly outside the picture; called when a solve finds others than the solve before. */
  #tellOutside(ids: readonly string[]): void {
    const names = ids.flatMap((id) => {
      const handle = this.workbench.editing.project.handles.find((other) => other.id === id);
      return handle ? [nameOf(handle)] : [];
    });
    const [first, ...more] = names;
    if (first === undefined) return;
    const text =
      more.length === 0
        ? `Only the part of ${first} on the picture bends it: the rest lies beside it.`
        : `Only the parts on the picture bend it of ${more.slice(0, -1).reduce((all, name) => `${all}, ${name}`, first)} and ${more.at(-1)}.`;
    this.notices.notify({ kind: 'info', text });
  }

  #openSettings(on: boolean): void {
    this.#settings = on;
    this.#host.changed();
  }

  #compare(on: boolean): void {
    if (on === this.#comparing || (on && !this.workbench.picture)) return;
    this.#comparing = on;
    this.#looked();
  }

  #looked(): void {
    this.#input?.follow();
    this.#drawing?.look();
    this.#host.changed();
  }

  /** Focuses the handle or corner just pressed, else the stage, so that keys go on working. */
  #focus(id: string | undefined, corner?: number): void {
    this.#host.changed();
    queueMicrotask(() => {
      const named = id === undefined ? '' : CSS.escape(id);
      const wanted =
        corner === undefined ? `[data-handle="${named}"]` : `[data-of="${named}"][data-corner="${corner}"]`;
      const handle = id === undefined ? null : this.#host.root.querySelector(wanted);
      const target = handle ?? this.#host.root.querySelector('.stage');
      if (target instanceof HTMLElement) target.focus({ preventScroll: true });
    });
  }
}
