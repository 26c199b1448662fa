/** The clip that the page plays. */
import { clipNamed, clipsOf } from '../document/clips';
import { hasEnded, type MediaTime, standsStill } from '../document/media_time';
import type { Clip } from '../document/project';
import { type EditorState, filedProject } from './state';

/** The clip that the page names, or else the first one. */
export function playedClip(state: EditorState): Clip | null {
  const project = filedProject(state);
  const { clip } = state.page;
  return (clip === null ? clipsOf(project)[0] : clipNamed(project, clip)) ?? null;
}

/** The seconds that a clip plays. One that alternates lasts there and back. */
export const playedDuration = ({ duration, loop }: Clip): number =>
  loop === 'alternate' ? 2 * duration : duration;

/** The time of a clip by the rules of media elements. */
export const mediaTime = ({ playback, page }: EditorState, clip: Clip): MediaTime => ({
  time: playback.time,
  rate: playback.rate,
  length: playedDuration(clip),
  loops: page.loop,
});

/** Whether playing has come to the end. */
export function hasPlayed(state: EditorState): boolean {
  const clip = playedClip(state);
  return state.playback.active && clip !== null && hasEnded(mediaTime(state, clip));
}

/** Whether the pose changes with the time. */
export function isPlaying(state: EditorState): boolean {
  const { playing, easing } = state.playback;
  const clip = playing ? playedClip(state) : null;
  return easing !== null || (clip !== null && !standsStill(mediaTime(state, clip)));
}
