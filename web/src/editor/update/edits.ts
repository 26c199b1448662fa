/** Edits of the document: each is one undo step with a label, announced to screen readers. */

import { type Detail, modeOf, withBlend, withDetail, withMode } from '../../document/bending';
import { type Document, fileProject, handleById, isSameWork, selectedHandles } from '../../document/document';
import {
  changeHandles,
  holdBoundary,
  moveHandles,
  pastePose,
  putCorner,
  raiseHandles,
  removeHandles,
  resetHandles,
  turnHandles,
  withEdges,
} from '../../document/edits';
import { type PosedDocument, posedGroup } from '../../document/group';
import {
  anchor,
  atDepth,
  depthOf,
  isLine,
  moved,
  rotationOf,
  scaledTo,
  scaleOf,
  turnedTo,
  withAutoRotation,
} from '../../document/handle';
import { mirrorHandles } from '../../document/mirror';
import { withFileProject } from '../../document/moment';
import { nameWords } from '../../document/names';
import type { Handle, PoseMode, Project } from '../../document/project';
import { stiffened, stiffnessOf } from '../../document/stiffness';
import type { Blend } from '../../geometry/skin';
import { add, type Vec } from '../../geometry/vec';
import { say, type Wording } from '../../texts/wording';
import type { Corner } from '../corner';
import { beginCrossing, type Crossing, crossed, withDepths } from '../crossing';
import type { Emit } from '../effects';
import type { Field, NumberChange } from '../events';
import { guarded } from '../fold_guard';
import { turnsOf } from '../hit_areas';
import { cornerWords, depthWords, handleWords, placeWords, selectionName } from '../selection_words';
import { documentOf, type EditorState, projectOf } from '../state';
import { forgetDepths, noteDepths } from './document_slice';
import { announce, announceAt, informOfStep, notify } from './notices';
import { select } from './selection';
import { commitStep, modeReturn, step } from './steps';

/** The number that a change makes of the current one. */
export const changedNumber = (change: NumberChange, now: number): number =>
  'to' in change ? change.to : Math.min(Math.max(now + change.by, change.least), change.most);

export function removeSelected(state: EditorState, emit: Emit): EditorState {
  const document = documentOf(state);
  if (document.selection.length === 0) return state;
  return step(
    state,
    say('steps.delete', selectionName(document)),
    removeHandles(document, document.selection),
    emit,
  );
}

/** Returns the selected handles, or all, to their rest pose. */
export function reset(state: EditorState, all: boolean, emit: Emit): EditorState {
  const document = documentOf(state);
  const ids = all ? document.project.handles.map(({ id }) => id) : document.selection;
  if (!all && ids.length === 0) return state;
  const label = all ? say('steps.resetAll') : say('steps.reset', selectionName(document));
  const next = step(state, label, resetHandles(document, ids), emit);
  if (!all || !document.project.displacement) return next;
  const event = { type: 'displacement-cleared' } as const;
  const action = { label: say('answers.takeBack'), event } as const;
  return notify(
    next,
    { kind: 'info', text: say('notices.brushedStill'), action, passes: true, ofStep: true },
    emit,
  );
}

/** Mirrors the selected handles to the other side, and selects their counterparts. */
export function mirror(state: EditorState, emit: Emit): EditorState {
  const deformation = state.solution.shown?.deformation;
  const bounds = deformation?.restBounds();
  const before = documentOf(state);
  if (!deformation || !bounds || before.selection.length === 0) return state;
  const { document, unmatched } = mirrorHandles(before, bounds, (rest) => deformation.bends(rest));
  const goes = document.selection.some((id) => !before.selection.includes(id));
  let next = state;
  if (goes || !isSameWork(before, document)) {
    const label = say('steps.mirror', selectionName(before));
    // Counterparts that were posed so already make no step, but are selected.
    next = select(step(state, label, document, emit), document.selection, emit);
    next = announceAt(next, label);
  } else if (unmatched.length === 0) return informOfStep(state, say('notices.sameThere'), emit);
  return unmatched.length > 0
    ? informOfStep(next, say('notices.noOtherSide', unmatched.map(nameWords)), emit)
    : next;
}

