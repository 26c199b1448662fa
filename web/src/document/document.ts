/** The edited document: the project and the selection. */
import { DETAILS } from './bending';
import { domainOf } from './domain';
import type { Handle, ImageRef, Project } from './project';

export interface Document {
  readonly project: Project;
  /** Ids of selected handles, in the order they were selected. */
  readonly selection: readonly string[];
}

export const openDocument = (project: Project): Document => ({ project, selection: [] });

/**
 * Returns a project without handles for a newly opened picture. The editor's defaults are explicit in it. The picture
 * bends rigidly, so that dragged parts keep their shape and distant parts stay.
 *
 * @param threshold the alpha threshold of a picture with transparency, `null` for an opaque picture.
 */
export const newProject = (image: ImageRef, threshold: number | null): Project => ({
  format: 'c2warp/1',
  image,
  domain: domainOf(threshold),
  samples: 10000,
  weighting: { shape_factor: 1, degree: 5, filling: 'line', support: 'smooth' },
  pose: { mode: 'rigid', blend: 'linear', density: DETAILS.medium },
  fix_boundary: false,
  edges: true,
  loose_parts: 'stay',
  handles: [],
});

/** Whether two documents have equal projects. The selection does not count. */
export const isSameWork = (a: Document, b: Document): boolean =>
  a.project === b.project || JSON.stringify(a.project) === JSON.stringify(b.project);

export const handleById = (document: Document, id: string): Handle | undefined =>
  document.project.handles.find((handle) => handle.id === id);

export const selectedHandles = (document: Document): readonly Handle[] =>
  document.project.handles.filter((handle) => document.selection.includes(handle.id));
