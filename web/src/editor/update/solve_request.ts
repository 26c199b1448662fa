/** Requests of solutions: immediate if a recent one serves, else by the solver. The newest request wins. */

import { solveKey } from '../../document/solved';
import { say } from '../../texts/wording';
import { draftOf, isPressing } from '../../tools/machine';
import type { Emit } from '../effects';
import type { Solution, SolutionState, SolveStage } from '../solution';
import { documentOf, type EditorState, projectOf } from '../state';
import { refitView } from '../view';
import { saveOpened } from './autosave';
import { requestFill } from './fill_request';
import { beginTask, closeRetryNotice, endTask } from './notices';
import { checkSolution } from './pose_checks';

/** From here on a wait is noticeable. */
const PATIENCE_MS = 200;

export const withSolution = (state: EditorState, change: Partial<SolutionState>): EditorState => ({
  ...state,
  solution: { ...state.solution, ...change },
});

/** Requests the solution of the present project, unless it is requested already. */
export function requestSolution(state: EditorState, emit: Emit): EditorState {
  const project = projectOf(state);
  const key = solveKey(project);
  if (key === state.solution.wanted || !state.picture) return state;
  const wanting = withSolution(state, { wanted: key, failed: false });
  const known = state.solution.recent.find((solution) => solution.key === key);
  if (known) return showSolution(wanting, known, emit);
  emit({ type: 'solve', key, project });
  return beginStage(wanting, 'start', emit);
}

/** Shows a solution, and checks it. */
export function showSolution(state: EditorState, solution: Solution, emit: Emit): EditorState {
  const first = state.solution.shown === null;
  let next = withSolution(endStages(state, emit), { shown: solution, ready: true });
  next = requestFill(checkSolution(closeRetryNotice(next), solution, emit), emit);
  if (!first) return next;
  // The bounds of the posed picture are known only now.
  return saveOpened(isInHand(next) ? next : refitView(next), emit);
}

/** Whether a person works on a picture that is just being opened: it must not move under the pointer. */
function isInHand(state: EditorState): boolean {
  const { opening, waiting, tools } = state;
  if (!opening.trial) return false;
  const isDrawing = isPressing(tools) || draftOf(tools) !== null;
  return isDrawing || waiting.length > 0 || documentOf(state) !== opening.trial.opened;
}

/** Begins a stage of a solve. It is shown once the solve has taken noticeably long. */
export function beginStage(state: EditorState, stage: SolveStage | 'start', emit: Emit): EditorState {
  const next = withSolution(state, { stage });
  if (state.solution.stage === null) emit({ type: 'start-timer', timer: 'solve-patience', ms: PATIENCE_MS });
  const isShown = state.notices.tasks.some(({ name }) => name === 'solve');
  return isShown ? showStage(next, emit) : next;
}

/** Shows the current stage. The first solve cannot be cancelled: there is no solution to return to. */
export function showStage(state: EditorState, emit: Emit): EditorState {
  const { stage, shown } = state.solution;
  if (stage === null) return state;
  return beginTask(state, { name: 'solve', label: say(`tasks.${stage}`), cancellable: shown !== null }, emit);
}

export function endStages(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-timer', timer: 'solve-patience' });
  return endTask(withSolution(state, { stage: null }), 'solve', emit);
}
