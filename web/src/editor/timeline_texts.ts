/** Texts of the timeline. */
import type { ClipPreset } from '../document/clip_presets';
import type { Ease, Loop } from '../document/project';

export const PRESET_NAMES: Readonly<Record<ClipPreset, string>> = {
  sway: 'Sway',
  breathe: 'Breathe',
  wave: 'Wave',
};

export const PRESET_TIPS: Readonly<Record<ClipPreset, string>> = {
  sway: 'A clip that bends to both sides',
  breathe: 'A clip that grows and shrinks a little',
  wave: 'A clip in which the selected handles wave',
};

export const LOOP_NAMES: Readonly<Record<Loop, string>> = {
  repeat: 'Repeat',
  alternate: 'Back and forth',
  none: 'Once',
};

export const EASE_NAMES: Readonly<Record<Ease, string>> = {
  smooth: 'Smooth',
  linear: 'Steady',
  hold: 'Hold',
};

export const NO_CLIP_OPEN = 'No clip is open.';
export const NO_KEYS_SELECTED = 'No keys are selected.';
export const NO_COPIED_KEYS = 'No keys have been copied.';

/** Seconds with two digits after the point. */
export const secondsText = (seconds: number): string => `${seconds.toFixed(2)} s`;

export const countedKeys = (count: number): string => `${count} ${count === 1 ? 'key' : 'keys'}`;

export const keysLeftOutText = (count: number): string =>
  `${countedKeys(count)} ${count === 1 ? 'was' : 'were'} left out: beyond the end of the clip, or of a handle that is not here.`;
