/** The keys of the open clip: selected, moved, eased, copied, mirrored, removed, and set for the selected handles. */

import { restingRotation } from '../../document/bending';
import {
  allowedMove,
  easeKeys,
  isKeyed,
  isSameKey,
  KEYED_VALUES,
  type KeyedValue,
  type KeyRef,
  keyBeside,
  keyCorners,
  keyOf,
  keysAt,
  moveKeys,
  type PlacedKey,
  putKeys,
  refOf,
  removeKeys,
  roundedTime,
  trackOf,
  withKey,
} from '../../document/clip_keys';
import { addClip, changeClip, freeClipName, newClip } from '../../document/clips';
import { handleById, selectedHandles } from '../../document/document';
import { changeHandles } from '../../document/edits';
import { atRest, corners, isAutomatic, isLine } from '../../document/handle';
import { mirrorHandles } from '../../document/mirror';
import type { Clip, Handle, Key, Project } from '../../document/project';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { holdsKeys, keysInHand } from '../keys_in_hand';
import { openClip } from '../open_clip';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, filedProject, projectOf, selectionOf } from '../state';
import { withTimeline } from './clip_slice';
import { editClip, editProject } from './clips';
import { focus } from './corners';
import type { Handlers } from './handlers';
import { inform } from './notices';
import { movePlayhead } from './playhead';
import { select } from './selection';

/** Selects keys, and their handles with them. The last one leads. */
function selectKeys(state: EditorState, keys: readonly KeyRef[], emit: Emit): EditorState {
  const clip = openClip(state);
  if (!clip) return state;
  const known = keys.filter((ref) => keysAt(clip, [ref]).length > 0);
  const handles = [...new Set(known.map(({ handle }) => handle))];
  const selected = handles.length > 0 ? select(state, handles, emit) : state;
  return withTimeline(selected, { selected: known });
}

/** Shows the selected keys where a drag would put them, and puts them there when it ends. */
function drag(state: EditorState, by: number, ended: boolean, emit: Emit): EditorState {
  const { rate, selected } = state.timeline;
  const clip = openClip(state);
  if (!clip || !mayEdit(state)) return state;
  const frames = Math.round(by * rate) / rate;
  if (!ended) return withTimeline(state, { dragged: allowedMove(clip, selected, frames) });
  return move(withTimeline(state, { dragged: 0 }), frames, null, emit);
}

/** Moves the selected keys by seconds. */
function move(state: EditorState, by: number, key: string | null, emit: Emit): EditorState {
  const clip = openClip(state);
  if (!clip) return state;
  const moved = moveKeys(clip, state.timeline.selected, by);
  const label = say('steps.moveKeys', state.timeline.selected.length);
  const next = editClip(state, label, () => moved.clip, emit, key);
  return withTimeline(next, { selected: moved.refs });
}

/** Goes from the last selected key to the one beside it, and moves the playhead there. */
function walk(state: EditorState, by: Vec, extend: boolean, emit: Emit): EditorState {
  const clip = openClip(state);
  const keys = keysInHand(state);
  const from = keys.at(-1);
  const handles = projectOf(state).handles.map(({ id }) => id);
  const to = clip && from && keyBeside(clip, handles, from, by);
  if (!to) return state;
  const others = extend ? keys.filter((key) => !isSameKey(key, to)) : [];
  return focusLead(movePlayhead(selectKeys(state, [...others, to], emit), to.time, emit), emit);
}

/** If a key has the focus, moves the focus to the last selected key. */
function focusLead(state: EditorState, emit: Emit): EditorState {
  const key = keysInHand(state).at(-1);
  if (key && state.focus.on === 'key') focusKey(key, emit);
  return state;
}

/** The focus goes along with the selection, from a key to a handle and back. */
export function followSelection(state: EditorState, emit: Emit): EditorState {
  const { on } = state.focus;
  const key = keysInHand(state).at(-1);
  if (key && (on === 'handle' || on === 'corner')) focusKey(key, emit);
  else if (!key && on === 'key' && mayEdit(state)) focus(emit, selectionOf(state)[0]);
  return state;
}

const focusKey = (key: KeyRef, emit: Emit): void =>
  emit({ type: 'focus', target: { handle: null, corner: null, key } });

export function selectAllKeys(state: EditorState, emit: Emit): EditorState {
  const { tracks } = openClip(state) ?? { tracks: [] };
  const all = tracks.flatMap(({ handle, keys }) => keys.map(({ time }) => ({ handle, time })));
  return selectKeys(state, all, emit);
}

/**
 * Sets keys of the selected handles at the playhead, in the pose that they have. The keyboard stays with the
 * handles, or with keys.
 */
export function setKeys(before: EditorState, emit: Emit): EditorState {
  const state = withClip(before, emit);
  const clip = openClip(state);
  const document = documentOf(state);
  if (!clip) return state;
  const { time } = state.timeline;
  const placed = selectionOf(state).flatMap((id): readonly PlacedKey[] => {
    const handle = handleById(document, id);
    return handle ? [{ handle: id, key: keyOf(handle, time, keyedValues(clip, handle, time)) }] : [];
  });
  const label = say('steps.setKeys', placed.length);
  const next = editClip(state, label, (clip) => putKeys(clip, placed), emit);
  return withTimeline(next, { selected: holdsKeys(before) ? placed.map(refOf) : [] });
}

