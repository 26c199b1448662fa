/** The lasso: which part of the picture bends, and the hint after a press outside it. */

import {
  featherOf,
  isFilled,
  ringsOf,
  withFeather,
  withFill,
  withLasso,
  withoutLasso,
} from '../../document/domain';
import { selectHandles } from '../../document/edits';
import { withPlaceAdded } from '../../document/lasso_growth';
import { withPartPolygons } from '../../document/part_polygon';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import type { NumberChange } from '../events';
import { mayEdit } from '../permissions';
import { isOpaque } from '../picture';
import { documentOf, type EditorState, projectOf, selectionOf } from '../state';
import { changedNumber } from './edits';
import type { Handlers } from './handlers';
import { inform, informOfStep, notify } from './notices';
import { step } from './steps';
import { choose } from './tool_choice';

/**
 * Lets only the inside of a ring bend, or cuts a hole there. Shows which handles were removed, or why the lasso is
 * incomplete.
 */
function lasso(state: EditorState, ring: readonly Vec[], hole: boolean, emit: Emit): EditorState {
  const found = withLasso(projectOf(state), ring, hole);
  if (!found) return informOfStep(state, say('notices.lassoEmpty'), emit);
  const { cut } = found;
  // A part of an opaque picture moves over a filled background. A cut-out picture has no lasso.
  const isFirst = ringsOf(projectOf(state)).length === 0 && isOpaque(state.picture);
  const project = isFirst ? { ...withFill(found.project, true), fix_boundary: false } : found.project;
  const removed = projectOf(state).handles.length - project.handles.length;
  const document = selectHandles({ ...documentOf(state), project }, selectionOf(state));
  const stepped = step(state, say(cut ? 'steps.cutHole' : 'steps.bendInside'), document, emit);
  const next = choose(stepped, project.handles.length > 0 ? 'select' : 'point', emit);
  if (removed > 0) return informOfStep(next, say('notices.leftOut', removed), emit);
  if (project.fix_boundary) return next;
  const action = {
    label: say('answers.holdBoundary'),
    event: { type: 'boundary-switched', held: true },
  } as const;
  const other = {
    label: say('commands.turn-part'),
    event: { type: 'command-run', command: 'turn-part' },
  } as const;
  const actions = isOpaque(state.picture) ? { action, other } : { action };
  const text = say(isFilled(project) ? 'notices.lassoFilled' : 'notices.lassoLoose');
  return notify(next, { kind: 'info', text, ...actions, passes: true, ofStep: true }, emit);
}

/** Lets the whole picture bend. An opaque picture holds its boundary again. */
export function removeLasso(state: EditorState, emit: Emit): EditorState {
  if (!state.picture) return state;
  const project = withoutLasso(projectOf(state), state.picture.alphaThreshold);
  return step(state, say('steps.bendAll'), { ...documentOf(state), project }, emit);
}

/** Sets the width of the soft rim. Consecutive changes are one step. */
export function setFeather(state: EditorState, change: NumberChange, emit: Emit): EditorState {
  const present = featherOf(projectOf(state));
  if (present === null) return state;
  const project = withFeather(projectOf(state), changedNumber(change, present));
  const document = { ...documentOf(state), project };
  return step(state, say('steps.setFeather'), document, emit, 'feather');
}

/** Polygons take the place of the lasso: they turn its parts, and the rest bends along up to the held frame. */
export function turnPart(state: EditorState, emit: Emit): EditorState {
  const document = withPartPolygons(documentOf(state));
  if (!document) return inform(state, say('notices.partOnFrame'), emit);
  return choose(step(state, say('steps.turnPart'), document, emit), 'select', emit);
}

/** Says that a place does not bend. A place of the picture outside of the lasso can be added. */
function missed(state: EditorState, at: Vec, emit: Emit): EditorState {
  if (!withPlaceAdded(projectOf(state), at)) return inform(state, say('notices.nothingToHold'), emit);
  const action = {
    label: say('answers.extendSelection'),
    event: { type: 'selection-extended', at },
  } as const;
  return notify(state, { kind: 'info', text: say('notices.lassoOutside'), action, passes: true }, emit);
}

function extend(state: EditorState, at: Vec, emit: Emit): EditorState {
  const project = withPlaceAdded(projectOf(state), at);
  return project ? step(state, say('steps.extendSelection'), { ...documentOf(state), project }, emit) : state;
}

export const lassoHandlers: Handlers<'placement-missed' | 'selection-extended' | 'lasso-drawn'> = {
  'placement-missed': (state, { at }, emit) => missed(state, at, emit),
  'selection-extended': (state, { at }, emit) => (mayEdit(state) ? extend(state, at, emit) : state),
  'lasso-drawn': (state, { ring, hole }, emit) => lasso(state, ring, hole, emit),
};
