/** The keys of the open clip: selected, moved, eased, copied, mirrored, removed, and set for the selected handles. */

import { restingRotation } from '../../document/bending';
import {
  allowedMove,
  easeKeys,
  isKeyed,
  KEYED_VALUES,
  type KeyedValue,
  type KeyRef,
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
} from '../../document/clip_keys';
import { addClip, changeClip, freeClipName, newClip } from '../../document/clips';
import { type Document, handleById, selectedHandles } from '../../document/document';
import { changeHandles } from '../../document/edits';
import { atRest, corners, isLine } from '../../document/handle';
import { mirrorHandles } from '../../document/mirror';
import type { Clip, Handle, Key, Project } from '../../document/project';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, filedProject, selectionOf } from '../state';
import { withTimeline } from './clip_slice';
import { editClip, editProject } from './clips';
import type { Handlers } from './handlers';
import { announce, inform } from './notices';
import { select } from './selection';

/** Selects keys, and their handles with them. */
function selectKeys(state: EditorState, keys: readonly KeyRef[], emit: Emit): EditorState {
  const clip = openClip(state);
  if (!clip) return state;
  const known = keysAt(clip, keys).map(refOf);
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

/** Sets keys of the selected handles at the playhead, in the pose that they have. */
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
  return withTimeline(next, { selected: placed.map(refOf) });
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

const hasOwnTurn = (handle: Handle): boolean => !isLine(handle) && typeof handle.rotation === 'number';

/** The selected keys with the first of them at time 0. */
function copy(state: EditorState): EditorState {
  const clip = openClip(state);
  const chosen = clip ? keysAt(clip, state.timeline.selected) : [];
  const first = Math.min(...chosen.map(({ key }) => key.time));
  const copied = chosen.map(({ handle, key }) => ({
    handle,
    key: { ...key, time: roundedTime(key.time - first) },
  }));
  if (copied.length === 0) return announce(state, say('notices.noKeysSelected'));
  return announce(withTimeline(state, { copied }), say('notices.copiedKeys', copied.length));
}

/** Pastes the copied keys from the playhead on. Those of handles that are gone, or beyond the end, are left out. */
function paste(state: EditorState, emit: Emit): EditorState {
  const { copied, time } = state.timeline;
  const clip = openClip(state);
  if (!clip || copied.length === 0) return announce(state, say('notices.noCopiedKeys'));
  const document = documentOf(state);
  const pasted = copied
    .map(({ handle, key }) => ({ handle, key: { ...key, time: roundedTime(time + key.time) } }))
    .filter(({ handle, key }) => key.time <= clip.duration && fits(key, handleById(document, handle)));
  const left = copied.length - pasted.length;
  const label = say('steps.pasteKeys', pasted.length);
  const next = withTimeline(
    editClip(state, label, (clip) => putKeys(clip, pasted), emit),
    { selected: pasted.map(refOf) },
  );
  return left > 0 ? inform(next, say('notices.keysLeftOut', left), emit) : next;
}

const fits = ({ posed }: Key, handle: Handle | undefined): boolean =>
  handle !== undefined && (!posed || keyCorners(posed).length === corners(handle).length);

/** Gives the selected keys to the handles on the other side, mirrored. */
function mirror(state: EditorState, emit: Emit): EditorState {
  const clip = openClip(state);
  const deformation = state.solution.shown?.deformation;
  const bounds = deformation?.restBounds();
  const chosen = clip ? keysAt(clip, state.timeline.selected) : [];
  if (!clip || !deformation || !bounds || chosen.length === 0)
    return announce(state, say('notices.noKeysSelected'));
  const bends = (rest: Vec) => deformation.bends(rest);
  let project = filedProject(state);
  const placed: PlacedKey[] = [];
  for (const { handle: id, key } of chosen) {
    const posed = posedByKey({ project, selection: [id] }, id, key);
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
  return withTimeline(next, { selected: placed.map(refOf) });
}

/** The document with a handle posed by a key. */
function posedByKey(document: Document, id: string, { posed, rotation, scale, depth }: Key): Document {
  return changeHandles(
    document,
    [id],
    (handle) =>
      ({
        ...handle,
        ...(posed ? { posed } : {}),
        ...(rotation === undefined ? {} : { rotation }),
        ...(scale === undefined ? {} : { scale }),
        ...(depth === undefined ? {} : { depth }),
      }) as Handle,
  );
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
  | 'keys-selected'
  | 'keys-dragged'
  | 'keys-drag-cancelled'
  | 'keys-stepped'
  | 'keys-eased'
  | 'keys-removed'
  | 'keys-copied'
  | 'keys-pasted'
  | 'keys-mirrored'
> = {
  'keys-selected': (state, { keys }, emit) => selectKeys(state, keys, emit),
  'keys-dragged': (state, { by, ended }, emit) => drag(state, by, ended, emit),
  'keys-drag-cancelled': (state) => withTimeline(state, { dragged: 0 }),
  'keys-stepped': (state, { frames }, emit) => move(state, frames / state.timeline.rate, 'step keys', emit),
  'keys-eased': (state, { ease }, emit) =>
    editClip(
      state,
      say(`steps.ease.${ease}`, state.timeline.selected.length),
      (clip) => easeKeys(clip, state.timeline.selected, ease),
      emit,
    ),
  'keys-removed': (state, _, emit) => {
    const { selected } = state.timeline;
    const label = say('steps.deleteKeys', selected.length);
    const next = editClip(state, label, (clip) => removeKeys(clip, selected), emit);
    return withTimeline(next, { selected: [] });
  },
  'keys-copied': copy,
  'keys-pasted': (state, _, emit) => paste(state, emit),
  'keys-mirrored': (state, _, emit) => mirror(state, emit),
};
