/**
 * An editor at work, from the element's arrival on a page until it leaves: the workbench and all that shows it.
 *
 * The element gives it a place and draws the model; everything that holds a worker, a WebGL context or a listener is
 * here, so that `dispose` gives all of it back.
 */
import { blendOf } from '../document/bending';
import { anchor, nameOf } from '../document/handle';
import { deviceView } from '../geometry/camera';
import type { ToolName } from '../tools/machine';
import type { Effect } from '../tools/state';
import type { CommandName } from '../ui/commands';
import type { EditorActions, EditorModel, Hint, OverlayFlags } from '../ui/model';
import { Drawing } from './drawing';
import type { ChangeKind } from './editing';
import { Files } from './files';
import { Guarding } from './guarding';
import { Input } from './input';
import { Keeping } from './keeping';
import { Noticing } from './noticing';
import type { Picture } from './picture';
import { Posing } from './posing';
import { run } from './running';
import { Talking } from './talking';
import { Viewing } from './viewing';
import { Workbench } from './workbench';

export interface DeskHost {
  readonly root: ShadowRoot;
  readonly readonly: boolean;
  readonly disabled: boolean;
  readonly dark: boolean;
  /** What a first visitor is told of a handle. */
  readonly hint: { readonly text: string; readonly handle: string | null } | null;
  /** What the templates show has changed. */
  changed(): void;
  edited(kind: ChangeKind): void;
  emit(type: string, detail?: unknown): void;
  switchTheme(): void;
}

/** Nudges with a longer pause between them are undone one by one. */
const SETTLE_MS = 800;

export class Desk {
  readonly workbench: Workbench;
  readonly viewing = new Viewing();
  readonly posing: Posing;
  readonly files: Files;
  readonly talking: Talking;
  readonly guarding: Guarding;
  readonly canvas = document.createElement('canvas');
  readonly #host: DeskHost;
  readonly #keeping: Keeping | null;
  readonly #noticing: Noticing;
  #drawing: Drawing | null = null;
  #input: Input | null = null;
  #sizing: ResizeObserver | null = null;
  #settling: ReturnType<typeof setTimeout> | undefined;
  #box: EditorModel['box'] = null;
  #comparing = false;
  #overlays: OverlayFlags = { mesh: false, sites: false, graph: false, folds: false };
  #settings = false;
  #touched = false;

