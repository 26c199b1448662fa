export type TaskName = 'open' | 'solve' | 'export';

/** A task that takes noticeable time. */
export interface Task {
  readonly name: TaskName;
  readonly label: string;
  readonly cancellable: boolean;
}
