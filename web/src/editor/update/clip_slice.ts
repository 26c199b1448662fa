/** The timeline in the state, the open clip, and edits of clips. */

import { clipNamed, clipsOf, lastTime } from '../../document/clips';
import { isSameMoment } from '../../document/document';
import * as history from '../../document/history';
import { atMoment, unposed } from '../../document/moment';
import type { Emit } from '../effects';
import { filedProject, openClip } from '../open_clip';
import { documentOf, type EditorState, selectionOf } from '../state';
import type { TimelineState } from '../timeline_state';
import { withHistory } from './document_slice';
import { edited } from './edited';

export const withTimeline = (state: EditorState, change: Partial<TimelineState>): EditorState => ({
  ...state,
  timeline: { ...state.timeline, ...change },
});

export function stopPlaying(state: EditorState, emit: Emit): EditorState {
  if (!state.timeline.playing) return state;
  emit({ type: 'run-clock', on: false });
  return withTimeline(state, { playing: false });
}

/**
 * Poses the handles as the open clip does at the playhead, and as they are without it once the timeline is closed.
 * Called after every event: whatever changes the clip, the document or the solution, the pose follows.
 */
export function followClip(before: EditorState, emit: Emit): EditorState {
  const state = withKnownClip(before);
  const { clip, time, recording } = state.timeline;
  const deformation = state.solution.shown?.deformation;
  const moment = openClip(state) && clip !== null && deformation ? { clip, time } : null;
  const present = documentOf(state).moment;
  if (moment ? isSameMoment(present, moment) : !present) return state;
  // A hand that is being recorded leads its handles.
  const held = recording ? selectionOf(state) : [];
  const amended = history.amend(state.document.history, (document) =>
    moment && deformation
      ? atMoment(document, moment.clip, moment.time, deformation.posesAt, held)
      : unposed(document),
  );
  return edited(withHistory(state, amended), 'pose', emit);
}

/** Opens the first clip in place of one that is no longer there, and keeps the playhead within the clip. */
function withKnownClip(state: EditorState): EditorState {
  if (!state.timeline.open) return state;
  const project = filedProject(state);
  const clip = clipNamed(project, state.timeline.clip ?? '') ?? clipsOf(project)[0];
  if (!clip) return state.timeline.clip === null ? state : withTimeline(state, NO_CLIP);
  const { rate, playing, recording } = state.timeline;
  const time =
    playing || recording ? state.timeline.time : Math.min(state.timeline.time, lastTime(clip, rate));
  if (clip.name === state.timeline.clip && time === state.timeline.time) return state;
  return withTimeline(state, {
    ...(clip.name === state.timeline.clip ? {} : NO_CLIP),
    clip: clip.name,
    time,
  });
}

const NO_CLIP = { clip: null, time: 0, playing: false, played: 0, selected: [] } as const;
