/**
 * The shape in which a drag has left the picture, as the project stores it: the start of the way to a pose at rest.
 *
 * What is shown between drags depends on the project only. So a drag that ends elsewhere than the handles alone would
 * lead stores its shape.
 */
import type { Document } from './document';
import { isAtRest } from './handle';
import type { Handle, Project } from './project';

export type Shape = NonNullable<Project['shape']>;

/** The numbers of a sample in the project file. */
const SAMPLE_NUMBERS = 8;

/** Samples × 8, as the module takes them. */
export const shapeNumbers = (shape: Shape | undefined): Float64Array =>
  Float64Array.from(shape?.flat() ?? []);

/** Undefined without samples. */
export function shapeOf(numbers: Float64Array): Shape | undefined {
  if (numbers.length === 0) return undefined;
  return Array.from({ length: numbers.length / SAMPLE_NUMBERS }, (_, k) =>
    Array.from(numbers.subarray(SAMPLE_NUMBERS * k, SAMPLE_NUMBERS * (k + 1))),
  );
}

/** The project with a shape. With all handles at rest the picture rests too, and has none. */
export function withShape(project: Project, shape: Shape | undefined): Project {
  if (project.shape === shape) return project;
  const { shape: _, ...plain } = project;
  return shape && !project.handles.every(isAtRest) ? { ...plain, shape } : plain;
}

/** A changed document without the shape of the former one, if that has a handle in another pose. */
export function withoutStaleShape(before: Document, after: Document): Document {
  const { project } = after;
  if (!project.shape || project.shape !== before.project.shape) return after;
  const former = new Map(before.project.handles.map((handle) => [handle.id, handle]));
  const isMoved = (handle: Handle) => {
    const last = former.get(handle.id);
    return last !== undefined && poseKey(last) !== poseKey(handle);
  };
  return project.handles.some(isMoved) ? { ...after, project: withShape(project, undefined) } : after;
}

const poseKey = ({ posed, rotation, scale }: Handle): string => JSON.stringify([posed, rotation, scale]);
