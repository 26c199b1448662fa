/**
 * The open document: its history, the current tool, and every change that a command makes.
 *
 * Independent of the DOM. After each change the host gets its kind and a text for screen readers.
 */
import { bent, blended, type Detail, detailed, modeOf } from '../document/bending';
import { type Document, handleById, isSameWork, selectedHandles } from '../document/document';
import {
  addCorner,
  changeHandles,
  holdBoundary,
  moveHandles,
  putCorner,
  raiseHandles,
  removeCorner,
  removeHandles,
  resetHandles,
  selectHandles,
  turnHandles,
} from '../document/edits';
import {
  anchor,
  atDepth,
  CORNERS_NEEDED,
  DEPTHS,
  depthOf,
  freed,
  isLine,
  moved,
  nameOf,
  rotationOf,
  scaledTo,
  scaleOf,
  type Turns,
  turnedTo,
} from '../document/handle';
import { History, type HistoryRecord } from '../document/history';
import { culprit, handleBack, withHandleBack, withoutSolution } from '../document/mending';
import type { Handle, LineHandle, PoseMode, Project } from '../document/project';
import { solvesWith } from '../document/solved';
import type { Blend } from '../geometry/blend';
import type { LinePlace } from '../geometry/polyline';
import { add, type Vec } from '../geometry/vec';
import { type Drawings, ToolMachine } from '../tools/machine';
import type { Draft, Effect } from '../tools/state';
import type { Field } from '../ui/model';
import type { Guarding } from './guarding';

/** `open`: another document; `input`: during a drag; `change`: committed; `selection`: only the selection changed. */
export type ChangeKind = 'open' | 'input' | 'change' | 'selection';

export interface EditingHost {
  edited(kind: ChangeKind): void;
  say(text: string): void;
  /** The turns of automatic handles in the current pose. */
  readonly turns: Turns;
  readonly guarding: Guarding;
  /** Carries out an effect that does not concern the document. */
  carryOut(effect: Effect): void;
}

export class Editing {
  readonly machine = new ToolMachine();
  readonly #host: EditingHost;
  /** The last finished drawing and its handle, to resume the drawing if the solver refuses the handle. */
  #drawn: { readonly draft: Draft; readonly handle: Handle } | null = null;
  /** Handles that the solver has refused during the current press. */
  #refused: readonly Handle[] = [];
  #history: History<Document>;

  constructor(host: EditingHost, document: Document) {
    this.#host = host;
    this.#history = new History(document, isSameWork);
  }

  get document(): Document {
    return this.#history.present;
  }

  get project(): Project {
    return this.#history.present.project;
  }

  get undoLabel(): string | null {
    return this.#history.undoLabel;
  }

  get redoLabel(): string | null {
    return this.#history.redoLabel;
  }

  record(): HistoryRecord<Document> {
    return this.#history.record();
  }

  /** Opens another document with its history and its unfinished drawings. */
  open(record: HistoryRecord<Document>, drawings?: Drawings): void {
    this.#letGo(this.machine.restore(drawings));
    this.#drawn = null;
    this.#host.guarding.end();
    this.#history = History.from(record, isSameWork);
    this.#host.edited('open');
  }

  /** Carries out the effects of a tool. */
  apply(effects: readonly Effect[]): void {
    for (const effect of effects) {
      if (effect.type === 'begin') this.#begin(effect.label);
      else if (effect.type === 'edit') this.#input(effect.document);
      else if (effect.type === 'commit') this.#commit();
      else if (effect.type === 'bail') this.#bail();
      else if (effect.type === 'select') this.select(effect.ids);
      else if (effect.type === 'drawn') this.#drawn = effect;
      else if (effect.type === 'drafted') this.#sayDraft(effect.draft);
      else this.#host.carryOut(effect);
    }
  }

  select(ids: readonly string[]): void {
    const before = this.document.selection;
    const next = selectHandles(this.document, ids);
    if (next.selection.join('\n') === before.join('\n')) return;
    this.#history.settle();
    this.#history.update(next);
    if (!this.machine.busy) this.#host.guarding.end();
    this.#host.edited('selection');
  }

