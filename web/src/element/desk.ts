/**
 * A running editor, from the element's `connectedCallback` to its `disconnectedCallback`: its parts on their stage, and
 * what happens to several of them at once.
 *
 * The element hosts the desk and renders its model. Everything that holds a worker, a WebGL context or a listener
 * belongs to the desk, so that `dispose` releases all of it.
 */
import type { Pixels } from '../compute/solution';
import { handleById, selectedHandles } from '../document/document';
import { ringsOf } from '../document/domain';
import { corners, nameOf } from '../document/handle';
import { panned } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { Effect } from '../tools/state';
import { showSelected } from '../ui/handle_list';
import type { EditorActions, EditorModel } from '../ui/model';
import type { Autosave } from './autosave';
import type { CommandRunner } from './command_runner';
import type { ChangeKind } from './editing';
import type { Files } from './files';
import { modelOf } from './model';
import {
  LASSO_EMPTY,
  LASSO_LOOSE,
  leftOutText,
  NOT_INSIDE,
  NOTHING_TO_HOLD,
  notOpenedText,
  outsideText,
} from './notice_texts';
import type { Notices } from './notices';
import { type Parts, type PartsHost, partsOf } from './parts';
import type { Picture } from './picture';
import type { Solved } from './solving';
import { Stage } from './stage';
import { Surroundings } from './surroundings';
import type { Look } from './viewing';
import { draftWords } from './wording';
import type { Kept, Workbench } from './workbench';

export interface DeskHost extends PartsHost {
  readonly dark: boolean;
  /** What the picture shows, in the words of the page. */
  readonly alt: string | null;
  /** The tool set by the page. */
  readonly tool: string | null;
  edited(kind: ChangeKind): void;
}

/** Nudges merge into one undo step unless the pause between them is longer. */
const SETTLE_MS = 800;

export class Desk {
  readonly workbench: Workbench;
  readonly files: Files;
  readonly notices: Notices;
  readonly autosave: Autosave;
  readonly commands: CommandRunner;
  readonly actions: EditorActions;
  readonly canvas = document.createElement('canvas');
  readonly #host: DeskHost;
  readonly #parts: Parts;
  readonly #surroundings: Surroundings;
  #stage: Stage | null = null;
  #settling: ReturnType<typeof setTimeout> | undefined;
  /** The selection that the list was last scrolled to. */
  #listed: readonly string[] = [];

  constructor(host: DeskHost) {
    this.#host = host;
    const parts = partsOf(host, this.canvas, {
      opened: (picture, look) => this.#opened(picture, look),
      solved: (solved, first) => this.#solved(solved, first),
      edited: (kind) => this.#edited(kind),
      carryOut: (effect) => this.#carryOut(effect),
      looked: () => this.#looked(),
      reached: () => this.#stage?.drawing?.look(),
      received: (ignored) => this.#received(ignored),
      outside: (ids) => this.#tellOutside(ids),
    });
    this.#parts = parts;
    this.workbench = parts.workbench;
    this.files = parts.files;
    this.notices = parts.notices;
    this.autosave = parts.autosave;
    this.commands = parts.commands;
    this.actions = parts.actions;
    this.#surroundings = new Surroundings({ coloured: () => host.changed(), scaled: () => this.#looked() });
  }

  /** Starts input and drawing; called once the stage is on the page. */
  attach(stage: HTMLElement): void {
    this.#stage = new Stage(this.#host.root, stage, this.canvas, this.#parts);
  }

