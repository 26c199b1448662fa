/** How the work is stored in the browser, shared with other tabs under one key. */
export interface AutosaveState {
  /** Work is stored under this key; null stores nothing. */
  readonly key: string | null;
  /** Stored work is being reopened: it need not be stored again. */
  readonly restoring: boolean;
  /** Stored work could not be opened. It stays stored until there is other work. */
  readonly unread: boolean;
  /** Identifies the last stored step. */
  readonly step: string;
  /** Other tabs have not heard of the last step yet. */
  readonly unannounced: boolean;
  /** Another tab was the last to store a step, and the person knows. */
  readonly overwritten: boolean;
  /** The newest state is being stored. */
  readonly storing: boolean;
  /** The last attempt to store work failed. */
  readonly failing: boolean;
}
