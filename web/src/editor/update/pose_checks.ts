/**
 * Checks for faults that a person may overlook: creases, parts of the picture outside its frame, and handles partly
 * outside the picture.
 *
 * Creases and the frame need a pass over the whole mesh. It is made a few times a second during a drag, and once after
 * it.
 */
import { ringsOf } from '../../document/domain';
import { nameOf } from '../../document/handle';
import { placeKey } from '../../document/solved';
import type { Emit } from '../effects';
import { outsideText } from '../notice_texts';
import type { Solution } from '../solution';
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

/** Names the handles that lie partly outside the picture, when a solve finds others than the solve before. */
export function checkSolution(before: EditorState, { project, report }: Solution, emit: Emit): EditorState {
  const state = schedulePoseCheck(before, emit);
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