/** Adds a clip if there is none. */
function withClip(state: EditorState, emit: Emit): EditorState {
  if (openClip(state)) return state;
  const clip = newClip(freeClipName(filedProject(state), 'clip'));
  return withTimeline(
    editProject(state, say('steps.addClip', clip.name), (project) => addClip(project, clip), emit),
    { clip: clip.name },
  );
}

function keyedValues(clip: Clip, handle: Handle, time: number): readonly KeyedValue[] {
  const track = trackOf(clip, handle.id);
  return KEYED_VALUES.filter(
    (value) => isKeyed(track, time, value) || (value === 'rotation' && hasOwnTurn(handle)),
  );
}

const hasOwnTurn = (handle: Handle): boolean => !isLine(handle) && !isAutomatic(handle);

/**
 * Pastes keys from the playhead on. Those of handles that are gone, or beyond the end, are left out.
 * @throws RangeError with the reason if a handle cannot have the values of its key.
 */
export function pasteKeys(state: EditorState, keys: readonly PlacedKey[], emit: Emit): EditorState {
  const { time } = state.timeline;
  const clip = openClip(state);
  if (!clip) return inform(state, say('reasons.noClipOpen'), emit);
  const document = documentOf(state);
  const pasted = keys
    .map(({ handle, key }) => ({ handle, key: { ...key, time: roundedTime(time + key.time) } }))
    .filter(({ handle, key }) => key.time <= clip.duration && fits(key, handleById(document, handle)));
  const left = keys.length - pasted.length;
  const label = say('steps.pasteKeys', pasted.length);
  const next = selectKeys(
    editClip(state, label, (clip) => putKeys(clip, pasted), emit),
    pasted.map(refOf),
    emit,
  );
  return left > 0 ? inform(next, say('notices.keysLeftOut', left), emit) : next;
}

function fits(key: Key, handle: Handle | undefined): boolean {
  if (!handle) return false;
  const isAsLong = !Array.isArray(key.posed) || keyCorners(key.posed).length === corners(handle).length;
  return isAsLong && withKey(handle, key) !== null;
}

/** Gives the selected keys to the handles on the other side, mirrored. */
export function mirrorSelectedKeys(state: EditorState, emit: Emit): EditorState {
  const clip = openClip(state);
  const deformation = state.solution.shown?.deformation;
  const bounds = deformation?.restBounds();
  const chosen = clip ? keysAt(clip, state.timeline.selected) : [];
  if (!clip || !deformation || !bounds) return state;
  const bends = (rest: Vec) => deformation.bends(rest);
  let project = filedProject(state);
  const placed: PlacedKey[] = [];
  for (const { handle: id, key } of chosen) {
    const before = { project, selection: [id] };
    const posed = changeHandles(before, [id], (handle) => withKey(handle, key));
    const { document } = mirrorHandles(posed, bounds, bends);
    project = withNewHandles(project, document.project);
    for (const handle of selectedHandles(document)) {
      const values = KEYED_VALUES.filter((value) => key[value] !== undefined);
      if (handle.id !== id || document.selection.length === 1)
        placed.push({
          handle: handle.id,
          key: { ...keyOf(handle, key.time, values), ease: key.ease ?? 'smooth' },
        });
    }
  }
  const label = say('steps.mirrorKeys', chosen.length);
  const next = editProject(
    state,
    label,
    () => changeClip(project, clip.name, (clip) => putKeys(clip, placed)),
    emit,
  );
  return selectKeys(next, placed.map(refOf), emit);
}

export function removeSelectedKeys(state: EditorState, emit: Emit): EditorState {
  const selected = keysInHand(state);
  const label = say('steps.deleteKeys', selected.length);
  const next = editClip(state, label, (clip) => removeKeys(clip, selected), emit);
  return withTimeline(next, { selected: [] });
}

/** Adds the handles that another project has besides, at rest. */
const withNewHandles = (project: Project, other: Project): Project => ({
  ...project,
  handles: [
    ...project.handles,
    ...other.handles
      .filter(({ id }) => !project.handles.some((handle) => handle.id === id))
      .map((handle) => atRest(handle, restingRotation(project))),
  ],
});

export const clipKeyHandlers: Handlers<
  'keys-selected' | 'keys-dragged' | 'keys-drag-cancelled' | 'keys-stepped' | 'keys-walked' | 'keys-eased'
> = {
  'keys-selected': (state, { keys }, emit) => selectKeys(state, keys, emit),
  'keys-dragged': (state, { by, ended }, emit) => drag(state, by, ended, emit),
  'keys-drag-cancelled': (state) => withTimeline(state, { dragged: 0 }),
  'keys-stepped': (state, { frames }, emit) =>
    focusLead(move(state, frames / state.timeline.rate, 'step keys', emit), emit),
  'keys-walked': (state, event, emit) => walk(state, event.by, event.extends, emit),
  'keys-eased': (state, { ease }, emit) =>
    editClip(
      state,
      say(`steps.ease.${ease}`, state.timeline.selected.length),
      (clip) => easeKeys(clip, state.timeline.selected, ease),
      emit,
    ),
};
