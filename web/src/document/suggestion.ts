/** Handles that the solver suggests for a picture. */
import type { Placement } from '../geometry/place';
import type { Vec } from '../geometry/vec';
import type { Document } from './document';
import { freeId } from './edits';
import { nameFault } from './names';
import type { PointHandle, Project } from './project';

/** Point handles beside those of a project. */
export interface Suggestion {
  /** From top to bottom. Their ids contain their position. */
  readonly handles: readonly { readonly id: string; readonly rest: Vec }[];
  /** Whether they follow an outline. Otherwise they are in even rows. */
  readonly outlined: boolean;
}

/**
 * Adds suggested handles at the end. The selection stays.
 *
 * @param handleAt A handle at a place of the original, posed as the picture there. Its id is replaced.
 */
export function withSuggested(
  document: Document,
  { handles }: Suggestion,
  handleAt: (project: Project, rest: Vec) => PointHandle,
): Document {
  let { project } = document;
  for (const { id, rest } of handles) {
    // A handle may have been renamed since the suggestion was requested.
    const free = nameFault(project, '', id) === null ? id : freeId(project);
    project = { ...project, handles: [...project.handles, { ...handleAt(project, rest), id: free }] };
  }
  return { ...document, project };
}

/** The placement of a point of an unbent picture. */
export const placedAtRest = (rest: Vec): Placement => ({ rest, posed: rest, rotation: 0, scale: 1 });
