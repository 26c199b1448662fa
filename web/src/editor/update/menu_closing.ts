import type { Emit } from '../effects';
import { type EditorState, selectionOf } from '../state';

/** Closes the context menu. The focus returns to where it was. */
export function closeMenu(state: EditorState, emit: Emit): EditorState {
  if (!state.menu) return state;
  emit({ type: 'hide-menu' });
  return { ...state, focus: state.menu.focus, menu: null };
}

/** Closes the menu if its handles are no longer the selected ones. */
export const closeMenuUnlessSelected = (state: EditorState, emit: Emit): EditorState =>
  state.menu && selectionOf(state).join('\n') !== state.menu.selection.join('\n')
    ? closeMenu(state, emit)
    : state;
