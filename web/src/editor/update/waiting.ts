/** Keeping input that waits for its picture, and releasing it. See `waiting_input.ts`. */
import type { Emit } from '../effects';
import type { EditorEvent } from '../events';
import type { EditorState } from '../state';
import { awaitsPicture, chosenTool } from '../waiting_input';
import { focus } from './corners';
import type { Handlers } from './handlers';

export function keepWaiting(state: EditorState, event: EditorEvent, emit: Emit): EditorState {
  // Enter then reaches the stage, and not the control that was pressed last.
  if (chosenTool(event) !== null) focus(emit);
  return { ...state, waiting: [...state.waiting, event] };
}

/** Asks the runtime to release the first event once the page shows this state, and so has moved the focus. */
export function askForRelease(state: EditorState, emit: Emit): EditorState {
  if (state.waiting.length > 0 && !awaitsPicture(state)) emit({ type: 'release-input' });
  return state;
}

export const waitingHandlers: Handlers<'input-released'> = {
  'input-released': (state, _, emit) => {
    const [event, ...waiting] = state.waiting;
    if (!event || awaitsPicture(state)) return state;
    emit({ type: 'follow-up', event });
    return { ...state, waiting };
  },
};
