/** Messages to people: notices, texts for screen readers, and the current tasks. */
import type { Wording, Words } from '../texts/wording';
import type { EditorEvent } from './events';
import type { Task } from './task';

export interface Notice {
  readonly kind: 'error' | 'info';
  /** A string is a text of the page. */
  readonly text: Words;
  readonly action?: NoticeAction;
  /** A second action. */
  readonly other?: NoticeAction;
  /** The notice disappears automatically although it has an action. */
  readonly passes?: true;
  /** The notice is about the last step. Others about that step join it, and the next step ends it. */
  readonly ofStep?: true;
}

export interface NoticeAction {
  readonly label: Wording;
  readonly event: EditorEvent;
  /** The action changes nothing, so that it is also available to people who may change nothing. */
  readonly readsOnly?: true;
}

export interface NoticesState {
  /** A notice with an action, an error, and a notice that disappears automatically: the last one present is shown. */
  readonly offer: Notice | null;
  readonly error: Notice | null;
  readonly passing: Notice | null;
  /** The picture cannot be drawn. Shown after an error and before an offer, until the graphics card is back. */
  readonly graphics: Notice | null;
  /** The last text for screen readers, and whether they were said just before too. */
  readonly announcement: { readonly words: Wording; readonly again: boolean } | null;
  /** The newest last. */
  readonly tasks: readonly Task[];
}