  /** Adapts to the host's current `play` and `readonly`, and cancels a drag, drawing or input in progress. */
  rearrange(): void {
    this.stop();
    const { editing } = this.workbench;
    if (this.#host.play) editing.apply(editing.machine.choose('select'));
    this.#stage?.rearrange();
    this.#parts.checks.posed();
  }

  /** Drops a number that is being typed. */
  untype(): void {
    this.#parts.focus.untypeField();
  }

  /** Cancels a drag, drawing or input in progress, and the view of the picture alone. */
  stop(): void {
    this.#stage?.stop();
    this.#parts.display.showBare(null);
  }

  /**
   * Opens the stored work. Returns whether there was any that could be opened.
   * @param failed takes why there was none. The way back leads to it, once something else is open.
   */
  async restore(failed: (error: unknown) => void): Promise<boolean> {
    const kept = await this.autosave.restore((stored) => this.reopen(stored), failed);
    if (kept) this.#parts.hint.touched = kept.record.past.length > 0;
    return kept !== null;
  }

  /** Opens earlier work, with the guard as it was then. */
  async reopen(kept: Kept): Promise<void> {
    this.workbench.guarding.on = kept.guarded;
    await this.files.restore(kept);
  }

  /** Fits the whole picture into view. */
  fit(): void {
    this.#parts.viewing.fit();
    this.#looked();
  }

  /** Null without a picture. */
  imageAt(client: Vec): Vec | null {
    return (this.workbench.picture && this.#stage?.imageAt(client)) ?? null;
  }

  /** Null without a picture. */
  clientAt(image: Vec): Vec | null {
    return (this.workbench.picture && this.#stage?.clientAt(image)) ?? null;
  }

  /** The warped picture, drawn as pixel art or not: without a word of that, as it is shown. */
  warped(scale: number, grow: boolean, pixelated = this.#parts.display.pixelated): Promise<Pixels> {
    return this.workbench.warped(scale, grow, pixelated);
  }

  dispose(): void {
    clearTimeout(this.#settling);
    this.notices.dispose();
    this.#parts.checks.dispose();
    this.#parts.reaching.dispose();
    this.#surroundings.release();
    this.#stage?.dispose();
    this.autosave.release();
    this.files.dispose();
    this.workbench.dispose();
  }

  get model(): EditorModel {
    const { alt, dark } = this.#host;
    const { platform } = navigator;
    return modelOf(this.#parts, { cursor: this.#stage?.cursor ?? 'default', alt, dark, platform });
  }

  #opened(picture: Picture | null, look?: Look): void {
    this.notices.clear();
    this.#parts.menu.close();
    if (picture && !this.#host.play) this.notices.say(`${picture.name} is open`);
    this.#stage?.drawing?.setPicture(picture?.bitmap ?? null);
    this.#parts.viewing.show(picture, look);
    this.#looked();
  }

  #solved({ data }: Solved, first: boolean): void {
    this.notices.solved();
    this.#stage?.drawing?.setSolution(data);
    this.#parts.checks.solved(data.report);
    // The bounds of the posed picture are known only now.
    if (first) this.#parts.viewing.refit();
    if (first) this.autosave.saveOpened();
    this.#host.changed();
  }

  #edited(kind: ChangeKind): void {
    const { display, checks, hint } = this.#parts;
    const { editing } = this.workbench;
    const { selection } = editing.document;
    this.#parts.menu.follow();
    const { focus } = this.#parts;
    if (focus.corner && !selection.includes(focus.corner.id)) focus.corner = null;
    if (selection !== this.#listed) requestAnimationFrame(() => showSelected(this.#host.root));
    this.#listed = selection;
    if (kind === 'selection') {
      display.openSettings(false);
      // What is selected in the list is hidden by the lasso.
      if (display.lassoing && selection.length > 0) this.commands.choose('select');
      if (display.overlays.reach) this.#stage?.drawing?.look();
    } else {
      this.#stage?.drawing?.pose();
      checks.posed();
      if (kind !== 'pose' && editing.undoLabel !== null) hint.touched = true;
    }
    if (kind === 'change') {
      this.notices.stepped();
      clearTimeout(this.#settling);
      this.#settling = setTimeout(() => editing.settle(), SETTLE_MS);
      if (this.#host.play) this.#contain();
    }
    if (kind !== 'input' && kind !== 'pose') this.autosave.save();
    this.#host.edited(kind);
    // What an animation out of sight says of its handles is asked for once it is seen.
    if (kind !== 'pose' || this.#stage?.drawing?.seen) this.#host.changed();
  }

  /** Keeps the selected handles within view, so that they can be moved back. */
  #contain(): void {
    const selected = selectedHandles(this.workbench.editing.document);
    this.#parts.viewing.contain(selected.flatMap((handle) => corners(handle)));
    this.#looked();
  }

  #carryOut(effect: Effect): void {
    const { display, viewing } = this.#parts;
    if (effect.type === 'drafted') {
      this.notices.say(draftWords(effect.draft));
      this.autosave.save();
    } else if (effect.type === 'box') display.box = effect.box;
    else if (effect.type === 'pan') viewing.look(panned(viewing.camera, effect.by));
    else if (effect.type === 'miss') this.notices.notify({ kind: 'info', text: this.#missed });
    else if (effect.type === 'lassoed') this.#lasso(effect.ring, effect.hole);
  }

  /** Why nothing was placed. */
  get #missed(): string {
    return ringsOf(this.workbench.editing.project).length > 0 ? NOT_INSIDE : NOTHING_TO_HOLD;
  }

  /** Lets what is inside of a ring bend, and goes on to its handles. */
  #lasso(ring: readonly Vec[], hole: boolean): void {
    const { editing, commands } = this.workbench;
    const left = commands.lasso(ring, hole);
    if (left === null) {
      this.notices.notify({ kind: 'info', text: LASSO_EMPTY, ofStep: true });
      return;
    }
    if (left > 0) this.notices.notify({ kind: 'info', text: leftOutText(left), ofStep: true });
    else if (!editing.project.fix_boundary) {
      const action = { label: 'Hold its boundary', run: () => commands.holdBoundary(true) };
      this.notices.notify({ kind: 'info', text: LASSO_LOOSE, action, passes: true, ofStep: true });
    }
    this.commands.choose(editing.project.handles.length > 0 ? 'select' : 'point');
  }

  /** Names ignored files. Selects the point tool for a picture without handles, and the other way round, unless the page sets a tool. */
  #received(ignored: readonly string[]): void {
    const { editing, picture } = this.workbench;
    if (ignored.length > 0) this.notices.notify({ kind: 'info', text: notOpenedText(ignored) });
    if (!picture || this.#host.tool) return;
    const bare = editing.project.handles.length === 0;
    const { tool } = editing.machine;
    if (bare && tool === 'select') this.commands.run('point');
    if (!bare && tool === 'point') this.commands.run('select');
  }

  /** Names handles that lie partly outside the picture; called when a solve finds others than the solve before. */
  #tellOutside(ids: readonly string[]): void {
    const { document } = this.workbench.editing;
    const handles = ids.flatMap((id) => handleById(document, id) ?? []);
    if (handles.length === 0) return;
    const text = outsideText(handles.map(nameOf), ringsOf(document.project).length > 0);
    this.notices.notify({ kind: 'info', text, ofStep: true });
  }

  #looked(): void {
    this.#stage?.look();
    this.#host.changed();
  }
}
