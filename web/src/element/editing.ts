/**
 * The document in hand: its history, the tool that works on it, and every change that a command makes.
 *
 * Knows no DOM. After each change the host hears what kind it was, and what to say aloud.
 */
import { bent, blended, type Detail, detailed, modeOf } from '../document/bending';
import { type Document, handleById, selectedHandles } from '../document/document';
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
import type { Handle, LineHandle, PoseMode, Project } from '../document/project';
import { solveKey } from '../document/solved';
import type { Blend } from '../geometry/blend';
import type { LinePlace } from '../geometry/polyline';
import { add, type Vec } from '../geometry/vec';
import { ToolMachine } from '../tools/machine';
import type { Draft, Effect } from '../tools/state';
import type { Field } from '../ui/model';
import type { Guarding } from './guarding';

/** `open`: another document; `input`: within a drag; `change`: committed; `selection`: only what is selected. */
export type ChangeKind = 'open' | 'input' | 'change' | 'selection';

export interface EditingHost {
  edited(kind: ChangeKind): void;
  say(text: string): void;
  /** How far automatic handles are turned under the document as it is. */
  readonly turns: Turns;
  readonly guarding: Guarding;
  /** Effects that are not about the document. */
  carryOut(effect: Effect): void;
}

export class Editing {
  readonly machine = new ToolMachine();
  readonly #host: EditingHost;
  /** What was drawn last, and the solution that it needs. */
  #drawn: { readonly draft: Draft; readonly key: string } | null = null;
  #history: History<Document>;

  constructor(host: EditingHost, document: Document) {
    this.#host = host;
    this.#history = new History(document);
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

  /** Starts over with another document and its history. */
  open(record: HistoryRecord<Document>): void {
    this.#letGo(this.machine.clear());
    this.#drawn = null;
    this.#host.guarding.end();
    this.#history = History.from(record);
    this.#host.edited('open');
  }

  /** Carries out what a tool asks for. */
  apply(effects: readonly Effect[]): void {
    for (const effect of effects) {
      if (effect.type === 'begin') this.#begin(effect.label);
      else if (effect.type === 'edit') this.#input(effect.document);
      else if (effect.type === 'commit') this.#commit();
      else if (effect.type === 'bail') this.#bail();
      else if (effect.type === 'select') this.select(effect.ids);
      else if (effect.type === 'drawn') this.#drawn = { draft: effect.draft, key: solveKey(this.project) };
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

  /** A whole change in one go. */
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

  /** Back to rest: what is selected, or everything. */
  reset(all: boolean): void {
    const ids = all ? this.project.handles.map((handle) => handle.id) : this.document.selection;
    const label = all ? 'Reset all handles' : `Reset ${this.#selectionName()}`;
    this.step(label, resetHandles(this.document, ids));
  }

  nudge(by: Vec): void {
    const { selection } = this.document;
    const label = `Move ${this.#selectionName()}`;
    this.#guarded(label, moveHandles(this.document, selection, by), `nudge ${selection.join(' ')}`);
  }

  /** The same for one corner of a handle. */
  nudgeCorner(id: string, index: number, by: Vec): void {
    const handle = handleById(this.document, id);
    const at = handle && isLine(handle) ? handle.posed[index] : undefined;
    if (!handle || !at) return;
    const next = putCorner(this.document, id, index, add(at, by));
    this.#guarded(`Move a corner of ${nameOf(handle)}`, next, `nudge ${id} ${index}`);
  }

  /** One corner more on a bar or polygon. Returns which it is. */
  addCorner(handle: LineHandle, at: LinePlace): number {
    this.step(`Add a corner to ${nameOf(handle)}`, addCorner(this.document, handle.id, at));
    return at.edge + 1;
  }

  /** One corner less, if enough are left. Returns the one before it, or null where it stays. */
  removeCorner(handle: LineHandle, index: number): number | null {
    const needed = CORNERS_NEEDED[handle.kind];
    if (handle.posed.length <= needed) {
      this.#host.say(`A ${handle.kind} needs ${needed} corners`);
      return null;
    }
    this.step(`Delete a corner of ${nameOf(handle)}`, removeCorner(this.document, handle.id, index));
    return Math.max(0, index - 1);
  }

  /** Nearer to the eye by so much, or farther. */
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

  /** Lets everything selected turn by itself, or keeps it as it is turned now. */
  automatic(on: boolean): void {
    const { turns } = this.#host;
    // What has corners is turned by them, whatever its neighbours do.
    const points = selectedHandles(this.document).filter((handle) => !isLine(handle));
    const ids = points.map((handle) => handle.id);
    const document = on
      ? changeHandles(this.document, ids, freed)
      : turnHandles(this.document, ids, (handle) => rotationOf(handle, turns));
    this.step(`${on ? 'Free' : 'Pin'} the turn of ${this.#selectionName()}`, document);
  }

  /** Another way to bend, with the settings that go with it. */
  bend(mode: PoseMode): void {
    if (mode === modeOf(this.project)) return;
    const label = mode === 'rigid' ? 'Bend rigidly' : 'Bend smoothly';
    this.step(label, { ...this.document, project: bent(this.project, mode) });
  }

  detail(detail: Detail): void {
    this.step(`Set detail to ${detail}`, { ...this.document, project: detailed(this.project, detail) });
  }

  /** Sets one number of everything selected, from what it is of each. */
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

  /** What came in a row of nudges is over. */
  settle(): void {
    this.#history.settle();
  }

  /** Takes back whatever needs the solution of this key, which is not to be had. Returns whether anything was left to go back to. */
  withdraw(key: string): boolean {
    this.#letGo(this.machine.cancel());
    this.#host.guarding.end();
    const drawn = this.#drawn?.key === key ? this.#drawn.draft : null;
    const left = this.#history.withdraw((document) => solveKey(document.project) !== key);
    // What took a dozen clicks is not lost because one of them was wrong.
    if (drawn) this.machine.resume(drawn);
    this.#drawn = null;
    if (left) this.#host.edited('change');
    return left;
  }

  /** What a press in hand did to the document goes with it; what it shows does not go by itself. */
  #letGo(effects: readonly Effect[]): void {
    this.apply(effects.filter(({ type }) => type === 'box'));
  }

  /** The same as a step, as far as the guard lets it go; what became of it is said. */
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

  /** Steps of one key in a row are one undo step; one that changes nothing is none. */
  #step(label: string, document: Document, key: string | null): void {
    if (JSON.stringify(document) === JSON.stringify(this.document)) return;
    this.#history.step(label, document, key);
    // A press in hand knows nothing of this step: what it did so far is a step before it, and it is over.
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

  /** What a person reads of the first selected handle. */
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
    this.#host.guarding.begin(this.document);
  }

  #input(document: Document): void {
    this.#history.update(this.#host.guarding.limited(this.document, document));
    this.#host.edited('input');
  }

  #commit(): void {
    this.#host.guarding.end();
    if (!this.#history.commit()) return;
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
