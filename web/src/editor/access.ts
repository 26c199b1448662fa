import type { Dispatch } from './events';
import type { EditorState } from './state';

/** The running editor, for inputs and resources: its state at any moment, and the way to change it. */
export interface EditorAccess {
  readonly state: EditorState;
  readonly dispatch: Dispatch;
}
