/** What is edited: the project and which of its handles are selected. */
import { DETAILS } from './bending';
import type { Handle, ImageRef, Project } from './project';

export interface Document {
  readonly project: Project;
  /** Ids of selected handles, in the order they were selected. */
  readonly selection: readonly string[];
}

export const openDocument = (project: Project): Document => ({ project, selection: [] });

/**
 * A project without handles for a newly opened picture, with the editor's choices written out: it bends rigidly, so that
 * what is dragged keeps its shape and what is far from it stays.
 *
 * @param threshold the alpha from which on a picture with transparency is warped, `null` for one that is opaque.
 */
export const newProject = (image: ImageRef, threshold: number | null): Project => ({
  format: 'c2warp/1',
  image,
  domain: threshold === null ? { kind: 'image' } : { kind: 'alpha', threshold },
  samples: 10000,
  weighting: { shape_factor: 1, degree: 5, filling: 'line', support: 'smooth' },
  pose: { mode: 'rigid', blend: 'linear', density: DETAILS.medium },
  fix_boundary: false,
  handles: [],
});

/** What is selected is no part of the work. */
export const isSameWork = (a: Document, b: Document): boolean =>
  a.project === b.project || JSON.stringify(a.project) === JSON.stringify(b.project);

export const handleById = (document: Document, id: string): Handle | undefined =>
  document.project.handles.find((handle) => handle.id === id);

export const selectedHandles = (document: Document): readonly Handle[] =>
  document.project.handles.filter((handle) => document.selection.includes(handle.id));
