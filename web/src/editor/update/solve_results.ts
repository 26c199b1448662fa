/**
 * Results of solves.
 *
 * Nothing that the solver refuses, or breaks at, stays. A handle that cannot be solved is reverted throughout the
 * history, even in a document that was just opened. Any other edit is reverted together with later ones.
 */

import { handlesOf } from '../../error';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { mayChange } from '../permissions';
import { MAX_RECENT, pendingKey, type Solution } from '../solution';
import type { EditorState } from '../state';
import { cancelExport } from './exporting';
import { cancelFilling } from './filling';
import type { Handlers } from './handlers';
import { announce, report } from './notices';
import { closePicture } from './put_picture';
import { cancelReading } from './requests';
import { revertRejected, turnBack } from './revert';
import { beginStage, endStages, showSolution, withSolution } from './solve_request';
import { stopSuggesting } from './suggesting';
import { continuing, tellOfDrawing } from './tool_choice';
import { endTrialOpened, endTrialRejected } from './trial';

function keep(state: EditorState, solution: Solution): EditorState {
  const { recent, shown } = state.solution;
  const all = [solution, ...recent.filter(({ key }) => key !== solution.key)];
  return withSolution(state, { recent: all.filter((other, k) => k < MAX_RECENT || other === shown) });
}

function solved(before: EditorState, solution: Solution, emit: Emit): EditorState {
  const state = keep(before, solution);
  if (solution.key !== state.solution.wanted) return state;
  const { trial } = state.opening;
  const shown = showSolution(state, solution, emit);
  return trial ? endTrialOpened(shown, trial, emit) : shown;
}

function refused(state: EditorState, key: string, error: Error, emit: Emit): EditorState {
  const { trial } = state.opening;
  const accepted = state.solution.shown?.project ?? null;
  const { state: reverted, changed, undrawn } = revertRejected(state, key, handlesOf(error), accepted, emit);
  // Restored work may contain a step that was never solved: only that step goes.
  if (trial && !changed) return endTrialRejected(reverted, trial, error, true, emit);
  const next = !changed && !reverted.solution.shown ? closePicture(reverted, emit) : reverted;
  return report(next, error, emit, changed, undrawn && continuing(undrawn));
}

function failed(before: EditorState, error: Error, emit: Emit): EditorState {
  const state = withSolution(before, { failed: true });
  const { trial } = state.opening;
  return trial ? endTrialRejected(state, trial, error, false, emit) : report(state, error, emit);
}

/** Cancels the running solve, and reverts the edit, undo or redo that required it. */
function cancelSolve(state: EditorState, emit: Emit): EditorState {
  const pending = pendingKey(state.solution);
  if (pending === null || state.opening.trial) return state;
  const { shown } = state.solution;
  const back = shown ? turnBack(state, shown.key, emit) : state;
  const { state: reverted, undrawn } =
    back === state ? revertRejected(state, pending, [], null, emit) : { state: back, undrawn: null };
  const told = undrawn ? tellOfDrawing(reverted, undrawn, emit) : reverted;
  return announce(told, say('spoken.cancelled'));
}

export const solveHandlers: Handlers<
  'solver-started' | 'solve-progressed' | 'solved' | 'solve-refused' | 'borders-found' | 'task-cancelled'
> = {
  'solver-started': (state) => withSolution(state, { ready: true }),
  'solve-progressed': (state, { key, stage }, emit) =>
    key === state.solution.wanted ? beginStage(state, stage, emit) : state,
  solved: (state, { solution }, emit) => solved(state, solution, emit),
  'solve-refused': (before, { key, error, failed: broken }, emit) => {
    if (key !== before.solution.wanted) return before;
    const state = withSolution(endStages(before, emit), { wanted: before.solution.shown?.key ?? null });
    return broken ? failed(state, error, emit) : refused(state, key, error, emit);
  },
  'borders-found': (state, { solution, borders }) =>
    state.solution.borders?.of === solution
      ? withSolution(state, { borders: { of: solution, pieces: borders } })
      : state,
  'task-cancelled': (state, { task }, emit) => {
    if (task === 'export') return cancelExport(state, emit);
    if (task === 'suggest') return stopSuggesting(state, emit);
    if (task === 'fill') return cancelFilling(state, emit);
    if (task === 'open') return cancelReading(state, emit);
    return task === 'solve' && mayChange(state) ? cancelSolve(state, emit) : state;
  },
};
