/** The effects of the brush that a person has used: their hints are no longer needed. */
import { isBrushing } from '../hit_areas';
import type { EditorState } from '../state';

/** A stroke has begun. */
export function noteStroke(state: EditorState): EditorState {
  const { kind, used } = state.brush;
  if (!isBrushing(state) || used.includes(kind)) return state;
  return { ...state, brush: { ...state.brush, used: [...used, kind] } };
}
