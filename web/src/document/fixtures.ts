/** Handles and histories for tests. */
import { en } from '../texts/en';
import { say, type Wording, type Words, worded } from '../texts/wording';
import * as h from './history';
import type { BarHandle } from './project';

/** A bar at rest, from the origin to the right. Its length is in pixels. */
export const straightBar = (length: number): BarHandle => {
  const line = [
    [0, 0],
    [length, 0],
  ] as const;
  return { id: 'arm', kind: 'bar', rest: line, posed: line, rotation: 'auto' };
};

/** Tests name steps as they like. */
const labelOf = (label: Words): Wording => (typeof label === 'string' ? say('errors.other', label) : label);

const inEnglish = (label: Wording | null): string | null => label && worded(en, label);

/** A history behind one mutable field, so that a test reads as a list of steps. */
export class TestHistory<T> {
  #history: h.History<T>;
  readonly #same: h.Equality<T>;

  constructor(present: T, same: h.Equality<T> = Object.is) {
    this.#history = h.historyOf({ past: [], present, future: [] });
    this.#same = same;
  }

  get present(): T {
    return this.#history.present;
  }

  get undoLabel(): string | null {
    return inEnglish(h.undoLabel(this.#history));
  }

  get redoLabel(): string | null {
    return inEnglish(h.redoLabel(this.#history));
  }

  get timeline(): h.Timeline<T> {
    return h.timeline(this.#history);
  }

  begin = (label: Words) => this.#put(h.begin(this.#history, labelOf(label), this.#same));
  update = (value: T) => this.#put(h.update(this.#history, value));
  amend = (change: (value: T) => T) => this.#put(h.amend(this.#history, change));
  bail = () => this.#put(h.bail(this.#history));
  endMerging = () => this.#put(h.endMerging(this.#history));
  redo = () => this.#put(h.redo(this.#history));
  record = () => h.recordOf(this.#history);
  restore = (record: h.HistoryRecord<T>) => this.#put(h.historyOf(record));

  /** Returns the label of the step that was taken back. */
  undo(): string | null {
    const { undoLabel } = this;
    this.#put(h.undo(this.#history));
    return undoLabel;
  }

  /** Returns whether a step was made. */
  commit(): boolean {
    const { past } = this.#history;
    this.#put(h.commit(this.#history, this.#same));
    return this.#history.past !== past;
  }

  /** Returns whether something changed. */
  step(label: string, value: T, key?: string): boolean {
    const before = this.#history;
    this.#put(h.step(before, labelOf(label), value, this.#same, key));
    return this.#history !== before;
  }

  /** Returns whether the present changed. */
  revise(values: readonly T[]): boolean {
    const { present } = this.#history;
    this.#put(h.revise(this.#history, values, this.#same));
    return this.#history.present !== present;
  }

  #put(history: h.History<T>): void {
    this.#history = history;
  }
}
