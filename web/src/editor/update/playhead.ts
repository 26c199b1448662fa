/** The playhead of the timeline: opening, moving, playing. */

import { lastTime, timePlayed } from '../../document/clips';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { secondsText } from '../seconds';
import { documentOf, type EditorState } from '../state';
import { CLOSED_TIMELINE } from '../timeline_state';
import { refitView } from '../view';
import { stopPlaying, withTimeline } from './clip_slice';
import type { Handlers } from './handlers';
import { announce } from './notices';
import { endPlayback, tickPlayback } from './playback';
import { followRecording } from './recording';

export function openTimeline(state: EditorState, open: boolean, emit: Emit): EditorState {
  if (open === state.timeline.open || (open && (!state.picture || state.page.posable))) return state;
  if (open) emit({ type: 'focus-control', control: 'timeline' });
  const paused = open ? endPlayback(state, emit) : state;
  const next = withTimeline(stopPlaying(paused, emit), { open, selected: [], renaming: false });
  return refitView(announce(next, say(open ? 'spoken.timelineOpen' : 'spoken.timelineClosed')));
}

/** Closes the timeline of a picture that goes. */
export const closeTimeline = (before: EditorState, emit: Emit): EditorState => {
  const state = endPlayback(stopPlaying(before, emit), emit);
  const { rate, onion } = state.timeline;
  return { ...state, timeline: { ...CLOSED_TIMELINE, rate, onion } };
};

/** The nearest frame within the clip. */
function frameAt(state: EditorState, time: number): number {
  const clip = openClip(state);
  const { rate } = state.timeline;
  const last = clip ? lastTime(clip, rate) : 0;
  const frame = Math.round(time * rate) / rate;
  return Math.min(Math.max(frame, 0), last);
}

/** Moves the playhead to a frame. That ends playing. */
export const movePlayhead = (state: EditorState, time: number, emit: Emit): EditorState => {
  const stopped = stopPlaying(state, emit);
  return withTimeline(stopped, { time: frameAt(stopped, time) });
};

function stepPlayhead(state: EditorState, frames: number, emit: Emit): EditorState {
  const { time, rate } = state.timeline;
  const next = movePlayhead(state, time + frames / rate, emit);
  return announce(next, say('spoken.time', secondsText(next.timeline.time)));
}

export function play(state: EditorState, on: boolean, emit: Emit): EditorState {
  if (!on) return movePlayhead(state, state.timeline.time, emit);
  const clip = openClip(state);
  if (!clip || state.timeline.playing) return state;
  emit({ type: 'run-clock', on: true });
  const { time } = state.timeline;
  // A clip that has ended begins again.
  const played = clip.loop === 'none' && time >= clip.duration ? 0 : time;
  return withTimeline(state, { playing: true, played });
}

function tick(state: EditorState, seconds: number, emit: Emit): EditorState {
  if (state.timeline.recording) return followRecording(state, seconds, emit);
  if (state.playback.playing) return tickPlayback(state, seconds, emit);
  const clip = openClip(state);
  if (!state.timeline.playing || !clip) return stopPlaying(state, emit);
  const played = state.timeline.played + seconds;
  const time = timePlayed(clip, played);
  return time === null ? movePlayhead(state, clip.duration, emit) : withTimeline(state, { played, time });
}

/** Moves the playhead to where it was at the state that undo or redo has returned to. */
export function returnToMoment(state: EditorState): EditorState {
  const { moment } = documentOf(state);
  if (!moment || !state.timeline.open) return state;
  return withTimeline(state, { clip: moment.clip, time: moment.time });
}

export const playheadHandlers: Handlers<
  'timeline-opened' | 'playhead-moved' | 'playhead-stepped' | 'clock-ticked'
> = {
  'timeline-opened': (state, { open }, emit) => openTimeline(state, open, emit),
  'playhead-moved': (state, { time }, emit) => movePlayhead(state, time, emit),
  'playhead-stepped': (state, { frames }, emit) => stepPlayhead(state, frames, emit),
  'clock-ticked': (state, { seconds }, emit) => tick(state, seconds, emit),
};
