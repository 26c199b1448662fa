/**
 * Undo and redo by marks.
 *
 * A drag opens a step with `begin`, replaces the present any number of times with `update`, and ends with `commit`
 * (one undo step, or none if it ended where it began) or `bail` (back to the mark). Immediate changes use `step`;
 * consecutive steps with the same key merge into one, until `settle`. Values are immutable: a state costs only what it
 * does not share with its neighbours. Holds at most `LIMIT` steps.
 */
export interface Step<T> {
  /** What was done, as people read it: "Move head". */
  readonly label: string;
  /** In the past, the value before the step; in the future, the value after it. */
  readonly value: T;
}

/** A history as plain data, for storage. */
export interface HistoryRecord<T> {
  readonly past: readonly Step<T>[];
  readonly present: T;
  readonly future: readonly Step<T>[];
}

/** All values from the oldest to the newest, and the index of the present. */
export interface Timeline<T> {
  readonly values: readonly T[];
  readonly at: number;
}

const LIMIT = 500;

/** Whether two values are equal, so that going from one to the other is no step. */
export type Equality<T> = (a: T, b: T) => boolean;

export class History<T> {
  readonly #equal: Equality<T>;
  #past: readonly Step<T>[] = [];
  #present: T;
  #future: readonly Step<T>[] = [];
  #open: Step<T> | null = null;
  #key: string | null = null;

  constructor(present: T, equal: Equality<T> = Object.is) {
    this.#equal = equal;
    this.#present = present;
  }

  /** Replaces everything by another history. */
  restore({ past, present, future }: HistoryRecord<T>): void {
    [this.#past, this.#present, this.#future] = [past, present, future];
    this.#open = null;
    this.#key = null;
  }

  get present(): T {
    return this.#present;
  }

  /** The label of the step that undo would take back, or null. */
  get undoLabel(): string | null {
    return (this.#open ?? this.#past.at(-1))?.label ?? null;
  }

  get redoLabel(): string | null {
    return this.#future.at(-1)?.label ?? null;
  }

  /** Opens a step; an open one is committed first. */
  begin(label: string): void {
    this.commit();
    this.#open = { label, value: this.#present };
  }

  /** Replaces the present, within an open step or as a change without undo (a selection). */
  update(value: T): void {
    this.#present = value;
  }

  /** Changes the present without a step, as if it had been so when the open step began. */
  amend(change: (value: T) => T): void {
    this.#present = change(this.#present);
    this.#open = this.#open && { ...this.#open, value: change(this.#open.value) };
  }

  /** Ends the open step. Returns whether it changed anything. */
  commit(): boolean {
    const open = this.#open;
    this.#open = null;
    if (!open || this.#equal(open.value, this.#present)) return false;
    this.#push(open, null);
    return true;
  }

  /** Back to the mark, as if the open step had never begun. */
  bail(): void {
    if (!this.#open) return;
    this.#present = this.#open.value;
    this.#open = null;
  }

  /** Makes a whole step; with the key of the previous step, merges into that. Returns whether it changed anything. */
  step(label: string, value: T, key: string | null = null): boolean {
    if (this.#equal(value, this.#present)) return false;
    this.commit();
    const joins = key !== null && key === this.#key;
    const before = { label, value: this.#present };
    this.#present = value;
    if (joins) this.#join();
    else this.#push(before, key);
    return true;
  }

  /** Keeps the next step from merging, whatever its key. */
  settle(): void {
    this.#key = null;
  }

  /** Takes back the open step, or else the last one. Returns its label, or null. */
  undo(): string | null {
    if (this.#open) {
      const { label } = this.#open;
      this.bail();
      return label;
    }
    const step = this.#past.at(-1);
    if (!step) return null;
    this.#past = this.#past.slice(0, -1);
    this.#future = [...this.#future, { label: step.label, value: this.#present }];
    this.#present = step.value;
    this.#key = null;
    return step.label;
  }

  redo(): string | null {
    this.bail();
    const step = this.#future.at(-1);
    if (!step) return null;
    this.#future = this.#future.slice(0, -1);
    this.#past = [...this.#past, { label: step.label, value: this.#present }];
    this.#present = step.value;
    this.#key = null;
    return step.label;
  }

  get timeline(): Timeline<T> {
    const before = [...this.#past, ...(this.#open ? [this.#open] : [])];
    const values = [...before, { value: this.#present }, ...this.#future.toReversed()].map(
      ({ value }) => value,
    );
    return { values, at: before.length };
  }

  /**
   * Replaces the values of the timeline by as many others, and drops every step that no longer changes anything. An
   * open step stays open. Returns whether the present changed.
   */
  mend(values: readonly T[]): boolean {
    const [before, { at }] = [this.#present, this.timeline];
    const step = ({ label }: Step<T>, k: number): Step<T> => ({ label, value: values[k] as T });
    const last = values.length - 1;
    const changes = (a: T, b: T | undefined) => b === undefined || !this.#equal(a, b);
    this.#past = this.#past.map(step).filter(({ value }, k) => changes(value, values[k + 1]));
    this.#open = this.#open && step(this.#open, at - 1);
    this.#present = values[at] as T;
    this.#future = this.#future
      .map((redone, j) => step(redone, last - j))
      .filter(({ value }, j) => changes(value, values[last - j - 1]));
    this.#key = null;
    return this.#present !== before;
  }

  record(): HistoryRecord<T> {
    const present = this.#open ? this.#open.value : this.#present;
    return { past: this.#past, present, future: this.#future };
  }

  /** Makes the present part of the last step, and drops that step if it has come back to where it began. */
  #join(): void {
    this.#future = [];
    const last = this.#past.at(-1);
    if (!last || !this.#equal(last.value, this.#present)) return;
    this.#past = this.#past.slice(0, -1);
    this.#key = null;
  }

  #push(step: Step<T>, key: string | null): void {
    this.#past = [...this.#past, step].slice(-LIMIT);
    this.#future = [];
    this.#key = key;
  }
}