/** Poses handles like copied ones. @throws RangeError if that leads to numbers that the solver cannot pose. */
export function paste(state: EditorState, copied: readonly Handle[], emit: Emit): EditorState {
  const { document, unmatched } = pastePose(documentOf(state), copied);
  const posed = copied.filter((handle) => !unmatched.includes(handle));
  const next =
    posed.length > 0 ? step(state, say('steps.pastePose', handleWords(posed)), document, emit) : state;
  return unmatched.length > 0
    ? informOfStep(next, say('notices.noCounterpart', unmatched.map(nameWords)), emit)
    : next;
}

export function nudge(state: EditorState, by: Vec, emit: Emit): EditorState {
  const document = documentOf(state);
  const wanted = { document: moveHandles(document, document.selection, by) };
  return guardedStep(
    state,
    say('steps.move', selectionName(document)),
    wanted,
    `nudge ${document.selection.join(' ')}`,
    emit,
  );
}

export const nudgeCorner = (state: EditorState, corner: Corner, by: Vec, emit: Emit): EditorState =>
  moveCorner(state, corner, 'nudge', (at) => add(at, by), emit);

/** Sets a coordinate of a corner: 0 for x, 1 for y. */
export const setCornerField = (
  state: EditorState,
  corner: Corner,
  axis: 0 | 1,
  change: NumberChange,
  emit: Emit,
): EditorState =>
  moveCorner(
    state,
    corner,
    axis === 0 ? 'x' : 'y',
    ([x, y]) => (axis === 0 ? [changedNumber(change, x), y] : [x, changedNumber(change, y)]),
    emit,
  );

/** @param way moves of one corner by the same way are one undo step. */
function moveCorner(
  state: EditorState,
  { id, index }: Corner,
  way: string,
  to: (at: Vec) => Vec,
  emit: Emit,
): EditorState {
  const document = documentOf(state);
  const handle = handleById(document, id);
  const at = handle && isLine(handle) ? handle.posed[index] : undefined;
  if (!handle || !at) return state;
  const words = (next: EditorState) => {
    const now = handleById(documentOf(next), id);
    return now && isLine(now) ? cornerWords(now, index) : null;
  };
  const wanted = { document: putCorner(document, id, index, to(at)) };
  return guardedStep(
    state,
    say('steps.moveCorner', nameWords(handle)),
    wanted,
    `${way} ${id} ${index}`,
    emit,
    words,
  );
}

/** Brings the selected handles forward by this many depth steps; negative sends them back. */
export function raise(state: EditorState, by: number, emit: Emit): EditorState {
  const document = documentOf(state);
  const { selection } = document;
  if (selection.length === 0) return state;
  const label = say(by > 0 ? 'steps.bringForward' : 'steps.sendBack', selectionName(document));
  const raised = raiseHandles(document, selection, by);
  const next = commitStep(state, label, raised, emit, `raise ${selection.join(' ')}`);
  return announceDepth(forgetDepths(next, selection));
}

export const setBlend = (state: EditorState, blend: Blend, emit: Emit): EditorState =>
  step(
    state,
    say(blend === 'rigid' ? 'steps.keepWidths' : 'steps.letWidthsChange'),
    { ...documentOf(state), project: withBlend(projectOf(state), blend) },
    emit,
  );

export const setBoundaryHeld = (state: EditorState, held: boolean, emit: Emit): EditorState =>
  step(
    state,
    say(held ? 'steps.holdBoundary' : 'steps.freeBoundary'),
    holdBoundary(documentOf(state), held),
    emit,
  );

export const setEdges = (state: EditorState, on: boolean, emit: Emit): EditorState =>
  step(state, say(on ? 'steps.showEdges' : 'steps.hideEdges'), withEdges(documentOf(state), on), emit);

/** Turns the selected handle about its own place. Several handles, or a scale, transform as one group. */
export function turn(state: EditorState, degrees: number, scale: number, emit: Emit): EditorState {
  const document = documentOf(state);
  const { selection } = document;
  const selected = selectedHandles(document);
  const turns = turnsOf(state);
  const alone = selected.length === 1 && scale === 1;
  const wanted: PosedDocument = alone
    ? { document: turnHandles(document, selection, (handle) => rotationOf(handle, turns) + degrees) }
    : posedGroup(document, degrees, scale);
  const way = scale === 1 ? 'turn' : 'scale';
  return guardedStep(
    state,
    say(`steps.${way}`, handleWords(selected)),
    wanted,
    `${way} ${selection.join(' ')}`,
    emit,
  );
}

