/**
 * Undo and redo as immutable data.
 *
 * A drag opens a step with `begin`, replaces the present any number of times with `update`, and ends with `commit`
 * (one undo step, or none if nothing changed) or `bail` (back to the start). An immediate change is a `step`.
 * Consecutive steps with the same key merge until `endMerging`. A history holds at most `MAX_STEPS` steps.
 *
 * Functions that may drop a step without a change take `same`, the equality of two values.
 */
import type { Wording } from '../texts/wording';

export interface Step<T> {
  /** The name of the step for people: "Move head". */
  readonly label: Wording;
  /** In the past, the value before the step; in the future, the value after it. */
  readonly value: T;
}

/** The part of a history that is stored. */
export interface HistoryRecord<T> {
  readonly past: readonly Step<T>[];
  readonly present: T;
  readonly future: readonly Step<T>[];
}

export interface History<T> extends HistoryRecord<T> {
  /** The step that a drag has opened. */
  readonly open: Step<T> | null;
  /** The next step with this key merges into the last one. */
  readonly mergeKey: string | null;
}

/** All values from the oldest to the newest, and the index of the present. */
export interface Timeline<T> {
  readonly values: readonly T[];
  readonly at: number;
}

export type Equality<T> = (a: T, b: T) => boolean;

const MAX_STEPS = 500;

export const historyOf = <T>({ past, present, future }: HistoryRecord<T>): History<T> => ({
  past,
  present,
  future,
  open: null,
  mergeKey: null,
});

/** The label of the step that `undo` takes back, or null. */
export const undoLabel = <T>({ open, past }: History<T>): Wording | null =>
  (open ?? past.at(-1))?.label ?? null;

/** The label of the step that `redo` brings back, or null. */
export const redoLabel = <T>({ future }: History<T>): Wording | null => future.at(-1)?.label ?? null;

/** Opens a step. Commits an open step first. */
export const begin = <T>(history: History<T>, label: Wording, same: Equality<T>): History<T> => ({
  ...commit(history, same),
  open: { label, value: history.present },
});

/** Replaces the present within an open step, or without an undo step (a selection). */
export const update = <T>(history: History<T>, present: T): History<T> => ({ ...history, present });

/** Changes the present without a step, as if it had been so before the open step began. */
export const amend = <T>(history: History<T>, change: (value: T) => T): History<T> => ({
  ...history,
  present: change(history.present),
  open: history.open && { ...history.open, value: change(history.open.value) },
});

/** Ends the open step. `past` is unchanged if the step changed nothing. */
export function commit<T>(history: History<T>, same: Equality<T>): History<T> {
  const { open } = history;
  if (!open) return history;
  const ended = { ...history, open: null };
  return same(open.value, history.present) ? ended : pushed(ended, open, null);
}

/** Returns to the start of the open step. */
export const bail = <T>(history: History<T>): History<T> =>
  history.open ? { ...history, present: history.open.value, open: null } : history;

/** Makes a whole step; with the key of the last step, merges into that. Returns `history` itself without a change. */
export function step<T>(
  history: History<T>,
  label: Wording,
  value: T,
  same: Equality<T>,
  key: string | null = null,
): History<T> {
  if (same(value, history.present)) return history;
  const before = commit(history, same);
  const next = { ...before, present: value };
  const merges = key !== null && key === before.mergeKey;
  return merges ? merged(next, same) : pushed(next, { label, value: before.present }, key);
}

/** Keeps the next step from merging. */
export const endMerging = <T>(history: History<T>): History<T> =>
  history.mergeKey === null ? history : { ...history, mergeKey: null };

/** Takes back the open step, or else the last one. */
export function undo<T>(history: History<T>): History<T> {
  if (history.open) return bail(history);
  const last = history.past.at(-1);
  if (!last) return history;
  return {
    past: history.past.slice(0, -1),
    present: last.value,
    future: [...history.future, { label: last.label, value: history.present }],
    open: null,
    mergeKey: null,
  };
}

/** Takes back the open step, and brings back the step undone last. */
export function redo<T>(history: History<T>): History<T> {
  const before = bail(history);
  const next = before.future.at(-1);
  if (!next) return before;
  return {
    past: [...before.past, { label: next.label, value: before.present }],
    present: next.value,
    future: before.future.slice(0, -1),
    open: null,
    mergeKey: null,
  };
}

export function timeline<T>({ past, open, present, future }: History<T>): Timeline<T> {
  const before = [...past, ...(open ? [open] : [])].map(({ value }) => value);
  const after = future.toReversed().map(({ value }) => value);
  return { values: [...before, present, ...after], at: before.length };
}

/**
 * Replaces the values of the timeline by as many others, and drops each step that no longer changes anything. An open
 * step stays open.
 */
export function revise<T>(history: History<T>, values: readonly T[], same: Equality<T>): History<T> {
  const { at } = timeline(history);
  const last = values.length - 1;
  const revised = ({ label }: Step<T>, k: number): Step<T> => ({ label, value: values[k] as T });
  const changes = (a: T, b: T | undefined) => b === undefined || !same(a, b);
  return {
    past: history.past.map(revised).filter(({ value }, k) => changes(value, values[k + 1])),
    open: history.open && revised(history.open, at - 1),
    present: values[at] as T,
    future: history.future
      .map((redone, j) => revised(redone, last - j))
      .filter(({ value }, j) => changes(value, values[last - j - 1])),
    mergeKey: null,
  };
}

/** The history as it is stored: without the open step. */
export const recordOf = <T>({ past, open, present, future }: History<T>): HistoryRecord<T> => ({
  past,
  present: open ? open.value : present,
  future,
});

/** Makes the present part of the last step. Drops that step if the value is back where the step began. */
function merged<T>(history: History<T>, same: Equality<T>): History<T> {
  const last = history.past.at(-1);
  const joined = { ...history, future: [] };
  if (!last || !same(last.value, history.present)) return joined;
  return { ...joined, past: history.past.slice(0, -1), mergeKey: null };
}

const pushed = <T>(history: History<T>, step: Step<T>, mergeKey: string | null): History<T> => ({
  ...history,
  past: [...history.past, step].slice(-MAX_STEPS),
  future: [],
  mergeKey,
});
