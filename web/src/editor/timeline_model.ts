/** The timeline as people see it. */
import { isSameTime, type KeyRef, refersTo, trackOf } from '../document/clip_keys';
import { clipsOf } from '../document/clips';
import { nameWords } from '../document/names';
import type { Clip, Ease, Handle } from '../document/project';
import type { Words } from '../texts/wording';
import { keysInHand } from './keys_in_hand';
import { openClip } from './open_clip';
import { documentOf, type EditorState, filedProject, projectOf, selectionOf } from './state';
import type { Rate } from './timeline_state';

export interface TimelineModel {
  /** The names of all clips. */
  readonly clips: readonly string[];
  readonly clip: Clip | null;
  /** Seconds. */
  readonly time: number;
  readonly playing: boolean;
  readonly recording: boolean;
  /** A drag would be recorded. */
  readonly recordHeld: boolean;
  readonly renaming: boolean;
  readonly rate: Rate;
  /** CSS pixels a second; null fits the whole clip. */
  readonly zoom: number | null;
  readonly onion: boolean;
  readonly rows: readonly TimelineRow[];
  /** The selected key that arrow keys start from; null if keyboard commands apply to handles. */
  readonly lead: KeyRef | null;
  /** The ease of the selected keys, if they have the same. */
  readonly ease: Ease | null;
}

/** The keys of a handle. */
export interface TimelineRow {
  readonly handle: string;
  readonly name: Words;
  readonly selected: boolean;
  readonly keys: readonly TimelineKey[];
}

export interface TimelineKey {
  /** Seconds, where the clip has the key. */
  readonly time: number;
  /** Seconds, where it is shown: selected keys can be in a drag. */
  readonly shown: number;
  readonly ease: Ease;
  readonly selected: boolean;
}

/** Null while the timeline is closed. */
export function timelineModel(state: EditorState): TimelineModel | null {
  const { timeline } = state;
  if (!timeline.open || state.page.posable) return null;
  const clip = openClip(state);
  const rows = projectOf(state).handles.map((handle) => rowOf(state, clip, handle));
  const selected = rows.flatMap(({ keys }) => keys.filter((key) => key.selected));
  const [first] = selected;
  return {
    clips: clipsOf(filedProject(state)).map(({ name }) => name),
    clip,
    time: timeline.time,
    playing: timeline.playing,
    recording: timeline.recording !== null,
    recordHeld: timeline.recordHeld,
    renaming: timeline.renaming,
    rate: timeline.rate,
    zoom: timeline.zoom,
    onion: timeline.onion,
    rows,
    lead: keysInHand(state).at(-1) ?? null,
    ease: first && selected.every(({ ease }) => ease === first.ease) ? first.ease : null,
  };
}

function rowOf(state: EditorState, clip: Clip | null, handle: Handle): TimelineRow {
  const { selected, dragged } = state.timeline;
  const keys = (clip && trackOf(clip, handle.id))?.keys ?? [];
  return {
    handle: handle.id,
    name: nameWords(handle),
    selected: selectionOf(state).includes(handle.id),
    keys: keys.map(({ time, ease = 'smooth' }) => {
      const isSelected = refersTo(selected, handle.id, time);
      return { time, shown: isSelected ? time + dragged : time, ease, selected: isSelected };
    }),
  };
}

/** The times of the keys before and after the playhead: of the selected handles, or else of all. */
export function neighbouringTimes(state: EditorState): readonly number[] {
  const clip = openClip(state);
  const { selection } = documentOf(state);
  if (!clip) return [];
  const own = clip.tracks.filter(({ handle }) => selection.includes(handle));
  const times = (own.length > 0 ? own : clip.tracks).flatMap(({ keys }) => keys.map(({ time }) => time));
  const { time } = state.timeline;
  const before = times.filter((other) => other < time && !isSameTime(other, time));
  const after = times.filter((other) => other > time && !isSameTime(other, time));
  return [
    ...(before.length > 0 ? [Math.max(...before)] : []),
    ...(after.length > 0 ? [Math.min(...after)] : []),
  ];
}
