/** The clip of the open timeline. */
import { clipNamed } from '../document/clips';
import type { Clip } from '../document/project';
import { type EditorState, filedProject } from './state';

/** The clip of the open timeline; null without one. */
export function openClip(state: EditorState): Clip | null {
  const { open, clip } = state.timeline;
  return (open && clip !== null && clipNamed(filedProject(state), clip)) || null;
}
