import { type KeyRef, keysAt } from '../document/clip_keys';
import { openClip } from './open_clip';
import { mayEdit } from './permissions';
import type { EditorState } from './state';

/**
 * The selected keys of the open clip, the last selected one last. Keyboard commands apply to them. Without selected
 * keys, they apply to the selected handles. Selecting a handle deselects the keys.
 */
export function keysInHand(state: EditorState): readonly KeyRef[] {
  const clip = mayEdit(state) && !state.page.posable ? openClip(state) : null;
  return clip ? state.timeline.selected.filter((ref) => keysAt(clip, [ref]).length > 0) : [];
}

export const holdsKeys = (state: EditorState): boolean => keysInHand(state).length > 0;
