/** The timeline in the state, the open clip, and edits of clips. */

import { clipNamed, clipsOf, lastTime } from '../../document/clips';
import { isSameMoment } from '../../document/document';
import * as history from '../../document/history';
import { atMoment, unposed } from '../../document/moment';
import { isPressing } from '../../tools/machine';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { playedClip } from '../played_clip';
import { documentOf, type EditorState, filedProject, selectionOf } from '../state';
import type { TimelineState } from '../timeline_state';
import { withHistory } from './document_slice';
import { edited } from './edited';
import { easedBack } from './playback';

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
 * Poses the handles as the open clip does at the playhead, or as the clip that the page plays. Without both they are as
 * in the file.
 *
 * Called after every event, so that the pose follows any change of the clip, the document or the solution.
 */
export function followClip(before: EditorState, emit: Emit): EditorState {
  const state = withKnownClip(before);
  const { easing, playing } = state.playback;
  const deformation = state.solution.shown?.deformation;
  const moment = deformation ? momentOf(state) : null;
  const present = documentOf(state).moment;
  if (moment ? isSameMoment(present, moment) : !present) return state;
  // A hand that is recorded, or takes a handle while a clip plays, leads its handles.
  const leads = state.timeline.recording !== null || (playing && isPressing(state.tools));
  const held = leads ? selectionOf(state) : [];
  const amended = history.amend(state.document.history, (document) => {
    if (!moment || !deformation) return unposed(document);
    const posed = atMoment(document, moment.clip, moment.time, deformation.posesAt, held);
    return easing && !leads ? easedBack(posed, easing) : posed;
  });
  return edited(withHistory(state, amended), 'pose', emit);
}

/** The clip and the time that pose the handles: of the timeline, or of a page that plays. */
function momentOf(state: EditorState): { readonly clip: string; readonly time: number } | null {
  const open = openClip(state);
  if (open) return { clip: open.name, time: state.timeline.time };
  const played = state.playback.active ? playedClip(state) : null;
  return played && { clip: played.name, time: state.playback.time };
}

/** Opens the first clip if the open one no longer exists, and keeps the playhead within the clip. */
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
