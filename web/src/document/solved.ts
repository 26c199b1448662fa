/**
 * What a solution depends on, and how a newer pose is put to an older solution.
 *
 * Posing never needs a new solve, nor does another blend; placing, removing and the other settings do. While a newer solve runs, the picture follows
 * the handles that the last solution knows.
 */
import type { Handle, Project } from './project';

/** Equal for two projects exactly when one solution serves both. */
export function solveKey(project: Project): string {
  const { handles, pose, ...settings } = project;
  const { blend: _, ...bending } = pose ?? {};
  return JSON.stringify([settings, bending, handles.map(({ id, kind, rest }) => [id, kind, rest])]);
}

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
