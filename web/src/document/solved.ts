/**
 * The inputs of a solution, and the application of a newer pose to an older solution.
 *
 * Names of handles change no solution: handles of a kind at the same rest position are the same handle.
 *
 * Changes of the pose, the shape, the clips, the blend, the edges, the stiffness or the displacement need no new
 * solve. Other settings do, and so do handles that are placed or removed. While a newer solve runs, the picture
 * follows the handles of the last solution.
 */
import type { Clip, Handle, Project } from './project';

/** Two projects have the same key if and only if they have the same solution. */
export const solveKey = (project: Project): string =>
  `${settingsKey(project)} ${project.handles.map(placeKey).join(' ')}`;

/** The part of {@link solveKey} that is independent of the handles. */
export function settingsKey(project: Project): string {
  const {
    handles: _,
    edges: __,
    clips: ___,
    stiffness: ____,
    displacement: _____,
    shape: ______,
    pose,
    ...settings
  } = project;
  const { blend: _______, ...bending } = pose ?? {};
  return JSON.stringify([settings, bending]);
}

/** Whether the project has this handle, in any pose. */
export const solvesWith = (project: Project, handle: Handle): boolean =>
  project.handles.some((other) => solvesAlike(other, handle));

export const solvesAlike = (a: Handle, b: Handle): boolean => handleKey(a) === handleKey(b);

const handleKey = (handle: Handle): string => JSON.stringify([handle.id, placeKey(handle)]);

/** The keys of rest positions, which poses share: every frame of a drag asks for them. */
const placeKeys = new WeakMap<Handle['rest'], string>();

/** Two handles have the same key if and only if they have the same kind and rest position. */
export function placeKey({ kind, rest }: Handle): string {
  const key = placeKeys.get(rest) ?? JSON.stringify(rest);
  placeKeys.set(rest, key);
  return `${kind} ${key}`;
}

/**
 * Replaces the handles of `solved` by those of `current` at the same rest position, or else with the same id, kind and
 * number of corners.
 */
export function followedHandles(solved: Project, current: Project): readonly Handle[] {
  const at = new Map(current.handles.map((handle) => [placeKey(handle), handle]));
  const named = new Map(current.handles.map((handle) => [handle.id, handle]));
  const kept = new Set(solved.handles.map(placeKey));
  return solved.handles.map((handle) => {
    const own = named.get(handle.id);
    const here = own && placeKey(own) === placeKey(handle) ? own : at.get(placeKey(handle));
    if (here) return here;
    return own && hasSameForm(own, handle) && !kept.has(placeKey(own)) ? own : handle;
  });
}

/** A project with the ids of another one that has the same solution. */
export const withIdsOf = (solved: Project, project: Project): Project => ({
  ...project,
  handles: project.handles.map((handle, k) => ({ ...handle, id: solved.handles[k]?.id ?? handle.id })),
});

/** A clip of the second project, whose tracks name the handles as the first one does. Both have the same solution. */
export function clipWithIdsOf(solved: Project, { handles }: Project, clip: Clip): Clip {
  const names = new Map(handles.map(({ id }, k) => [id, solved.handles[k]?.id ?? id]));
  const tracks = clip.tracks.map((track) => ({ ...track, handle: names.get(track.handle) ?? track.handle }));
  return { ...clip, tracks };
}

/** Whether two handles have the same kind and number of corners. A point's place has the length 2. */
export const hasSameForm = (a: Handle, b: Handle): boolean =>
  a.kind === b.kind && a.posed.length === b.posed.length;
