/**
 * Checks for facts that a person may overlook: creases, parts of the picture outside its frame, handles partly outside
 * the picture, outlines that do not follow it, and parts without a handle.
 *
 * Creases and the frame need a pass over the whole mesh. It is made a few times a second during a drag, and once after
 * it.
 */

import { ringsOf } from '../../document/domain';
import { nameWords } from '../../document/names';
import { settingsOf } from '../../document/settings';
import { placeKey } from '../../document/solved';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { outlineWords } from '../notice_words';
import { mayEdit } from '../permissions';
import type { Solution, SolveReport } from '../solution';
import { type EditorState, projectOf } from '../state';
import { reachesBeyondFrame } from '../view';
import { checkForcing } from './forcing_check';
import { informOfStep, notify } from './notices';

const PAUSE_MS = 200;

/** Schedules a check of the pose, unless its result is not shown. */
export function schedulePoseCheck(state: EditorState, emit: Emit): EditorState {
  if (state.page.posable || state.checks.pending) return state;
  emit({ type: 'start-timer', timer: 'pose-check', ms: PAUSE_MS });
  return { ...state, checks: { ...state.checks, pending: true } };
}

export function checkPose(state: EditorState, emit: Emit): EditorState {
  const creases = state.solution.shown?.deformation.creases(projectOf(state)) ?? [];
  const checks = { ...state.checks, pending: false, creases, beyond: reachesBeyondFrame(state) };
  return checkForcing({ ...state, checks }, emit);
}

/** Tells the findings of a solve that are new. */
export function checkSolution(before: EditorState, solution: Solution, emit: Emit): EditorState {
  const state = checkOutside(schedulePoseCheck(before, emit), solution, emit);
  return checkLooseParts(checkOutline(state, solution.report, emit), solution.report, emit);
}

/** Offers to let parts without a handle follow the others, once for each picture. */
function checkLooseParts(state: EditorState, { looseParts }: SolveReport, emit: Emit): EditorState {
  const project = projectOf(state);
  const isFine =
    looseParts === 0 || project.handles.length === 0 || settingsOf(project).loose_parts === 'follow';
  if (isFine || state.checks.loose || !mayEdit(state)) return state;
  const event = { type: 'setting-set', setting: { name: 'loose_parts', value: 'follow' } } as const;
  const action = { label: say('answers.letFollow'), event } as const;
  const notice = {
    kind: 'info',
    text: say('notices.looseParts', looseParts),
    action,
    passes: true,
    ofStep: true,
  } as const;
  return notify({ ...state, checks: { ...state.checks, loose: true } }, notice, emit);
}

/** Says how an outline is simplified that is too fine to be followed. */
function checkOutline(state: EditorState, { outline, bridgedGap }: SolveReport, emit: Emit): EditorState {
  const key = `${outline} ${bridgedGap}`;
  if (key === state.checks.outline) return state;
  const next = { ...state, checks: { ...state.checks, outline: key } };
  const text = outlineWords(outline, bridgedGap);
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
    .map(nameWords);
  return names.length > 0
    ? informOfStep(
        next,
        say(`notices.outside${ringsOf(projectOf(next)).length > 0 ? 'Lasso' : 'Picture'}`, names),
        emit,
      )
    : next;
}
