/** The fill behind a lassoed part: it is asked for with each solution, unless it is there. */
import { isFilled, ringsOf, withFill } from '../../document/domain';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import type { Solution, SolutionState } from '../solution';
import { documentOf, type EditorState, projectOf } from '../state';
import type { Handlers } from './handlers';
import { beginTask, endTask, followTask, report } from './notices';
import { step } from './steps';

const LABEL = 'Filling the background';
/** From here on a wait is noticeable. */
const PATIENCE_MS = 300;

/** Names a fill. Two fills of a picture with the same key are the same. */
export const fillKey = ({ project }: Solution): string | null =>
  isFilled(project) ? JSON.stringify([project.image, ringsOf(project), project.fill]) : null;

const withFillState = (state: EditorState, fill: SolutionState['fill']): EditorState => ({
  ...state,
  solution: { ...state.solution, fill },
});

/** Asks for the fill of the shown solution. */
export function requestFill(state: EditorState, emit: Emit): EditorState {
  const { shown, fill } = state.solution;
  const key = shown && fillKey(shown);
  if (!shown || key === null) return fill ? stopFilling(state, emit) : state;
  if (fill?.key === key && fill.done) return state;
  emit({ type: 'fill', key, project: shown.project });
  emit({ type: 'start-timer', timer: 'fill-patience', ms: PATIENCE_MS });
  return withFillState(state, { key, done: false });
}

/** Shows that the background is being filled. */
export function showFilling(state: EditorState, emit: Emit): EditorState {
  const { fill } = state.solution;
  return fill && !fill.done
    ? beginTask(state, { name: 'fill', label: LABEL, cancellable: mayEdit(state) }, emit)
    : state;
}

function stopFilling(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-filling' });
  return endFilling(withFillState(state, null), emit);
}

function endFilling(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-timer', timer: 'fill-patience' });
  return endTask(state, 'fill', emit);
}

/** Fills the background, or leaves it empty. */
export function switchFill(state: EditorState, on: boolean, emit: Emit): EditorState {
  const document = documentOf(state);
  const label = on ? 'Fill the background' : 'Leave the background empty';
  return step(state, label, { ...document, project: withFill(projectOf(state), on) }, emit);
}

/** Ends a fill that takes too long: the background stays empty. */
export const cancelFilling = (state: EditorState, emit: Emit): EditorState =>
  mayEdit(state) && state.solution.fill ? switchFill(stopFilling(state, emit), false, emit) : state;

export const fillHandlers: Handlers<'fill-progressed' | 'filled' | 'fill-failed'> = {
  'fill-progressed': (state, { key, part }, emit) =>
    key === state.solution.fill?.key ? followTask(state, 'fill', { fraction: part }, emit) : state,
  filled: (state, { key }, emit) =>
    key === state.solution.fill?.key ? endFilling(withFillState(state, { key, done: true }), emit) : state,
  'fill-failed': (state, { key, error }, emit) =>
    key === state.solution.fill?.key ? report(cancelFilling(state, emit), error, emit) : state,
};
