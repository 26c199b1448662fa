/** Adding, naming, duplicating and removing clips, and their settings. */

import { type ClipPreset, presetClip } from '../../document/clip_presets';
import {
  addClip,
  changeClip,
  clipNamed,
  freeClipName,
  newClip,
  removeClip,
  withDuration,
} from '../../document/clips';
import { withFileProject } from '../../document/moment';
import { tidyName } from '../../document/names';
import type { Clip, Project } from '../../document/project';
import { say, type Wording } from '../../texts/wording';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { mayEdit } from '../permissions';
import { secondsText } from '../seconds';
import { documentOf, type EditorState, filedProject, selectionOf } from '../state';
import { ZOOM } from '../timeline_state';
import { withTimeline } from './clip_slice';
import { changedNumber } from './edits';
import type { Handlers } from './handlers';
import { announce, inform } from './notices';
import { movePlayhead, openTimeline, play } from './playhead';
import { commitStep } from './steps';

/** Changes the project of the file, as one step. */
export function editProject(
  state: EditorState,
  label: Wording,
  change: (project: Project) => Project,
  emit: Emit,
  key: string | null = null,
): EditorState {
  const project = filedProject(state);
  const changed = change(project);
  if (!mayEdit(state) || JSON.stringify(changed) === JSON.stringify(project)) return state;
  const next = commitStep(state, label, withFileProject(documentOf(state), changed), emit, key);
  return announce(next, label);
}

/** Changes the open clip, as one step. */
export function editClip(
  state: EditorState,
  label: Wording,
  change: (clip: Clip) => Clip,
  emit: Emit,
  key: string | null = null,
): EditorState {
  const clip = openClip(state);
  return clip
    ? editProject(state, label, (project) => changeClip(project, clip.name, change), emit, key)
    : state;
}

/** Opens another clip, at its beginning. */
const choose = (state: EditorState, name: string, emit: Emit): EditorState =>
  withTimeline(movePlayhead(state, 0, emit), { clip: name, time: 0, selected: [], zoom: null });

function add(before: EditorState, preset: ClipPreset | null, emit: Emit): EditorState {
  const state = openTimeline(before, true, emit);
  const project = filedProject(state);
  if (preset && project.handles.length === 0) return state;
  const clip = preset
    ? presetClip(project, preset, selectionOf(state))
    : newClip(freeClipName(project, 'clip'));
  const label = preset ? say(`steps.addPreset.${preset}`) : say('steps.addClip', clip.name);
  const added = choose(
    editProject(state, label, (project) => addClip(project, clip), emit),
    clip.name,
    emit,
  );
  // A person chose it: a preset plays at once.
  return preset ? play(added, true, emit) : added;
}

function named(before: EditorState, typed: string, emit: Emit): EditorState {
  const state = withTimeline(before, { renaming: false });
  const clip = openClip(state);
  const name = tidyName(typed);
  if (!before.timeline.renaming || !clip || name === '' || [typed, name].includes(clip.name)) return state;
  if (clipNamed(filedProject(state), name)) return inform(state, say('notices.clipNameTaken', name), emit);
  const renamed = editClip(
    state,
    say('steps.renameClip', clip.name, name),
    (clip) => ({ ...clip, name }),
    emit,
  );
  return withTimeline(renamed, { clip: name });
}

function duplicate(state: EditorState, emit: Emit): EditorState {
  const clip = openClip(state);
  if (!clip) return state;
  const name = freeClipName(filedProject(state), `${clip.name} copy`);
  const label = say('steps.duplicateClip', clip.name);
  return choose(
    editProject(state, label, (project) => addClip(project, { ...clip, name }), emit),
    name,
    emit,
  );
}

function remove(state: EditorState, emit: Emit): EditorState {
  const clip = openClip(state);
  if (!clip) return state;
  const stopped = movePlayhead(state, 0, emit);
  return editProject(
    stopped,
    say('steps.deleteClip', clip.name),
    (project) => removeClip(project, clip.name),
    emit,
  );
}

function zoom(state: EditorState, notches: number): EditorState {
  if (notches === 0) return withTimeline(state, { zoom: null });
  const now = state.timeline.zoom ?? ZOOM.usual;
  const next = Math.min(Math.max(now * ZOOM.step ** notches, ZOOM.least), ZOOM.most);
  return withTimeline(state, { zoom: next });
}

export const clipHandlers: Handlers<
  | 'clip-added'
  | 'clip-chosen'
  | 'clip-renaming-switched'
  | 'clip-named'
  | 'clip-duplicated'
  | 'clip-removed'
  | 'clip-loop-chosen'
  | 'clip-duration-set'
  | 'frame-rate-chosen'
  | 'timeline-zoomed'
  | 'onion-switched'
> = {
  'clip-added': (state, { preset }, emit) => (mayEdit(state) ? add(state, preset, emit) : state),
  'clip-chosen': (state, { name }, emit) => choose(state, name, emit),
  'clip-renaming-switched': (state, { on }, emit) => {
    if (on) emit({ type: 'focus-control', control: 'clip-name' });
    return withTimeline(state, { renaming: on && openClip(state) !== null });
  },
  'clip-named': (state, { name }, emit) => named(state, name, emit),
  'clip-duplicated': (state, _, emit) => duplicate(state, emit),
  'clip-removed': (state, _, emit) => remove(state, emit),
  'clip-loop-chosen': (state, { loop }, emit) =>
    editClip(state, say(`steps.loops.${loop}`), (clip) => ({ ...clip, loop }), emit),
  'clip-duration-set': (state, { change }, emit) => {
    const seconds = changedNumber(change, openClip(state)?.duration ?? 0);
    const set = (clip: Clip) => withDuration(clip, seconds);
    const clip = openClip(state);
    const label = say('steps.setDuration', secondsText(clip ? set(clip).duration : seconds));
    return editClip(state, label, set, emit, 'clip duration');
  },
  'frame-rate-chosen': (state, { rate }) => withTimeline(state, { rate }),
  'timeline-zoomed': (state, { notches }) => zoom(state, notches),
  'onion-switched': (state, { on }) => withTimeline(state, { onion: on }),
};
