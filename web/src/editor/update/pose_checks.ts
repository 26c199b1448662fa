/**
 * Checks for what a person may overlook: creases, parts of the picture outside its frame, handles partly outside the
 * picture, and outlines that do not follow it.
 *
 * Creases and the frame need a pass over the whole mesh. It is made a few times a second during a drag, and once after
 * it.
 */
import { ringsOf } from '../../document/domain';
import { nameOf } from '../../document/handle';
import { placeKey } from '../../document/solved';
import type { Emit } from '../effects';
import { outlineText, outsideText } from '../notice_texts';
import type { Solution, SolveReport } from '../solution';
import { type EditorState, projectOf } from '../state';
import { reachesBeyondFrame } from '../view';
import { informOfStep } from './notices';

const PAUSE_MS = 200;

/** Schedules a check of the pose, unless its result is not shown. */
export function schedulePoseCheck(state: EditorState, emit: Emit): EditorState {
  if (state.page.playing || state.checks.pending) return state;
  emit({ type: 'start-timer', timer: 'pose-check', ms: PAUSE_MS });
  return { ...state, checks: { ...state.checks, pending: true } };
}

export function checkPose(state: EditorState): EditorState {
  const creases = state.solution.shown?.deformation.creases(projectOf(state)) ?? [];
  return {
    ...state,
    checks: { ...state.checks, pending: false, creases, beyond: reachesBeyondFrame(state) },
  };
}

/** Tells what a solve finds that the solve before did not. */
export const checkSolution = (state: EditorState, solution: Solution, emit: Emit): EditorState =>
  checkOutline(checkOutside(schedulePoseCheck(state, emit), solution, emit), solution.report, emit);

/** Says how an outline is simplified that is too fine to be followed. */
function checkOutline(state: EditorState, { outline, bridgedGap }: SolveReport, emit: Emit): EditorState {
  const key = `${outline} ${bridgedGap}`;
  if (key === state.checks.outline) return state;
  const next = { ...state, checks: { ...state.checks, outline: key } };
  const text = outlineText(outline, bridgedGap);
  return text === null ? next : informOfStep(next, text, emit);
}

/** Names the handles that lie partly outside the picture. */
function checkOutside(state: EditorState, { project, report }: Solution, emit: Emit): EditorState {
  const { outside } = report;
  const key = JSON.stringify(outside);
  if (key === state.checks.outside) return state;
  const next = { ...state, checks: { ...state.checks, outside: key } };
  const ids = new Set(outside.map(({ handle }) => handle));
  const places = project.handles.filter(({ id }) => ids.has(id)).map(placeKey);
  const names = projectOf(next)
    .handles.filter((handle) => places.includes(placeKey(handle)))
    .map(nameOf);
  return names.length > 0
    ? informOfStep(next, outsideText(names, ringsOf(projectOf(next)).length > 0), emit)
    : next;
}
