/** The loss of the graphics context: browsers take it away, and mostly give it back within a moment. */
import { graphicsLostWords } from '../notice_words';
import { mayEdit } from '../permissions';
import type { EditorState } from '../state';
import type { Handlers } from './handlers';
import { notifyOfGraphics, withoutGraphicsNotice } from './notices';

/** A context that is still missing after this time is unlikely to return. */
const PATIENCE_MS = 1500;

export function tellOfLostGraphics(state: EditorState): EditorState {
  const { key, failing } = state.autosave;
  const loses = mayEdit(state) && !state.page.posable;
  return notifyOfGraphics(state, graphicsLostWords(loses ? key !== null && !failing : null));
}

export const graphicsHandlers: Handlers<'graphics-lost' | 'graphics-restored'> = {
  'graphics-lost': (state, _, emit) => {
    emit({ type: 'start-timer', timer: 'graphics', ms: PATIENCE_MS });
    return state;
  },
  'graphics-restored': (state, _, emit) => {
    emit({ type: 'stop-timer', timer: 'graphics' });
    return withoutGraphicsNotice(state);
  },
};
