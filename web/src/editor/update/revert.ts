/** Reverting a change that the solver rejects or a person cancels: that change is undone, and later ones stay. */
import { type Document, isSameWork } from '../../document/document';
import * as history from '../../document/history';
import type { Project } from '../../document/project';
import { handleToRevert, withHandleReverted, withSolutionReverted } from '../../document/reverting';
import { solveKey, solvesWith } from '../../document/solved';
import type { Draft } from '../../tools/state';
import type { Emit } from '../effects';
import { documentOf, type EditorState, projectOf } from '../state';
import { withDocument, withHistory } from './document_slice';
import { edited } from './edited';
import { endPressKeepingChanges } from './press';

/**
 * Takes back undo or redo, to the nearest state with the solution of this key. The states between stay in the history.
 * Returns `state` itself if an edit led to the present, or if no such state exists.
 */
export function turnBack(state: EditorState, key: string, emit: Emit): EditorState {
  const { values, at } = history.timeline(state.document.history);
  const { travelled } = state.document;
  const stands = ({ project }: Document) => solveKey(project) === key;
  let to = -1;
  if (travelled === 'undo') to = values.findIndex((document, k) => k > at && stands(document));
  if (travelled === 'redo') to = values.findLastIndex((document, k) => k < at && stands(document));
  if (to < 0) return state;
  let next = state.document.history;
  for (let k = at; k < to; k++) next = history.redo(next);
  for (let k = at; k > to; k--) next = history.undo(next);
  return edited(withDocument(state, { history: next, travelled: null }), 'change', emit);
}

/**
 * Reverts what makes the solution of this key impossible or unwanted: one of the `named` handles, or else every state
 * that needs that solution.
 *
 * @param accepted the last solved project.
 * @returns `undrawn`: the drawing of a handle that was reverted.
 */
export function revertRejected(
  state: EditorState,
  key: string,
  named: readonly string[],
  accepted: Project | null,
  emit: Emit,
): { readonly state: EditorState; readonly changed: boolean; readonly undrawn: Draft | null } {
  const times = history.timeline(state.document.history);
  const project = projectOf(state);
  const handle = handleToRevert(times, named, accepted);
  const values = handle ? withHandleReverted(times, handle) : withSolutionReverted(times, key);
  let next = withHistory(state, history.revise(state.document.history, values, isSameWork));
  const changed = documentOf(next) !== documentOf(state);
  const { drawn } = state.document;
  const undrawn =
    drawn && solvesWith(project, drawn.handle) && !solvesWith(projectOf(next), drawn.handle) ? drawn : null;
  if (handle) next = withDocument(next, { refused: [...next.document.refused, handle] });
  if (!handle || undrawn) next = endPressKeepingChanges(next, emit);
  if (undrawn) next = withDocument(next, { drawn: null });
  return {
    state: changed ? edited(next, 'change', emit) : next,
    changed,
    undrawn: undrawn?.draft ?? null,
  };
}
