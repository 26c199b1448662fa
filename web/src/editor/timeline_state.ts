/** The timeline: the clip that is open, playing, the selected keys, and how it is shown. */
import type { KeyRef, PlacedKey } from '../document/clip_keys';
import type { Handle } from '../document/project';

/** Frames a second that the playhead and keys snap to. */
export const RATES = [12, 24, 30, 60] as const;
export type Rate = (typeof RATES)[number];

/** CSS pixels a second. */
export const ZOOM = { least: 20, usual: 200, most: 1600, step: 1.5 } as const;

export interface TimelineState {
  readonly open: boolean;
  /** The clip that poses the handles while the timeline is open. Null without clips. */
  readonly clip: string | null;
  /** Seconds from the beginning of the clip. The document follows, once the picture is solved. */
  readonly time: number;
  readonly playing: boolean;
  /** Seconds that have been played: a clip that alternates runs back. */
  readonly played: number;
  readonly rate: Rate;
  /** CSS pixels a second; null fits the whole clip. */
  readonly zoom: number | null;
  readonly selected: readonly KeyRef[];
  /** Seconds that the selected keys are being dragged by. */
  readonly dragged: number;
  /** Keys to be pasted, the first one at time 0. */
  readonly copied: readonly PlacedKey[];
  /** The name of the open clip is being typed. */
  readonly renaming: boolean;
  /** R is held: a drag is recorded. */
  readonly recordHeld: boolean;
  readonly recording: Recording | null;
  /** The poses of neighbouring keys are shown faintly. */
  readonly onion: boolean;
}

/** A motion that is being recorded. */
export interface Recording {
  /** The time at which it began. */
  readonly from: number;
  readonly samples: readonly Sample[];
}

/** The held handles as they were posed at a time. */
export interface Sample {
  readonly time: number;
  readonly handles: readonly Handle[];
}

export const CLOSED_TIMELINE: TimelineState = {
  open: false,
  clip: null,
  time: 0,
  playing: false,
  played: 0,
  rate: 30,
  zoom: null,
  selected: [],
  dragged: 0,
  copied: [],
  renaming: false,
  recordHeld: false,
  recording: null,
  onion: false,
};
