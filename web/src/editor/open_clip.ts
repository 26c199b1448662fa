/** The clip of the open timeline. */
import { clipNamed } from '../document/clips';
import { fileProject } from '../document/document';
import type { Clip, Project } from '../document/project';
import { documentOf, type EditorState } from './state';

/** The project as its file holds it, with all clips. */
export const filedProject = (state: EditorState): Project => fileProject(documentOf(state));

/** The clip of the open timeline; null without one. */
export function openClip(state: EditorState): Clip | null {
  const { open, clip } = state.timeline;
  return (open && clip !== null && clipNamed(filedProject(state), clip)) || null;
}