  constructor(host: DeskHost, autosave: string | null) {
    this.#host = host;
    this.#keeping = autosave ? new Keeping(autosave) : null;
    const desk = this;
    this.talking = new Talking({
      changed: () => host.changed(),
      emit: (type, detail) => host.emit(type, detail),
      get cancellable() {
        const { current, pending } = desk.workbench.solving;
        return current !== null && pending !== null;
      },
    });
    this.guarding = new Guarding({
      foldsOf: (project, limit) => this.posing.foldsOf(project, limit),
      get turns() {
        return desk.posing.turns();
      },
    });
    this.#noticing = new Noticing({
      folds: () => this.posing.folds(),
      changed: () => host.changed(),
      outside: (ids) => this.#tellOutside(ids),
    });
    this.workbench = new Workbench({
      opened: (picture) => this.#opened(picture),
      solved: ({ data }) => {
        this.posing.forget();
        this.#drawing?.setSolution(data);
        this.#noticing.solved(data.report);
        this.#host.changed();
      },
      edited: (kind) => this.#edited(kind),
      say: (text) => this.talking.say(text),
      carryOut: (effect) => this.#carryOut(effect),
      guarding: this.guarding,
      get turns() {
        return desk.posing.turns();
      },
      progressed: (label) => this.talking.progressed(label),
      report: (error) => this.talking.report(error),
    });
    this.posing = new Posing(this.workbench);
    this.files = new Files(this.workbench, {
      notify: (notice) => this.talking.notify(notice),
      report: (error) => this.talking.report(error),
      progressed: (label) => this.talking.progressed(label),
    });
  }

  /** Once the stage is on the page. */
  attach(stage: HTMLElement): void {
    this.#sizing = new ResizeObserver(([entry]) => {
      if (!entry) return;
      this.viewing.resize(entry.contentRect);
      this.#looked();
    });
    this.#sizing.observe(stage);
    this.viewing.resize({ width: stage.clientWidth, height: stage.clientHeight });
    const desk = this;
    this.#input = new Input(this.#host.root, stage, {
      editing: this.workbench.editing,
      viewing: this.viewing,
      posing: this.posing,
      get editable() {
        return desk.#editable;
      },
      looked: () => this.#looked(),
      run: (command) => this.run(command),
      compare: (on) => this.#compare(on),
      held: (id, corner) => this.#focus(id, corner),
    });
    try {
      this.#drawing = new Drawing(this.canvas, {
        view: () => ({
          ...deviceView(this.viewing.camera, this.viewing.stage, devicePixelRatio),
          compare: this.#comparing,
          overlays: this.#overlays,
        }),
        motions: () => this.posing.motions(),
        blend: () => blendOf(this.workbench.editing.project),
      });
    } catch (error) {
      this.talking.report(error);
    }
  }

  /** What was kept under the `autosave` key. Returns whether there was anything that could be opened. */
  async restore(): Promise<boolean> {
    const kept = await this.#keeping?.restore();
    if (!kept) return false;
    try {
      await this.files.restore(kept);
    } catch (error) {
      // Without a solver nothing can be opened; anything else is a document that this version does not take.
      if (error instanceof Error && 'code' in error && error.code === 'engine') throw error;
      return false;
    }
    this.#touched = kept.record.past.length > 0;
    // Where its last step was refused, what is kept ends before that.
    if (this.workbench.editing.document !== kept.record.present) this.#keep();
    return true;
  }

  dispose(): void {
    clearTimeout(this.#settling);
    this.talking.dispose();
    this.#noticing.dispose();
    this.#sizing?.disconnect();
    this.#input?.release();
    this.#drawing?.dispose();
    this.workbench.dispose();
  }

  run(command: CommandName): void {
    if (this.#host.disabled) return;
    run(command, {
      editing: this.workbench.editing,
      viewing: this.viewing,
      files: this.files,
      readonly: this.#host.readonly,
      editable: this.#editable,
      choose: (tool) => this.choose(tool),
      flip: () => this.#compare(!this.#comparing),
      bail: () => this.#bail(),
      addCorner: () => this.#input?.addCorner(),
      removeCorner: () => this.#input?.removeCorner(),
      settings: () => this.#openSettings(!this.#settings),
      looked: () => this.#looked(),
    });
  }

  choose(tool: ToolName): void {
    const { editing } = this.workbench;
    if (this.#host.readonly && tool !== 'hand') return;
    editing.apply(editing.machine.choose(tool));
    // A line is drawn on the picture: what was selected lets go of the arrow keys.
    if (tool === 'bar' || tool === 'polygon') {
      editing.select([]);
      this.#settings = false;
      const active = this.#host.root.activeElement;
      if (active?.closest('.handles')) this.#focus(undefined);
    }
    this.#looked();
  }

  get model(): Omit<EditorModel, 'platform'> {
    const { editing, solving, picture } = this.workbench;
    const { readonly, disabled, dark } = this.#host;
    return {
      document: editing.document,
      turns: this.posing.turns(),
      picture,
      tool: editing.machine.tool,
      readonly,
      disabled,
      dark,
      camera: this.viewing.camera,
      stage: this.viewing.stage,
      grips: this.#input?.grips ?? { handle: 0, line: 0, ring: 0, band: 0, slop: 0 },
      undo: editing.undoLabel,
      redo: editing.redoLabel,
      solved: solving.label,
      progress: this.talking.progress,
      notice: this.talking.notice,
      hint: this.#hint,
      announcement: this.talking.announcement,
      comparing: this.#comparing,
      overlays: this.#overlays,
      sites: this.#overlays.sites || this.#overlays.graph ? this.posing.graph() : null,
      folded: this.#overlays.folds ? this.posing.folded() : null,
      folds: this.#overlays.folds || this.guarding.on ? this.posing.folds() : this.#noticing.folds,
      guarded: this.guarding.on,
      holding: this.guarding.holding,
      settings: this.#settings,
      draft: editing.machine.draft,
      box: this.#box,
      crosshair: this.#input?.crosshair ?? null,
      cursor: this.#input?.cursor ?? 'default',
    };
  }

  readonly actions: EditorActions = {
    run: (command) => this.run(command),
    compare: (on) => this.#compare(on),
    overlay: (name, on) => {
      this.#overlays = { ...this.#overlays, [name]: on };
      this.#looked();
    },
    field: (field, value) => this.workbench.editing.field(field, value),
    automatic: (on) => this.workbench.editing.automatic(on),
    bend: (mode) => this.workbench.editing.bend(mode),
    detail: (detail) => this.workbench.editing.detail(detail),
    blend: (blend) => this.workbench.editing.blend(blend),
    holdBoundary: (held) => this.workbench.editing.holdBoundary(held),
    guard: (on) => {
      this.guarding.on = on;
      this.#host.changed();
    },
    finish: () => this.#input?.finish(),
    back: () => this.workbench.editing.apply(this.workbench.editing.machine.back()),
    settings: (on) => this.#openSettings(on),
    select: (ids) => this.workbench.editing.select(ids),
    toggle: (id) => this.workbench.editing.toggle(id),
    hold: (id) => this.#focus(id),
    cancelSolve: () => this.workbench.cancelSolve(),
    dismiss: () => this.talking.notify(null),
    theme: () => this.#host.switchTheme(),
  };

  get #editable(): boolean {
    return !this.#host.readonly && !this.#host.disabled && this.workbench.picture !== null;
  }

  /** Until something has been moved. */
  get #hint(): Hint | null {
    const { hint, readonly } = this.#host;
    const { editing, solving } = this.workbench;
    const handle =
      editing.project.handles.find(({ id }) => id === hint?.handle) ?? editing.project.handles[0];
    if (!hint || !handle || this.#touched || readonly || !solving.current || editing.machine.draft)
      return null;
    return { text: hint.text, at: anchor(handle) };
  }

  #opened(picture: Picture | null): void {
    this.posing.forget();
    this.talking.notify(null);
    if (picture) this.#drawing?.setPicture(picture.bitmap);
    this.viewing.show(picture);
    this.#looked();
  }

  #edited(kind: ChangeKind): void {
    if (kind !== 'selection') {
      this.#drawing?.pose();
      this.#noticing.posed();
      if (this.workbench.editing.undoLabel !== null) this.#touched = true;
    }
    if (kind === 'change') {
      clearTimeout(this.#settling);
      this.#settling = setTimeout(() => this.workbench.editing.settle(), SETTLE_MS);
    }
    if (kind !== 'input') this.#keep();
    this.#host.edited(kind);
    this.#host.changed();
  }

  #keep(): void {
    const { kept } = this.workbench;
    if (kept) this.#keeping?.keep(kept);
  }

  #carryOut(effect: Effect): void {
    if (effect.type === 'box') this.#box = effect.box;
    else if (effect.type === 'pan') {
      const { camera } = this.viewing;
      this.viewing.look({ ...camera, x: camera.x + effect.by[0], y: camera.y + effect.by[1] });
    } else if (effect.type === 'miss') {
      this.talking.notify({
        kind: 'info',
        text: 'There is nothing to hold here: place the handle on the picture.',
      });
    }
  }

  #bail(): void {
    const { editing } = this.workbench;
    if (editing.machine.busy || editing.machine.draft) {
      editing.apply(editing.machine.bail());
      this.#looked();
    } else if (this.#settings) this.#openSettings(false);
    else if (this.talking.notice) this.talking.notify(null);
    else editing.select([]);
  }

  /** Once for each solve that finds other handles beyond the picture than the one before. */
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
    this.talking.notify({ kind: 'info', text });
  }

  #openSettings(on: boolean): void {
    this.#settings = on;
    this.#host.changed();
  }

  #compare(on: boolean): void {
    if (on === this.#comparing) return;
    this.#comparing = on;
    this.#looked();
  }

  #looked(): void {
    this.#drawing?.look();
    this.#host.changed();
  }

  /** A handle just held takes the focus, else the picture does, so that keys go on working. */
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