/** Makes the rotation of the selected points automatic, or pins its present value. */
export function setAutomatic(state: EditorState, on: boolean, emit: Emit): EditorState {
  const document = documentOf(state);
  const turns = turnsOf(state);
  // Bars and polygons take their rotation from their corners.
  const points = selectedHandles(document).filter((handle) => !isLine(handle));
  const ids = points.map(({ id }) => id);
  const changed = on
    ? changeHandles(document, ids, withAutoRotation)
    : turnHandles(document, ids, (handle) => rotationOf(handle, turns));
  return step(state, say(on ? 'steps.freeTurn' : 'steps.pinTurn', selectionName(document)), changed, emit);
}

/** Changes the pose mode, with the settings that belong to it. */
export function setPoseMode(state: EditorState, mode: PoseMode, emit: Emit): EditorState {
  if (mode === modeOf(projectOf(state))) return state;
  const back = modeReturn(state, mode);
  return rebend(state, say(`steps.modes.${mode}`), (project) => withMode(project, mode, back), emit);
}

/** Changes how the project bends. In the timeline, rotations of the file change, and no key is made of that. */
export function rebend(
  state: EditorState,
  label: Wording,
  change: (project: Project) => Project,
  emit: Emit,
): EditorState {
  const document = documentOf(state);
  const changed = state.timeline.open
    ? withFileProject(document, change(fileProject(document)))
    : { ...document, project: change(document.project) };
  return step(state, label, changed, emit);
}

export const setDetail = (state: EditorState, detail: Detail, emit: Emit): EditorState =>
  step(
    state,
    say(`steps.details.${detail}`),
    { ...documentOf(state), project: withDetail(projectOf(state), detail) },
    emit,
  );

/** Sets one number of every selected handle. */
export function setField(state: EditorState, field: Field, change: NumberChange, emit: Emit): EditorState {
  const document = documentOf(state);
  const turns = turnsOf(state);
  const value = (now: number) => changedNumber(change, now);
  const set: Readonly<Record<Field, (handle: Handle) => Handle>> = {
    x: (handle) => moved(handle, [value(anchor(handle)[0]) - anchor(handle)[0], 0]),
    y: (handle) => moved(handle, [0, value(anchor(handle)[1]) - anchor(handle)[1]]),
    rotation: (handle) => turnedTo(handle, value(rotationOf(handle, turns))),
    scale: (handle) => scaledTo(handle, value(scaleOf(handle))),
    depth: (handle) => atDepth(handle, value(depthOf(handle))),
    stiffness: (handle) => stiffened(handle, value(stiffnessOf(handle))),
  };
  const { selection } = document;
  const wanted = { document: changeHandles(document, selection, set[field]) };
  const label = say(`steps.set.${field}`, selectionName(document));
  const key = `${field} ${selection.join(' ')}`;
  if (field === 'stiffness') return announce(commitStep(state, label, wanted.document, emit, key), label);
  if (field === 'depth') {
    const next = commitStep(state, label, wanted.document, emit, key);
    return announceDepth(forgetDepths(next, selection));
  }
  return guardedStep(state, label, wanted, key, emit);
}

/** Commits a change as far as the guard against folds allows, and announces the result. */
function guardedStep(
  state: EditorState,
  label: Wording,
  wanted: PosedDocument,
  key: string,
  emit: Emit,
  words = (next: EditorState) => placeWords(documentOf(next), turnsOf(next)),
): EditorState {
  const present = documentOf(state);
  const { document, guard } = guarded(
    state.guard,
    state.solution.shown?.deformation ?? null,
    present,
    wanted,
  );
  const limited = { ...state, guard };
  if (document === present && guard.holding) return announce(limited, say('spoken.stoppedAtFold'));
  const crossing = crossingOf(state, document);
  const stepped = commitStep(limited, label, withDepths(document, crossing), emit, key);
  const next = noteDepths(stepped, crossing);
  const said = words(next);
  return said === null ? next : announce(next, said);
}

/** The depths that bring the selected handles in front of the parts that now cover them. */
function crossingOf(state: EditorState, moved: Document): Crossing {
  const present = documentOf(state);
  const deformation = state.solution.shown?.deformation ?? null;
  return crossed(beginCrossing(deformation, present), deformation, present, moved);
}

function announceDepth(state: EditorState): EditorState {
  const words = depthWords(documentOf(state));
  return words === null ? state : announce(state, words);
}
