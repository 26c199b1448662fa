/**
 * What a solution depends on, and how a newer pose is put to an older solution.
 *
 * Posing never needs a new solve, nor does another blend; placing, removing and the other settings do. While a newer solve runs, the picture follows
 * the handles that the last solution knows.
 */
import type { Handle, Project } from './project';

/** Equal for two projects exactly when one solution serves both. */
export const solveKey = (project: Project): string =>
  `${settingsKey(project)} ${project.handles.map(handleKey).join(' ')}`;

/** The part of it that is about no handle. */
export function settingsKey({ handles: _, pose, ...settings }: Project): string {
  const { blend: __, ...bending } = pose ?? {};
  return JSON.stringify([settings, bending]);
}

/** Whether the project has this handle, posed in any way. */
export const solvesWith = (project: Project, handle: Handle): boolean =>
  project.handles.some((other) => solvesAlike(other, handle));

export const solvesAlike = (a: Handle, b: Handle): boolean => handleKey(a) === handleKey(b);

const handleKey = ({ id, kind, rest }: Handle): string => JSON.stringify([id, kind, rest]);

/** The handles of `solved`, in its order and at its rest places, posed as `current` has them. */
export function followedHandles(solved: Project, current: Project): readonly Handle[] {
  const now = new Map(current.handles.map((handle) => [handle.id, handle]));
  return solved.handles.map((handle) => {
    const { posed, kind, rotation, scale, depth } = now.get(handle.id) ?? handle;
    // Points hold two numbers and lines as many as they have corners: another length is another handle.
    const same = kind === handle.kind && posed.length === handle.posed.length;
    return same ? ({ ...handle, posed, rotation, scale, depth } as Handle) : handle;
  });
}
