/** Copying and pasting: keys of a clip, or poses of handles. */

import { keysAt, type PlacedKey, roundedTime } from '../../document/clip_keys';
import { selectedHandles } from '../../document/document';
import { isKeys, keysText, parseKeys } from '../../document/key_text';
import { parsePose, poseText } from '../../document/pose_text';
import type { Handle } from '../../document/project';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { holdsKeys, keysInHand } from '../keys_in_hand';
import { openClip } from '../open_clip';
import { mayEdit } from '../permissions';
import { handleWords } from '../selection_words';
import { documentOf, type EditorState, projectOf } from '../state';
import { pasteKeys } from './clip_keys';
import { withTimeline } from './clip_slice';
import { paste } from './edits';
import type { Handlers } from './handlers';
import { announce, notify } from './notices';

/** The selected handles, or else all, whose pose is copied. */
function copiedHandles(state: EditorState): readonly Handle[] {
  if (!mayEdit(state)) return [];
  const selected = selectedHandles(documentOf(state));
  return selected.length > 0 ? selected : projectOf(state).handles;
}

/** The selected keys, with the first of them at time 0. */
function copiedKeys(state: EditorState): readonly PlacedKey[] {
  const clip = openClip(state);
  const chosen = clip ? keysAt(clip, keysInHand(state)) : [];
  const first = Math.min(...chosen.map(({ key }) => key.time));
  return chosen.map(({ handle, key }) => ({ handle, key: { ...key, time: roundedTime(key.time - first) } }));
}

/** The text that the keyboard copies; null for nothing. */
export function copiedText(state: EditorState): string | null {
  if (holdsKeys(state)) return keysText(copiedKeys(state));
  const handles = copiedHandles(state);
  return handles.length > 0 ? poseText(handles) : null;
}

function keepKeys(state: EditorState): EditorState {
  const copied = copiedKeys(state);
  return announce(withTimeline(state, { copied }), say('notices.copiedKeys', copied.length));
}

const tellOfPose = (state: EditorState): EditorState =>
  announce(state, say('spoken.copiedPose', handleWords(copiedHandles(state))));

export function copyKeys(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'copy', text: keysText(copiedKeys(state)) });
  return keepKeys(state);
}

export function copyPose(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'copy', text: poseText(copiedHandles(state)) });
  return tellOfPose(state);
}

function pasteText(state: EditorState, text: string, emit: Emit): EditorState {
  const keys = parseKeys(text);
  if (keys) return pasteKeys(state, keys, emit);
  const handles = parsePose(text);
  return handles ? paste(state, handles, emit) : state;
}

export const clipboardHandlers: Handlers<'selection-copied' | 'text-pasted'> = {
  'selection-copied': (state) => (holdsKeys(state) ? keepKeys(state) : tellOfPose(state)),
  'text-pasted': (state, { text }, emit) => {
    if (!mayEdit(state)) return state;
    try {
      return pasteText(state, text, emit);
    } catch (error) {
      const fault = (error as Error).message;
      const words = isKeys(text) ? say('notices.badKeys', fault) : say('notices.badPose', fault);
      return notify(state, { kind: 'error', text: words }, emit);
    }
  },
};
