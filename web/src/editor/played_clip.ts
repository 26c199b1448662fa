/** The clip that the page plays. */
import { clipNamed, clipsOf } from '../document/clips';
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

/** Whether playing has come to the end. */
export function hasEnded(state: EditorState): boolean {
  const clip = playedClip(state);
  const { playing, time, active } = state.playback;
  return active && !playing && clip !== null && !state.page.loop && time >= playedDuration(clip);
}
