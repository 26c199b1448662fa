/** The fill behind a lassoed part: switched by a person, made by the worker. */

import { withFill } from '../../document/domain';
import { amend } from '../../document/history';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, projectOf } from '../state';
import { withHistory } from './document_slice';
import { edited } from './edited';
import { endFilling, stopFilling, withFillState } from './fill_request';
import type { Handlers } from './handlers';
import { followTask, report } from './notices';
import { step } from './steps';

/** Fills the background, or leaves it empty. */
export function switchFill(state: EditorState, on: boolean, emit: Emit): EditorState {
  const document = documentOf(state);
  const label = say(on ? 'steps.fill' : 'steps.leaveEmpty');
  return step(state, label, { ...document, project: withFill(projectOf(state), on) }, emit);
}

/** Ends a fill that takes too long: the background stays empty. */
export const cancelFilling = (state: EditorState, emit: Emit): EditorState =>
  mayEdit(state) && state.solution.fill ? switchFill(stopFilling(state, emit), false, emit) : state;

/** Leaves a background empty that cannot be filled. That is no step: undo would bring the fill back, to fail again. */
function leaveEmpty(state: EditorState, emit: Emit): EditorState {
  if (!mayEdit(state)) return state;
  const stopped = stopFilling(state, emit);
  const emptied = amend(stopped.document.history, (document) => ({
    ...document,
    project: withFill(document.project, false),
  }));
  return edited(withHistory(stopped, emptied), 'change', emit);
}

export const fillHandlers: Handlers<'fill-progressed' | 'filled' | 'fill-failed'> = {
  'fill-progressed': (state, { key, part }, emit) =>
    key === state.solution.fill?.key ? followTask(state, 'fill', { fraction: part }, emit) : state,
  filled: (state, { key }, emit) =>
    key === state.solution.fill?.key ? endFilling(withFillState(state, { key, done: true }), emit) : state,
  'fill-failed': (state, { key, error }, emit) =>
    key === state.solution.fill?.key ? report(leaveEmpty(state, emit), error, emit) : state,
};
