/**
 * Repairs a history when the solver refuses its present: the change to blame is reverted, and later changes stay.
 *
 * Where the solver names handles, one of them at a time is reverted to what it was before; the rest may then be refused
 * for another.
 */
import { type Document, handleById } from './document';
import { selectHandles } from './edits';
import type { Timeline } from './history';
import type { Handle, Project } from './project';
import { settingsKey, solveKey, solvesAlike, solvesWith } from './solved';

/**
 * The handle to blame: of those named and not solved before, the last to change. Null if it cannot be determined, if the
 * handle was so from the beginning, or if it came with a step that replaced the project: such a step is undone whole.
 *
 * @param accepted the project solved last. Without it, handles older than the present settings are not blamed: the
 *   settings may be what made them wrong.
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

/** Whether a step leaves settings and all handles but one as they were for a solution; it may add more. */
const keepsOthers = (before: Project, after: Project, id: string): boolean =>
  settingsKey(before) === settingsKey(after) &&
  before.handles.every((handle) => handle.id === id || solvesWith(after, handle));

/** The values with the handle reverted wherever, without a break around the present, it is what it is now. */
export function withHandleReverted({ values, at }: Timeline<Document>, handle: Handle): readonly Document[] {
  const otherwise = ({ project }: Document) => !solvesWith(project, handle);
  const first = values.findLastIndex((document, k) => k < at && otherwise(document)) + 1;
  const next = values.findIndex((document, k) => k > at && otherwise(document));
  let before = values[first - 1];
  return values.map((document, k) => {
    // The value at `next` is included: it may now equal the one before it.
    if (k < first || (next >= 0 && k > next)) return document;
    before = revertHandle(document, handle, before);
    return before;
  });
}

/** The document with a handle reverted to `before`, or removed if new; `before` itself where nothing else differs. */
export function revertHandle(document: Document, handle: Handle, before: Document | undefined): Document {
  const back = before && handleById(before, handle.id);
  const handles = document.project.handles.flatMap((other) =>
    solvesAlike(other, handle) ? (back ?? []) : other,
  );
  const project = { ...document.project, handles };
  if (before && JSON.stringify(project) === JSON.stringify(before.project)) return before;
  return selectHandles({ ...document, project }, document.selection);
}

/**
 * The values with each one that needs the solution of this key replaced by the last one before it that does not, or
 * else by the first that does not.
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
