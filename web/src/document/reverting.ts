/**
 * Repairs a history after the solver rejects its present: the offending change is reverted, and later changes stay.
 *
 * If the solver names handles, one of them is reverted at a time. The solver may then reject another one.
 */
import { type Document, handleById } from './document';
import { selectHandles } from './edits';
import type { Timeline } from './history';
import type { Handle, Project } from './project';
import { settingsKey, solveKey, solvesAlike, solvesWith } from './solved';
import { withoutLostTracks, withTracksOf } from './tracks';

/**
 * Returns the handle to revert: among those named and not solved before, the last one to change.
 *
 * Returns `null` if no step changed only such a handle. A step that replaced the project is undone as a whole.
 *
 * @param accepted the last solved project. Without it, handles older than the present settings are not reverted: the
 *   settings can be the cause.
 */
export function handleToRevert(
  { values, at }: Timeline<Document>,
  named: readonly string[],
  accepted: Project | null,
): Handle | null {
  const [present, ...earlier] = values.slice(0, at + 1).reverse();
  if (!present) return null;
  const suspects = named
    .flatMap((id) => handleById(present, id) ?? [])
    .filter((handle) => !accepted || !solvesWith(accepted, handle));
  let after = present.project;
  for (const { project } of earlier) {
    if (!accepted && settingsKey(project) !== settingsKey(present.project)) return null;
    const found = suspects.findLast((handle) => !solvesWith(project, handle));
    if (found) return keepsOthers(project, after, found.id) ? found : null;
    after = project;
  }
  return null;
}

/** Whether a step keeps the settings and all handles but one, except for poses. It can add handles. */
const keepsOthers = (before: Project, after: Project, id: string): boolean =>
  settingsKey(before) === settingsKey(after) &&
  before.handles.every((handle) => handle.id === id || solvesWith(after, handle));

/** Reverts the handle in the present and in all values around it that have it unchanged. */
export function withHandleReverted({ values, at }: Timeline<Document>, handle: Handle): readonly Document[] {
  const otherwise = ({ project }: Document) => !solvesWith(project, handle);
  const first = values.findLastIndex((document, k) => k < at && otherwise(document)) + 1;
  const next = values.findIndex((document, k) => k > at && otherwise(document));
  let before = values[first - 1];
  return values.map((document, k) => {
    // Includes the value at `next`, which may now equal the one before it.
    if (k < first || (next >= 0 && k > next)) return document;
    before = revertHandle(document, handle, before);
    return before;
  });
}

/** Reverts a handle to `before`, or removes it if it is new. Returns `before` itself if nothing else differs. */
export function revertHandle(document: Document, handle: Handle, before: Document | undefined): Document {
  const back = before && handleById(before, handle.id);
  const handles = document.project.handles.flatMap((other) =>
    solvesAlike(other, handle) ? (back ?? []) : other,
  );
  const without = withoutLostTracks({ ...document.project, handles });
  const project = back && before ? withTracksOf(without, handle.id, before.project) : without;
  if (before && JSON.stringify(project) === JSON.stringify(before.project)) return before;
  return selectHandles({ ...document, project }, document.selection);
}

/**
 * Replaces each value that needs the solution of this key. The last value before it that needs another solution takes
 * its place, or else the first such value.
 */
export function withSolutionReverted({ values }: Timeline<Document>, key: string): readonly Document[] {
  const stands = ({ project }: Document) => solveKey(project) !== key;
  let before = values.find(stands);
  return values.map((document) => {
    if (before && !stands(document)) return before;
    before = document;
    return document;
  });
}
