/** The luminance of the picture, which the lasso needs to find edges. */
import type { Emit } from '../effects';
import { isLassoing } from '../hit_areas';
import type { EditorState } from '../state';
import { saveWork } from './autosave';
import type { Handlers } from './handlers';

/** Asks for the luminance of the picture while the lasso is in hand. */
export function wantLuminance(state: EditorState, emit: Emit): EditorState {
  const { picture, luminance } = state;
  if (picture && isLassoing(state) && luminance?.of !== picture) emit({ type: 'read-luminance', picture });
  return state;
}

export const luminanceHandlers: Handlers<'luminance-read' | 'edge-snapping-switched'> = {
  'luminance-read': (state, { picture, values }) =>
    picture === state.picture && values ? { ...state, luminance: { of: picture, values } } : state,
  'edge-snapping-switched': (state, { on }, emit) =>
    saveWork({ ...state, display: { ...state.display, edgeSnapping: on } }, emit),
};
