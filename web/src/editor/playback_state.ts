/** A clip that the page plays, as a video plays. */
import type { Handle } from '../document/project';

export interface PlaybackState {
  /** The clip poses the handles. */
  readonly active: boolean;
  readonly playing: boolean;
  /** Seconds. */
  readonly time: number;
  /** Seconds of the clip a second; below 0 it plays backwards. */
  readonly rate: number;
  /** Handles that a person has let go ease back to the clip. */
  readonly easing: Easing | null;
}

export interface Easing {
  /** The handles as they were let go. */
  readonly from: readonly Handle[];
  /** Seconds that are left. */
  readonly left: number;
}

export const NOT_PLAYED: PlaybackState = { active: false, playing: false, time: 0, rate: 1, easing: null };
