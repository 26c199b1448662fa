/**
 * The inputs of a solution, and the application of a newer pose to an older solution.
 *
 * Changes of the pose or the blend need no new solve. Other settings do, and so do handles that are placed or removed.
 * While a newer solve runs, the picture follows the handles of the last solution.
 */
import type { Handle, Project } from './project';

/** Two projects have the same key if and only if they have the same solution. */
export const solveKey = (project: Project): string =>
  `${settingsKey(project)} ${project.handles.map(handleKey).join(' ')}`;

/** The part of {@link solveKey} that is independent of the handles. */
export function settingsKey({ handles: _, pose, ...settings }: Project): string {
  const { blend: __, ...bending } = pose ?? {};
  return JSON.stringify([settings, bending]);
}

/** Whether the project has this handle, in any pose. */
export const solvesWith = (project: Project, handle: Handle): boolean =>
  project.handles.some((other) => solvesAlike(other, handle));

export const solvesAlike = (a: Handle, b: Handle): boolean => handleKey(a) === handleKey(b);

const handleKey = ({ id, kind, rest }: Handle): string => JSON.stringify([id, kind, rest]);

/** Replaces the handles of `solved` by those of `current` with the same id, kind and number of corners. */
export function followedHandles(solved: Project, current: Project): readonly Handle[] {
  const now = new Map(current.handles.map((handle) => [handle.id, handle]));
  return solved.handles.map((handle) => {
    const own = now.get(handle.id);
    return own && hasSameForm(own, handle) ? own : handle;
  });
}

/** Whether two handles have the same kind and number of corners. A point's place has the length 2. */
export const hasSameForm = (a: Handle, b: Handle): boolean =>
  a.kind === b.kind && a.posed.length === b.posed.length;