  toggle(id: string): void {
    const { selection } = this.document;
    this.select(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id]);
  }

  /** Commits a change as one undo step, and announces it. */
  step(label: string, document: Document): void {
    this.#host.guarding.end();
    this.#step(label, document, null);
    this.#host.say(label);
  }

  undo(): void {
    this.#travel('Undone', this.#history.undo());
  }

  redo(): void {
    this.#travel('Redone', this.#history.redo());
  }

  remove(): void {
    const { selection } = this.document;
    if (selection.length === 0) return;
    this.step(`Delete ${this.#selectionName()}`, removeHandles(this.document, selection));
  }

  /** Returns the selected handles, or all, to their rest pose. */
  reset(all: boolean): void {
    const ids = all ? this.project.handles.map((handle) => handle.id) : this.document.selection;
    if (!all && ids.length === 0) return;
    const label = all ? 'Reset all handles' : `Reset ${this.#selectionName()}`;
    this.step(label, resetHandles(this.document, ids));
  }

  nudge(by: Vec): void {
    const { selection } = this.document;
    const label = `Move ${this.#selectionName()}`;
    this.#guarded(label, moveHandles(this.document, selection, by), `nudge ${selection.join(' ')}`);
  }

  /** Nudges one corner of a bar or polygon. */
  nudgeCorner(id: string, index: number, by: Vec): void {
    const handle = handleById(this.document, id);
    const at = handle && isLine(handle) ? handle.posed[index] : undefined;
    if (!handle || !at) return;
    const next = putCorner(this.document, id, index, add(at, by));
    this.#guarded(`Move a corner of ${nameOf(handle)}`, next, `nudge ${id} ${index}`);
  }

  /** Adds a corner to a bar or polygon. Returns its index. */
  addCorner(handle: LineHandle, at: LinePlace): number {
    this.step(`Add a corner to ${nameOf(handle)}`, addCorner(this.document, handle.id, at));
    return at.edge + 1;
  }

  /** Removes a corner if enough remain. Returns the index of the corner before it, or null if none was removed. */
  removeCorner(handle: LineHandle, index: number): number | null {
    const needed = CORNERS_NEEDED[handle.kind];
    if (handle.posed.length <= needed) {
      this.#host.say(`A ${handle.kind} needs ${needed} corners`);
      return null;
    }
    this.step(`Delete a corner of ${nameOf(handle)}`, removeCorner(this.document, handle.id, index));
    return Math.max(0, index - 1);
  }

  /** Brings the selected handles forward by this many depth steps; negative sends them back. */
  raise(by: number): void {
    const { selection } = this.document;
    if (selection.length === 0) return;
    const label = `${by > 0 ? 'Bring forward' : 'Send back'} ${this.#selectionName()}`;
    this.#step(label, raiseHandles(this.document, selection, by), `raise ${selection.join(' ')}`);
    this.#sayDepth();
  }

  blend(blend: Blend): void {
    const project = blended(this.document.project, blend);
    this.step(blend === 'rigid' ? 'Keep turns rigid' : 'Blend turns linearly', { ...this.document, project });
  }

  holdBoundary(held: boolean): void {
    this.step(held ? 'Hold the boundary' : 'Free the boundary', holdBoundary(this.document, held));
  }

  turn(by: number): void {
    const { selection } = this.document;
    const { turns } = this.#host;
    const turned = turnHandles(this.document, selection, (handle) => rotationOf(handle, turns) + by);
    this.#guarded(`Turn ${this.#selectionName()}`, turned, `turn ${selection.join(' ')}`);
  }

  /** Makes the rotation of the selected points automatic, or pins it as it is now. */
  automatic(on: boolean): void {
    const { turns } = this.#host;
    // Bars and polygons take their rotation from their corners.
    const points = selectedHandles(this.document).filter((handle) => !isLine(handle));
    const ids = points.map((handle) => handle.id);
    const document = on
      ? changeHandles(this.document, ids, freed)
      : turnHandles(this.document, ids, (handle) => rotationOf(handle, turns));
    this.step(`${on ? 'Free' : 'Pin'} the turn of ${this.#selectionName()}`, document);
  }

  /** Changes the pose mode, with the settings that belong to it. */
  bend(mode: PoseMode): void {
    if (mode === modeOf(this.project)) return;
    const label = mode === 'rigid' ? 'Bend rigidly' : 'Bend smoothly';
    this.step(label, { ...this.document, project: bent(this.project, mode) });
  }

  detail(detail: Detail): void {
    this.step(`Set detail to ${detail}`, { ...this.document, project: detailed(this.project, detail) });
  }

  /** Sets one field of every selected handle, computed from its current value. */
  field(field: Field, value: (now: number) => number): void {
    const { turns } = this.#host;
    const further = (now: number) => value(now) - now;
    const set: Readonly<Record<Field, (handle: Handle) => Handle>> = {
      x: (handle) => moved(handle, [further(anchor(handle)[0]), 0]),
      y: (handle) => moved(handle, [0, further(anchor(handle)[1])]),
      rotation: (handle) => turnedTo(handle, value(rotationOf(handle, turns))),
      scale: (handle) => scaledTo(handle, value(scaleOf(handle))),
      depth: (handle) => atDepth(handle, value(depthOf(handle))),
    };
    const { selection } = this.document;
    const document = changeHandles(this.document, selection, set[field]);
    const label = `Set ${field} of ${this.#selectionName()}`;
    this.#guarded(label, document, `${field} ${selection.join(' ')}`);
    if (field === 'depth') this.#sayDepth();
  }

  /** The next nudge starts a new undo step. */
  settle(): void {
    this.#history.settle();
  }

  /** Cancels the current press and all drawings. */
  giveUp(): void {
    this.apply(this.machine.clear());
    this.#drawn = null;
  }

  /**
   * Takes back what makes the solution of this key impossible or unwanted: one of the `named` handles, or else every
   * state that needs that solution. Returns whether the document has changed.
   *
   * @param accepted the last solved project.
   */
  withdraw(key: string, named: readonly string[] = [], accepted: Project | null = null): boolean {
    const { timeline } = this.#history;
    const handle = culprit(timeline, named, accepted);
    const { project } = this;
    const left = this.#history.mend(
      handle ? withHandleBack(timeline, handle) : withoutSolution(timeline, key),
    );
    const drawn = this.#drawn;
    const undrawn = drawn && solvesWith(project, drawn.handle) && !solvesWith(this.project, drawn.handle);
    if (handle) this.#refused = [...this.#refused, handle];
    if (!handle || undrawn) this.#putDown();
    // A refused corner must not cost the dozen clicks of its drawing.
    if (undrawn) {
      this.#drawn = null;
      this.machine.resume(drawn.draft);
    }
    if (left) this.#host.edited('change');
    return left;
  }

  /** Ends the current press and keeps its changes so far. */
  #putDown(): void {
    this.#letGo(this.machine.cancel());
    this.#host.guarding.end();
    this.#history.commit();
  }

  /** Drops the effects that end a press, except the one that clears its selection box. */
  #letGo(effects: readonly Effect[]): void {
    this.apply(effects.filter(({ type }) => type === 'box'));
  }

  /** Commits a change as far as the guard against folds allows, and announces the result. */
  #guarded(label: string, wanted: Document, key: string): void {
    const { guarding } = this.#host;
    const document = guarding.limited(this.document, wanted);
    if (document === this.document && guarding.holding) {
      this.#host.say('Stopped: more would fold the picture');
      return;
    }
    this.#step(label, document, key);
    this.#sayPlace();
  }

  /** Commits a step unless it changes nothing. Consecutive steps with the same key form one undo step. */
  #step(label: string, document: Document, key: string | null): void {
    if (!this.#history.step(label, document, key)) return;
    // The current press would overwrite this step. Its changes so far are already a step of their own.
    if (this.machine.busy) this.apply(this.machine.cancel());
    this.#host.edited('change');
  }

  #sayDepth(): void {
    const [handle] = selectedHandles(this.document);
    if (!handle) return;
    const depth = depthOf(handle);
    const end = depth === DEPTHS.most ? ', in front' : depth === DEPTHS.least ? ', at the back' : '';
    this.#host.say(`${nameOf(handle)}: depth ${depth}${end}`);
  }

  #sayDraft(draft: Draft | null): void {
    const [at] = draft?.corners.slice(-1) ?? [];
    const [x, y] = at?.map(Math.round) ?? [];
    this.#host.say(
      draft ? `${draft.kind}, corner ${draft.corners.length}: x ${x}, y ${y}` : 'Drawing given up',
    );
  }

  #sayPlace(): void {
    this.#host.say(this.#place);
  }

  /** Describes the first selected handle for screen readers. */
  get #place(): string {
    const [handle] = selectedHandles(this.document);
    if (!handle) return '';
    const [x, y] = anchor(handle).map(Math.round);
    const turn = Math.round(rotationOf(handle, this.#host.turns));
    const scale = scaleOf(handle) === 1 ? '' : `, scale ${scaleOf(handle)}`;
    return `${nameOf(handle)}: x ${x}, y ${y}, rotation ${turn} degrees${scale}`;
  }

  #selectionName(): string {
    const [id, ...more] = this.document.selection;
    if (id === undefined) return 'nothing';
    const handle = handleById(this.document, id);
    return more.length > 0 ? `${more.length + 1} handles` : handle ? nameOf(handle) : id;
  }

  #begin(label: string): void {
    this.#history.begin(label);
    this.#refused = [];
    this.#host.guarding.begin(this.document);
  }

  #input(document: Document): void {
    // A drag computes every move from the document at its start, which still has the refused handles.
    const wanted = this.#refused.reduce(
      (mended, handle) => handleBack(mended, handle, this.document),
      document,
    );
    this.#history.update(this.#host.guarding.limited(this.document, wanted));
    this.#host.edited('input');
  }

  #commit(): void {
    this.#host.guarding.end();
    if (!this.#history.commit()) {
      // The drag changed nothing: its label must disappear from undo.
      this.#host.edited('input');
      return;
    }
    this.#host.edited('change');
    const label = this.#history.undoLabel ?? '';
    this.#host.say(`${label}. ${this.#place}`);
  }

  #bail(): void {
    this.#host.guarding.end();
    this.#history.bail();
    this.#host.edited('input');
  }

  #travel(verb: string, label: string | null): void {
    this.apply(this.machine.cancel());
    this.machine.forget();
    this.#host.guarding.end();
    if (label === null) return;
    this.#host.edited('change');
    this.#host.say(`${verb}: ${label}`);
  }
}
