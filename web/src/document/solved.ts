/**
 * What a solution depends on, and how a newer pose is applied to an older solution.
 *
 * Posing never needs a new solve, nor does a change of blend; placing or removing handles and the other settings do.
 * While a newer solve runs, the picture follows the handles of the last solution.
 */
import type { Handle, Project } from './project';

/** A key that two projects share exactly when one solution serves both. */
export const solveKey = (project: Project): string =>
  `${settingsKey(project)} ${project.handles.map(handleKey).join(' ')}`;

/** The part of {@link solveKey} that depends on no handle. */
export function settingsKey({ handles: _, pose, ...settings }: Project): string {
  const { blend: __, ...bending } = pose ?? {};
  return JSON.stringify([settings, bending]);
}

/** Whether the project has this handle, in any pose. */
export const solvesWith = (project: Project, handle: Handle): boolean =>
  project.handles.some((other) => solvesAlike(other, handle));

export const solvesAlike = (a: Handle, b: Handle): boolean => handleKey(a) === handleKey(b);

const handleKey = ({ id, kind, rest }: Handle): string => JSON.stringify([id, kind, rest]);

/** For each handle of `solved` that of `current`; the solved one if `current` lacks it or has it with other corners. */
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
