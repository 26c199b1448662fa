/** Out of folds: moves the handles that force them to the nearest pose without. */

import { isSameWork } from '../../document/document';
import { timeline } from '../../document/history';
import { nameWords } from '../../document/names';
import type { Handle, Project } from '../../document/project';
import { hasSameForm } from '../../document/solved';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { handleWords } from '../selection_words';
import { documentOf, type EditorState, projectOf } from '../state';
import { inform, informOfStep } from './notices';
import { step } from './steps';

/** Earlier steps among which a pose without folds is looked for: each takes a pose. */
const MOST_STEPS = 4;

/** Moves the handles that force folds to the nearest pose without. */
export function leaveFolds(before: EditorState, emit: Emit): EditorState {
  const deformation = before.solution.shown?.deformation;
  const project = projectOf(before);
  if (!deformation) return before;
  const found = deformation.unfolded(project, lastWithoutFolds(before));
  if (!found) return inform(before, say('notices.noWayOut'), emit);
  const changed = found.handles.filter((handle, k) => handle !== project.handles[k]);
  const document = { ...documentOf(before), project: found };
  if (isSameWork(documentOf(before), document)) return before;
  const state = step(before, say('steps.leaveFolds', handleWords(changed)), document, emit);
  return informOfStep(state, say('notices.leftFolds', changed.map(nameWords)), emit);
}

/** The last step of the history with the same handles and no folds. */
function lastWithoutFolds(state: EditorState): Project | null {
  const deformation = state.solution.shown?.deformation;
  const present = projectOf(state);
  const { values, at } = timeline(state.document.history);
  const earlier = values.slice(Math.max(0, at - MOST_STEPS), at).map(({ project }) => project);
  const isOne = (project: Project) =>
    hasSameHandles(project, present) && deformation?.foldCount(project) === 0;
  return earlier.findLast(isOne) ?? null;
}

const hasSameHandles = (a: Project, b: Project): boolean => {
  const others = new Map(b.handles.map((handle): readonly [string, Handle] => [handle.id, handle]));
  const isThere = (handle: Handle) => {
    const other = others.get(handle.id);
    return other !== undefined && hasSameForm(handle, other);
  };
  return a.handles.length === b.handles.length && a.handles.every(isThere);
};
