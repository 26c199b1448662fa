/** Presses and moves of the pointer on the stage. */
import { hand } from '../../tools/hand';
import { cancelPress, draftOf, hover, pressDown, pressMove, pressUp } from '../../tools/machine';
import { withoutRings } from '../../tools/pressing';
import { hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import { hitAt, isLassoing, pressOf, toolContext } from '../hit_areas';
import { holdsKeys } from '../keys_in_hand';
import { mayEdit, pressesPan } from '../permissions';
import type { StagePointer } from '../stage_pointer';
import { type EditorState, type PointerState, selectionOf } from '../state';
import { moveCamera } from '../view';
import { followClip } from './clip_slice';
import { focus } from './corners';
import type { Handlers } from './handlers';
import { releaseByKeys } from './held_by_keys';
import { removeRingCornerAt } from './lasso_corners';
import { followPointer } from './lens';
import { closeMenu } from './menu_closing';
import { movePlayhead } from './playhead';
import { applyTools } from './press';
import { doublePress } from './renaming';
import { select, withoutKeys } from './selection';

export const withPointer = (state: EditorState, change: Partial<PointerState>): EditorState => ({
  ...state,
  pointer: { ...state.pointer, ...change },
});

/** Notes the kind of the pointer: hit areas depend on it. */
export const noteKind = (state: EditorState, coarse: boolean): EditorState =>
  state.pointer.coarse === coarse ? state : withPointer(state, { coarse });

function begin(before: EditorState, pointer: StagePointer, pans: boolean, emit: Emit): EditorState {
  const released = stopped(releaseByKeys(before, emit), pans, emit);
  const noted = hideCrosshair(closeMenu(noteKind(released, pointer.coarse), emit));
  // A press whose end was missed must not stay open.
  const state = applyTools(noted, cancelPress(noted.tools), emit);
  const press = pressOf(state, pointer);
  const context = toolContext(state);
  const bodies = state.tools.tool === 'select';
  const onHandle = hitAt(state, press.at, bodies, withoutRings(context)) !== null;
  const taken = onHandle ? withoutKeys(state) : state;
  const once = pans || pressesPan(state) ? hand : undefined;
  return applyTools(withPointer(taken, { onHandle }), pressDown(state.tools, press, context, once), emit);
}

/** A press stops the timeline at a frame, whose pose the press finds. One that pans leaves it. */
const stopped = (state: EditorState, pans: boolean, emit: Emit): EditorState =>
  state.timeline.playing && !pans ? followClip(movePlayhead(state, state.timeline.time, emit), emit) : state;

function end(before: EditorState, pointer: StagePointer, emit: Emit): EditorState {
  const press = pressOf(before, pointer);
  const drawing = draftOf(before.tools) !== null;
  const held = drawing ? null : hitAt(before, press.at, before.tools.tool === 'select');
  const outcome = pressUp(before.tools, press, toolContext(before));
  const state = applyTools(before, outcome, emit);
  if (outcome.effects.some(({ type }) => type === 'ring-focus')) return state;
  const selection = selectionOf(state);
  // Focusing a handle selects it: not one that a Shift-click has just deselected.
  const keeps = held !== null && held.part !== 'ring' && held.part !== 'grip' && selection.includes(held.id);
  if (keeps && held.part === 'corner') focus(emit, held.id, held.index);
  // A press that only pans deselects no keys.
  else focus(emit, keeps ? held.id : holdsKeys(state) ? null : selection[0]);
  return state;
}

/** With other tools than these a double click ends a drawing. */
function doublePressed(state: EditorState, pointer: StagePointer, emit: Emit): EditorState {
  if (pressesPan(state) || pointer.alt) return state;
  const { at } = pressOf(state, pointer);
  if (state.tools.tool === 'select') return doublePress(state, at, emit);
  return isLassoing(state) && mayEdit(state) ? removeRingCornerAt(state, at, emit) : state;
}

/** Moves the pointer without a press; null when it leaves the stage. */
function hovered(state: EditorState, pointer: StagePointer | null): EditorState {
  const press = pointer && pressOf(state, pointer);
  const last = pointer && { pointer, camera: state.view.camera };
  return followPointer(
    withPointer(
      { ...state, tools: hover(state.tools, press, toolContext(state)) },
      { hovered: press?.at ?? null, alt: press?.alt ?? false, last },
    ),
  );
}

/** Alt was pressed or released under a resting pointer. */
export function holdAlt(state: EditorState, alt: boolean): EditorState {
  const { last, hovered: at } = state.pointer;
  if (!last || !at || state.pointer.alt === alt) return state;
  const held = withPointer(state, { alt, last: { ...last, pointer: { ...last.pointer, alt } } });
  // The way of a lasso to the pointer leaves the edges, or follows them again.
  const press = pressOf(held, { ...last.pointer, alt });
  return isLassoing(state) ? { ...held, tools: hover(held.tools, press, toolContext(held)) } : held;
}

/** Repeats the last hover if the camera has moved under a resting pointer. */
export function followCamera(state: EditorState): EditorState {
  const { last } = state.pointer;
  return last && last.camera !== state.view.camera && !state.display.crosshair
    ? hovered(state, last.pointer)
    : state;
}

export const pointerHandlers: Handlers<
  | 'press-began'
  | 'press-moved'
  | 'press-ended'
  | 'press-cancelled'
  | 'double-pressed'
  | 'pointer-hovered'
  | 'pointer-noted'
  | 'page-clicked'
  | 'camera-moved'
> = {
  'press-began': (state, { pointer, pans }, emit) => begin(state, pointer, pans, emit),
  'press-moved': (state, { pointer }, emit) =>
    applyTools(state, pressMove(state.tools, pressOf(state, pointer), toolContext(state)), emit),
  'press-ended': (state, { pointer }, emit) => end(state, pointer, emit),
  'press-cancelled': (state, _, emit) => applyTools(state, cancelPress(state.tools), emit),
  'double-pressed': (state, { pointer }, emit) => doublePressed(state, pointer, emit),
  'pointer-hovered': (state, { pointer }) => hovered(state, pointer),
  'pointer-noted': (state, { coarse }) => noteKind(state, coarse),
  'page-clicked': (state, _, emit) => (mayEdit(state) ? select(state, [], emit) : state),
  'camera-moved': (state, { camera }) => moveCamera(state, camera),
};
