/** Requests of fills: the background behind a lassoed part, for the solution that is shown. */

import { isFilled, ringsOf } from '../../document/domain';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import type { Solution, SolutionState } from '../solution';
import type { EditorState } from '../state';
import { beginTask, endTask } from './notices';

/** From here on a wait is noticeable. */
const PATIENCE_MS = 300;

/** Names a fill. Two fills of a picture with the same key are the same. */
export const fillKey = ({ project }: Solution): string | null =>
  isFilled(project) ? JSON.stringify([project.image, ringsOf(project), project.fill]) : null;

export const withFillState = (state: EditorState, fill: SolutionState['fill']): EditorState => ({
  ...state,
  solution: { ...state.solution, fill },
});

/** Requests the fill of the shown solution, unless it exists. */
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
    ? beginTask(state, { name: 'fill', label: say('tasks.filling'), cancellable: mayEdit(state) }, emit)
    : state;
}

export function stopFilling(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-filling' });
  return endFilling(withFillState(state, null), emit);
}

export function endFilling(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-timer', timer: 'fill-patience' });
  return endTask(state, 'fill', emit);
}
