/** Selecting handles. A selection is no undo step, but it ends the merging of nudges. */
import { selectHandles } from '../../document/edits';
import { endMerging, update } from '../../document/history';
import { isPressing } from '../../tools/machine';
import type { Emit } from '../effects';
import { documentOf, type EditorState, selectionOf } from '../state';
import { withTimeline } from './clip_slice';
import { guardEnded, withHistory } from './document_slice';
import { edited } from './edited';

/** Deselects the keys: keyboard commands apply to the handles again. */
export const withoutKeys = (state: EditorState): EditorState =>
  state.timeline.selected.length > 0 ? withTimeline(state, { selected: [] }) : state;

/** Selects handles, and no keys of a clip. */
export function select(given: EditorState, ids: readonly string[], emit: Emit): EditorState {
  const state = withoutKeys(given);
  const before = documentOf(state);
  const next = selectHandles(before, ids);
  if (next.selection.join('\n') === before.selection.join('\n')) return state;
  const separate = endMerging(state.document.history);
  const selected = withHistory(state, update(separate, next));
  return edited(isPressing(state.tools) ? selected : guardEnded(selected), 'selection', emit);
}

export function toggleSelected(state: EditorState, id: string, emit: Emit): EditorState {
  const selection = selectionOf(state);
  return select(
    state,
    selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id],
    emit,
  );
}
