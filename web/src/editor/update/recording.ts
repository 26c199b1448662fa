/** Recording: while R is held, the motion of a drag becomes keys. */

import { putKeys, removeKeys, roundedTime, trackOf } from '../../document/clip_keys';
import { changeClip, DURATIONS, lastKeyTime } from '../../document/clips';
import { fileProject, selectedHandles } from '../../document/document';
import { depthOf } from '../../document/handle';
import * as history from '../../document/history';
import { withDepth, withFileProject } from '../../document/moment';
import type { Clip, Handle } from '../../document/project';
import { thinned } from '../../document/thinning';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { openClip } from '../open_clip';
import { handleWords } from '../selection_words';
import { documentOf, type EditorState } from '../state';
import type { Recording } from '../timeline_state';
import { stopPlaying, withTimeline } from './clip_slice';
import { isFreeIn, withHistory } from './document_slice';
import type { Handlers } from './handlers';

/** Seconds in which a clip that repeats goes from the end of a motion back to its beginning. */
const RETURN = 0.3;

/** Begins to record the drag that has begun, if R is held. */
export function beginRecording(state: EditorState, emit: Emit): EditorState {
  const { recordHeld, time } = state.timeline;
  const { open } = state.document.history;
  if (!recordHeld || !openClip(state) || !open) return state;
  emit({ type: 'run-clock', on: true });
  const label = say('steps.record', handleWords(selectedHandles(documentOf(state))));
  const named = withHistory(state, { ...state.document.history, open: { ...open, label } });
  return recordMove(withTimeline(named, { recording: { from: time, samples: [] }, playing: false }));
}

/** A hand that does not move for so long rests. Otherwise it is on its way to the next place. Seconds. */
const REST = 0.12;
/** Before the end of a rest, in seconds. */
const FRAME = 1 / 60;

/** Notes the pose of the held handles at this time. */
export function recordMove(state: EditorState): EditorState {
  const { recording, time } = state.timeline;
  // It begins with the pose before the drag.
  if (!recording || (recording.samples.length > 0 && time <= recording.from)) return state;
  const handles = selectedHandles(documentOf(state));
  const earlier = recording.samples.filter((sample) => sample.time < time);
  const last = earlier.at(-1);
  const rested = last && time - last.time > REST ? [{ ...last, time: time - FRAME }] : [];
  const samples = [...earlier, ...rested, { time, handles }];
  return withTimeline(state, { recording: { ...recording, samples } });
}

/** Makes keys of the recorded motion, and returns to its beginning. */
export function endRecording(before: EditorState, emit: Emit): EditorState {
  const moved = recordMove(before);
  const { recording, time } = moved.timeline;
  if (!recording) return before;
  const state = dropRecording(moved, emit);
  const clip = openClip(state);
  const posesAt = state.solution.shown?.deformation.posesAt;
  if (!clip || !posesAt || time <= recording.from) return state;
  const document = documentOf(state);
  const base = fileProject(document);
  const isFree = isFreeIn(state, document);
  const recorded = changeClip(base, clip.name, (clip) =>
    tracksOf(recording).reduce(
      (next, samples) => {
        const [{ handle }] = samples;
        const keys = thinned(samples, posesAt);
        const moved = putKeys(
          withoutBetween(next, handle.id, recording.from, time),
          keys.map((key) => ({ handle: handle.id, key })),
        );
        const last = samples.at(-1)?.handle ?? handle;
        const own = base.handles.find(({ id }) => id === handle.id) ?? handle;
        return depthOf(last) === depthOf(handle)
          ? moved
          : withDepth(moved, last, own, recording.from, isFree);
      },
      lengthened(clip, time),
    ),
  );
  return withHistory(state, history.update(state.document.history, withFileProject(document, recorded)));
}

type Samples = readonly [PosedAt, ...PosedAt[]];
interface PosedAt {
  readonly time: number;
  readonly handle: Handle;
}

/** The recorded motion of each handle. */
function tracksOf({ samples }: Recording): readonly Samples[] {
  const byHandle = new Map<string, PosedAt[]>();
  for (const { time, handles } of samples)
    for (const handle of handles) {
      const own = byHandle.get(handle.id) ?? [];
      own.push({ time, handle });
      byHandle.set(handle.id, own);
    }
  return [...byHandle.values()].filter((own): own is [PosedAt, ...PosedAt[]] => own.length > 0);
}

/** The clip, long enough for a motion that ends at a time. */
function lengthened(clip: Clip, end: number): Clip {
  if (end <= clip.duration) return clip;
  const loops = clip.loop !== 'none' && clip.loop !== 'alternate';
  return { ...clip, duration: roundedTime(end + (loops ? RETURN : 0)) };
}

function withoutBetween(clip: Clip, handle: string, from: number, to: number): Clip {
  const inside = (trackOf(clip, handle)?.keys ?? []).filter(({ time }) => time >= from && time <= to);
  return removeKeys(
    clip,
    inside.map(({ time }) => ({ handle, time })),
  );
}

export function dropRecording(state: EditorState, emit: Emit): EditorState {
  const { recording } = state.timeline;
  if (!recording) return state;
  emit({ type: 'run-clock', on: false });
  return withTimeline(state, { recording: null, time: recording.from });
}

/**
 * Lets the time of a recording pass. It ends with the clip if that has keys of other handles, which the motion is to
 * fit. Otherwise the clip becomes as long as the motion.
 */
export function followRecording(state: EditorState, seconds: number, emit: Emit): EditorState {
  const clip = openClip(state);
  const { recording, time } = state.timeline;
  if (!clip || !recording) return dropRecording(state, emit);
  const held = selectedHandles(documentOf(state)).map(({ id }) => id);
  const others = { ...clip, tracks: clip.tracks.filter(({ handle }) => !held.includes(handle)) };
  const end = lastKeyTime(others) > 0 ? clip.duration : DURATIONS.most - RETURN;
  const next = Math.min(time + seconds, end);
  return next > time ? withTimeline(state, { time: next }) : state;
}

export const recordingHandlers: Handlers<'record-held'> = {
  'record-held': (state, { held }, emit) => {
    if (held === state.timeline.recordHeld) return state;
    return withTimeline(held ? stopPlaying(state, emit) : state, { recordHeld: held });
  },
};
