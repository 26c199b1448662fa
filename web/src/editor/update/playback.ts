/** Playing a clip for the page, with the words and events of media elements. */
import { type Document, handleById, selectedHandles } from '../../document/document';
import { corners, isLine, scaleOf } from '../../document/handle';
import * as history from '../../document/history';
import { advanced, hasEnded, standsStill } from '../../document/media_time';
import type { Handle } from '../../document/project';
import { lerp, type Vec } from '../../geometry/vec';
import type { Emit } from '../effects';
import { type Easing, NOT_PLAYED, type PlaybackState } from '../playback_state';
import { isPlaying, mediaTime, playedClip, playedDuration } from '../played_clip';
import { documentOf, type EditorState } from '../state';
import { withHistory } from './document_slice';

/** Seconds in which a handle that was let go returns to the clip. */
const EASE = 0.5;
/** Seconds between two events `timeupdate`, as browsers have them. */
const UPDATES = 0.25;

const withPlayback = (state: EditorState, change: Partial<PlaybackState>): EditorState => ({
  ...state,
  playback: { ...state.playback, ...change },
});

type MediaEventType = 'play' | 'pause' | 'timeupdate' | 'ended';
const emitEvents = (emit: Emit, ...types: readonly MediaEventType[]): void => {
  for (const type of types) emit({ type: 'notify-page', notification: { type } });
};

/** Runs the clock while the pose changes with the time. Called after every event. */
export function followPlayback(before: EditorState, after: EditorState, emit: Emit): EditorState {
  const on = isPlaying(after);
  if (on !== isPlaying(before)) emit({ type: 'run-clock', on });
  return after;
}

/** Plays on, from the beginning if the clip has ended. */
export function playForPage(state: EditorState, emit: Emit): EditorState {
  const clip = playedClip(state);
  if (!clip || state.playback.playing) return state;
  emitEvents(emit, 'play');
  const time = hasEnded(mediaTime(state, clip)) ? 0 : state.playback.time;
  return withPlayback(state, { active: true, playing: true, time });
}

export function pauseForPage(state: EditorState, emit: Emit): EditorState {
  if (!state.playback.playing) return state;
  emitEvents(emit, 'timeupdate', 'pause');
  return withPlayback(state, { playing: false, easing: null });
}

/** Shows another time of the clip. */
export function seekForPage(state: EditorState, time: number, emit: Emit): EditorState {
  const clip = playedClip(state);
  if (!clip) return state;
  const sought = withPlayback(state, {
    active: true,
    time: Math.min(Math.max(time, 0), playedDuration(clip)),
  });
  if (hasEnded(mediaTime(sought, clip))) return endedForPage(sought, emit);
  emitEvents(emit, 'timeupdate');
  return sought;
}

function endedForPage(state: EditorState, emit: Emit): EditorState {
  if (!state.playback.playing) emitEvents(emit, 'timeupdate');
  const paused = pauseForPage(state, emit);
  emitEvents(emit, 'ended');
  return paused;
}

export const rateForPage = (state: EditorState, rate: number): EditorState => withPlayback(state, { rate });

/** Leaves the clip: its time is the beginning again. */
export function endPlayback(state: EditorState, emit: Emit): EditorState {
  const { playback } = pauseForPage(state, emit);
  return playback.active ? withPlayback(state, { ...NOT_PLAYED, rate: playback.rate }) : state;
}

export function tickPlayback(before: EditorState, seconds: number, emit: Emit): EditorState {
  const state = easedOn(before, seconds);
  const clip = playedClip(state);
  if (!clip) return pauseForPage(state, emit);
  if (standsStill(mediaTime(state, clip))) return state;
  const time = advanced(mediaTime(state, clip), seconds);
  const next = withPlayback(state, { time });
  if (hasEnded(mediaTime(next, clip))) return endedForPage(next, emit);
  const isDue = Math.floor(time / UPDATES) !== Math.floor(state.playback.time / UPDATES);
  if (isDue || standsStill(mediaTime(next, clip))) emitEvents(emit, 'timeupdate');
  return next;
}

function easedOn(state: EditorState, seconds: number): EditorState {
  const { easing } = state.playback;
  if (!easing) return state;
  const left = easing.left - seconds;
  return withPlayback(state, { easing: left > 0 ? { ...easing, left } : null });
}

/** Ends a drag during playing. It is no step: its handles ease back to the clip. */
export function letGo(state: EditorState): EditorState {
  const from = selectedHandles(documentOf(state));
  const bailed = withHistory(state, history.bail(state.document.history));
  return withPlayback(bailed, { easing: { from, left: EASE } });
}

/** A person's step ends playing. The pose on show is the document's own from then on. */
export function ownPose(state: EditorState, emit: Emit): EditorState {
  return state.playback.active ? withPlayback(pauseForPage(state, emit), { active: false }) : state;
}

/** The document with its handles on their way back to the clip. */
export function easedBack(document: Document, { from, left }: Easing): Document {
  const share = left / EASE;
  const weight = share * share * (3 - 2 * share);
  const eased = (handle: Handle): Handle => {
    const start = from.find(({ id }) => id === handle.id);
    return start && handleById(document, start.id) ? between(handle, start, weight) : handle;
  };
  return { ...document, project: { ...document.project, handles: document.project.handles.map(eased) } };
}

function between(handle: Handle, start: Handle, weight: number): Handle {
  const places = corners(start);
  const posed = corners(handle).map((corner, k): Vec => lerp(corner, places[k] ?? corner, weight));
  const [a = 0, b = 0] = [handle.rotation, start.rotation];
  const turned = typeof a === 'number' && typeof b === 'number' ? { rotation: a + weight * (b - a) } : {};
  const scale = scaleOf(handle) + weight * (scaleOf(start) - scaleOf(handle));
  return isLine(handle)
    ? { ...handle, ...turned, scale, posed }
    : { ...handle, ...turned, scale, posed: posed[0] ?? handle.posed };
}
