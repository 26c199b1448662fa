/**
 * The open document: its history, the tool machine that changes it, and what the solver takes back.
 *
 * Independent of the DOM. After each change the host gets its kind and a text for screen readers.
 */
import { type Document, handleById } from '../document/document';
import { putHandles, selectHandles } from '../document/edits';
import type { PosedDocument } from '../document/group';
import type { History, HistoryRecord } from '../document/history';
import type { Handle, Project } from '../document/project';
import {
  handleToRevert,
  revertHandle,
  withHandleReverted,
  withSolutionReverted,
} from '../document/reverting';
import { solveKey, solvesWith } from '../document/solved';
import { type Drawings, ToolMachine } from '../tools/machine';
import type { Draft, Effect } from '../tools/state';
import type { Guarding } from './guarding';
import type { Posing } from './posing';
import { placeWords } from './wording';

/**
 * `open`: another document; `input`: during a drag; `change`: committed; `selection`: only the selection changed; `pose`:
 * the page has posed handles, without a step.
 */
export type ChangeKind = 'open' | 'input' | 'change' | 'selection' | 'pose';

export interface EditingHost {
  edited(kind: ChangeKind): void;
  say(text: string): void;
  /** Carries out an effect that does not concern the document. */
  carryOut(effect: Effect): void;
}

export class Editing {
  readonly machine = new ToolMachine();
  readonly #history: History<Document>;
  readonly #posing: Posing;
  readonly #guarding: Guarding;
  readonly #host: EditingHost;
  /** The last finished drawing and its handle, to resume the drawing if the solver refuses the handle. */
  #drawn: { readonly draft: Draft; readonly handle: Handle } | null = null;
  /** How the present was reached, if not by an edit. */
  #travelled: 'undo' | 'redo' | null = null;
  /** Handles that the solver has refused during the current press. */
  #refused: readonly Handle[] = [];
  /** Ids of handles that the page has posed during the current drag. */
  readonly #led = new Set<string>();

  constructor(history: History<Document>, posing: Posing, guarding: Guarding, host: EditingHost) {
    this.#history = history;
    this.#posing = posing;
    this.#guarding = guarding;
    this.#host = host;
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
    this.#travelled = null;
    this.#guarding.end();
    this.#history.restore(record);
    this.#host.edited('open');
  }

  /** Carries out the effects of a tool. */
  apply(effects: readonly Effect[]): void {
    for (const effect of effects) {
      if (effect.type === 'begin') this.#begin(effect.label);
      else if (effect.type === 'edit') this.#input(effect);
      else if (effect.type === 'commit') this.#end();
      else if (effect.type === 'bail') this.#bail();
      else if (effect.type === 'select') this.select(effect.ids);
      else if (effect.type === 'drawn') this.#drawn = effect;
      else this.#host.carryOut(effect);
    }
  }

  select(ids: readonly string[]): void {
    const before = this.document.selection;
    const next = selectHandles(this.document, ids);
    if (next.selection.join('\n') === before.join('\n')) return;
    this.#history.settle();
    this.#history.update(next);
    if (!this.machine.busy) this.#guarding.end();
    this.#host.edited('selection');
  }

  /** Selects handles for the page. That ends a press, whose changes stay. */
  put(ids: readonly string[]): void {
    if (this.machine.busy && this.#putDown()) this.#host.edited('change');
    this.select(ids);
  }

  toggle(id: string): void {
    const { selection } = this.document;
    this.select(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id]);
  }

  /** Commits a change as one undo step, and announces it, unless it changes nothing. */
  step(label: string, document: Document): void {
    this.#guarding.end();
    if (this.commit(label, document)) this.#host.say(label);
  }

