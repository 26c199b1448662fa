/** Suggested handles: asked of the solver, and added as one step. A newer command or a change of handles ends that. */

import { isAtRest } from '../../document/handle';
import type { PointHandle, Project } from '../../document/project';
import { solveKey } from '../../document/solved';
import { placedAtRest, type Suggestion, withSuggested } from '../../document/suggestion';
import { distance, type Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import { pointHandle } from '../../tools/placing';
import type { Deformation } from '../deformation';
import type { Emit } from '../effects';
import { suggestedWords } from '../notice_words';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, projectOf } from '../state';
import type { Handlers } from './handlers';
import { announce, beginTask, endTask, inform, informOfStep, report } from './notices';
import { step } from './steps';
import { choose } from './tool_choice';

/** From here on a wait is noticeable. */
const PATIENCE_MS = 200;
/** Where the posed picture covers itself, a different part than the requested one may be found, image pixels. */
const SAME_PX = 2;

export function askForHandles(state: EditorState, emit: Emit): EditorState {
  const project = projectOf(state);
  emit({ type: 'suggest-handles', project });
  emit({ type: 'start-timer', timer: 'suggest-patience', ms: PATIENCE_MS });
  return { ...state, suggesting: { project, picture: state.picture } };
}

export const showSuggesting = (state: EditorState, emit: Emit): EditorState =>
  state.suggesting
    ? announce(
        beginTask(state, { name: 'suggest', label: say('tasks.suggesting'), cancellable: true }, emit),
        say('tasks.suggesting'),
      )
    : state;

/** A person cancels the suggestion. */
export const stopSuggesting = (state: EditorState, emit: Emit): EditorState =>
  state.suggesting ? announce(ended(state, emit), say('spoken.cancelled')) : state;

/** Drops a suggestion for another picture, or for handles that have changed meanwhile. */
export const withoutStaleSuggestion = (state: EditorState, emit: Emit): EditorState =>
  state.suggesting && !isFresh(state, state.suggesting) ? ended(state, emit) : state;

/** Poses and names may change while the solver looks for places. */
function isFresh(state: EditorState, asked: NonNullable<EditorState['suggesting']>): boolean {
  const project = projectOf(state);
  const isSame = () => project === asked.project || solveKey(project) === solveKey(asked.project);
  return mayEdit(state) && state.picture === asked.picture && isSame();
}

function ended(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-suggesting' });
  return settled(state, emit);
}

function settled(state: EditorState, emit: Emit): EditorState {
  emit({ type: 'stop-timer', timer: 'suggest-patience' });
  return endTask({ ...state, suggesting: null }, 'suggest', emit);
}

function suggested(before: EditorState, suggestion: Suggestion, emit: Emit): EditorState {
  const there = projectOf(before).handles.length;
  const { handles, outlined } = suggestion;
  if (handles.length === 0)
    return inform(before, say(there > 0 ? 'notices.noSuggestion' : 'notices.noPlace'), emit);
  const deformation = before.solution.shown?.deformation ?? null;
  const document = withSuggested(documentOf(before), suggestion, (project, rest) =>
    handleAt(project, rest, deformation),
  );
  const stepped = step(before, say('steps.suggest', handles.length), document, emit);
  // The next press drags one of them.
  const state = stepped.tools.tool === 'point' ? choose(stepped, 'select', emit) : stepped;
  return informOfStep(state, suggestedWords(handles.length, there, outlined), emit);
}

/** A handle that is posed as the picture there, so that nothing jumps. */
function handleAt(project: Project, rest: Vec, deformation: Deformation | null): PointHandle {
  if (!deformation || project.handles.every(isAtRest)) return pointHandle(project, placedAtRest(rest));
  const [[posed = rest] = []] = deformation.posedLines(project, [[rest]], 1);
  const found = deformation.placement(project, posed, 0);
  const turned = found && distance(found.rest, rest) < SAME_PX ? found : placedAtRest(rest);
  return pointHandle(project, { ...turned, rest, posed });
}

export const suggestionHandlers: Handlers<'handles-suggested' | 'suggestion-failed'> = {
  'handles-suggested': (state, { project, suggestion }, emit) =>
    state.suggesting?.project === project ? suggested(settled(state, emit), suggestion, emit) : state,
  'suggestion-failed': (state, { project, error }, emit) =>
    state.suggesting?.project === project ? report(settled(state, emit), error, emit) : state,
};
