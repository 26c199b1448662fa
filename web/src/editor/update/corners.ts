/** Corners of bars and polygons: adding, removing, and finishing a drawing. */

import { handleById, selectedHandles } from '../../document/document';
import { addCorner, removeCorner } from '../../document/edits';
import { CORNERS_NEEDED, edges, isClosed, isLine } from '../../document/handle';
import { nameWords } from '../../document/names';
import type { LineHandle } from '../../document/project';
import { type LinePlace, nearestPlace } from '../../geometry/polyline';
import { distance, type Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import { hit } from '../../tools/hit';
import { draftOf, finishDrawing } from '../../tools/machine';
import { hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import { gripsOf, toolContext } from '../hit_areas';
import { documentOf, type EditorState, selectionOf } from '../state';
import { announce } from './notices';
import { applyTools } from './press';
import { step } from './steps';

/** Focuses a handle, one of its corners, or the stage. */
export const focus = (emit: Emit, handle: string | null = null, corner: number | null = null): void =>
  emit({ type: 'focus', target: { handle, corner } });

/** Finishes the current drawing. */
export function finish(before: EditorState, emit: Emit): EditorState {
  const shown = hideCrosshair(before);
  const state = applyTools(shown, finishDrawing(shown.tools, toolContext(shown)), emit);
  if (!draftOf(state.tools)) focus(emit, selectionOf(state)[0]);
  return state;
}

/**
 * Adds a corner halfway after the focused corner. Without one, adds it to the only selected handle, at a place on its
 * line or on its longest edge.
 */
export function addCornerToSelected(state: EditorState, at: Vec | null, emit: Emit): EditorState {
  const document = documentOf(state);
  const { corner } = state.focus;
  const [only, ...others] = selectedHandles(document);
  const handle = corner ? handleById(document, corner.id) : others.length === 0 ? only : undefined;
  if (!handle || !isLine(handle)) return state;
  const lengths = edges(handle).map(([a, b]) => distance(a, b));
  const longest = lengths.indexOf(Math.max(...lengths));
  const edge = corner ? Math.min(corner.index, lengths.length - 1) : longest;
  const place = at && !corner ? placeOn(state, handle, at) : null;
  return cornerAdded(state, handle, place ?? { edge, fraction: 0.5 }, emit);
}

/** Removes the focused corner and focuses the one before it. */
export function removeFocusedCorner(state: EditorState, emit: Emit): EditorState {
  const { corner } = state.focus;
  const handle = corner && handleById(documentOf(state), corner.id);
  return corner && handle && isLine(handle) ? cornerRemoved(state, handle, corner.index, emit) : state;
}

/** Removes the corner at a place of the picture, or else adds one to the line there. */
export function toggleCorner(state: EditorState, at: Vec, emit: Emit): EditorState {
  const under = hit(toolContext(state), at, false);
  const handle = under && handleById(documentOf(state), under.id);
  if (!handle || !isLine(handle)) return state;
  if (under.part === 'corner') return cornerRemoved(state, handle, under.index, emit);
  const place = under.part === 'handle' ? placeOn(state, handle, at) : null;
  return place ? cornerAdded(state, handle, place, emit) : state;
}

/** The nearest place of a line, if it is within reach. */
function placeOn(state: EditorState, { posed, kind }: LineHandle, at: Vec): LinePlace | null {
  const place = nearestPlace(posed, isClosed(kind), at);
  return place.distance <= gripsOf(state).line ? place : null;
}

function cornerAdded(state: EditorState, handle: LineHandle, at: LinePlace, emit: Emit): EditorState {
  focus(emit, handle.id, at.edge + 1);
  return step(
    state,
    say('steps.addCorner', nameWords(handle)),
    addCorner(documentOf(state), handle.id, at),
    emit,
  );
}

function cornerRemoved(state: EditorState, handle: LineHandle, index: number, emit: Emit): EditorState {
  const needed = CORNERS_NEEDED[handle.kind];
  if (handle.posed.length <= needed)
    return announce(state, say(`reasons.cornersNeeded.${handle.kind}`, needed));
  focus(emit, handle.id, Math.max(0, index - 1));
  const document = removeCorner(documentOf(state), handle.id, index);
  return step(state, say('steps.deleteCorner', nameWords(handle)), document, emit);
}
