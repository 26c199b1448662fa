import type { Wording, Words } from '../texts/wording';

export type TaskName = 'open' | 'solve' | 'export' | 'suggest' | 'fill';

/** A task that takes noticeable time. */
export interface Task {
  readonly name: TaskName;
  readonly label: Wording;
  readonly cancellable: boolean;
  /** The part that is done, from 0 to 1, if it is known. */
  readonly fraction?: number;
  /** How long it will still take. */
  readonly left?: Words;
}