  /**
   * Commits a change unless it changes nothing. Consecutive changes with the same key form one undo step.
   *
   * @returns whether it has changed something.
   */
  commit(label: string, document: Document, key: string | null = null): boolean {
    if (!this.#history.step(label, document, key)) return false;
    this.#travelled = null;
    // The current press would overwrite this step. Its changes so far are already a step of their own.
    if (this.machine.busy) this.apply(this.machine.cancel());
    this.#host.edited('change');
    return true;
  }

  /** Poses handles without a step. A press goes on: the handles that it holds are left to it. */
  pose(handles: readonly Handle[]): void {
    const held = this.machine.holds ? this.document.selection : [];
    const led = handles.filter(({ id }) => !held.includes(id));
    if (led.length === 0) return;
    for (const { id } of led) this.#led.add(id);
    this.#history.amend((document) => putHandles(document, led));
    this.#host.edited('pose');
  }

  undo(): void {
    this.#travel('undo', 'Undone', this.#history.undo());
  }

  redo(): void {
    this.#travel('redo', 'Redone', this.#history.redo());
  }

  /** The last project before the present one of which something is true. */
  last(is: (project: Project) => boolean): Project | null {
    const { values, at } = this.#history.timeline;
    return values.slice(0, at).findLast(({ project }) => is(project))?.project ?? null;
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
   * Takes back undo or redo, to the nearest state with the solution of this key: what they passed stays in the history.
   * Returns false if the present was reached by an edit, or there is no such state.
   */
  turnBack(key: string): boolean {
    const { values, at } = this.#history.timeline;
    const stands = ({ project }: Document) => solveKey(project) === key;
    let to = -1;
    if (this.#travelled === 'undo') to = values.findIndex((document, k) => k > at && stands(document));
    if (this.#travelled === 'redo') to = values.findLastIndex((document, k) => k < at && stands(document));
    if (to < 0) return false;
    for (let k = at; k < to; k++) this.#history.redo();
    for (let k = at; k > to; k--) this.#history.undo();
    this.#travelled = null;
    this.#host.edited('change');
    return true;
  }

  /**
   * Takes back what makes the solution of this key impossible or unwanted: one of the `named` handles, or else every
   * state that needs that solution. Returns whether the document has changed.
   *
   * @param accepted the last solved project.
   */
  withdraw(key: string, named: readonly string[] = [], accepted: Project | null = null): boolean {
    const { timeline } = this.#history;
    const handle = handleToRevert(timeline, named, accepted);
    const { project } = this;
    const left = this.#history.mend(
      handle ? withHandleReverted(timeline, handle) : withSolutionReverted(timeline, key),
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

  /** Ends the current press and keeps its changes so far. Returns whether there were any. */
  #putDown(): boolean {
    this.#letGo(this.machine.cancel());
    this.#guarding.end();
    return this.#history.commit();
  }

  /** Drops the effects that end a press, except the one that clears its selection box. */
  #letGo(effects: readonly Effect[]): void {
    this.apply(effects.filter(({ type }) => type === 'box'));
  }

  #begin(label: string): void {
    this.#history.begin(label);
    this.#travelled = null;
    this.#refused = [];
    this.#led.clear();
    this.#guarding.begin(this.document);
  }

  #input(edit: PosedDocument): void {
    // A drag computes every move from the document at its start, which still has the refused handles, and the poses of
    // that moment.
    const led = [...this.#led].flatMap((id) => handleById(this.document, id) ?? []);
    const wanted = this.#refused.reduce(
      (mended, handle) => revertHandle(mended, handle, this.document),
      putHandles(edit.document, led),
    );
    this.#history.update(this.#guarding.limited(this.document, { ...edit, document: wanted }));
    this.#host.edited('input');
  }

  #end(): void {
    this.#guarding.end();
    if (!this.#history.commit()) {
      // The drag changed nothing: its label must disappear from undo.
      this.#host.edited('input');
      return;
    }
    this.#host.edited('change');
    const label = this.#history.undoLabel ?? '';
    this.#host.say(`${label}. ${placeWords(this.document, this.#posing.turns())}`);
  }

  #bail(): void {
    this.#guarding.end();
    this.#history.bail();
    this.#host.edited('input');
  }

  #travel(way: 'undo' | 'redo', verb: string, label: string | null): void {
    this.apply(this.machine.cancel());
    this.machine.forget();
    this.#guarding.end();
    if (label === null) return;
    this.#travelled = way;
    this.#host.edited('change');
    this.#host.say(`${verb}: ${label}`);
  }
}
