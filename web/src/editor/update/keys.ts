/** Keys on the stage: arrows nudge, move the crosshair or pan; comma and full stop turn or scale; Enter places. */

import { handleById } from '../../document/document';
import { panned } from '../../geometry/camera';
import { scaled, type Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import { draftOf, hover, isPressing, places, pressDown, pressMove, pressUp } from '../../tools/machine';
import { pressAt } from '../../tools/state';
import { crosshairMoved, crosshairPlace, hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import { contextWithoutHandles, isBrushing, toolContext } from '../hit_areas';
import { mayEdit } from '../permissions';
import { ringCornerInHand } from '../ring_corner';
import { documentOf, type EditorState, selectionOf } from '../state';
import { moveCamera } from '../view';
import { awaitsPicture } from '../waiting_input';
import { finish, focus } from './corners';
import { nudge, nudgeCorner, turn } from './edits';
import type { Handlers } from './handlers';
import { isHeldByKeys, releaseByKeys } from './held_by_keys';
import { nudgeRingCorner } from './lasso_corners';
import { moveLens } from './lens';
import { announce } from './notices';
import { holdAlt, withPointer } from './pointer';
import { applyTools } from './press';

/** CSS pixels that an arrow key pans the picture for each pixel that it would nudge a handle. */
const PAN_CSS_PX = 40;

/** The effect of an arrow key; null if it is left to the page. */
function arrowTarget(
  state: EditorState,
): 'lens' | 'ring' | 'corner' | 'handles' | 'crosshair' | 'view' | null {
  if (state.tools.tool === 'lens' && state.picture) return 'lens';
  const drawing = draftOf(state.tools) !== null;
  if (mayEdit(state)) {
    if (ringCornerInHand(state)) return 'ring';
    if (state.focus.corner && !drawing) return 'corner';
    if (selectionOf(state).length > 0 && !drawing) return 'handles';
    if (places(state.tools.tool)) return 'crosshair';
  }
  return state.page.posable ? null : 'view';
}

export const takesArrow = (state: EditorState): boolean => arrowTarget(state) !== null;
export const takesTurn = (state: EditorState): boolean =>
  awaitsPicture(state) || (mayEdit(state) && selectionOf(state).length > 0);
export const takesPlace = (state: EditorState): boolean =>
  awaitsPicture(state) || (mayEdit(state) && places(state.tools.tool));
export const takesSpace = ({ page }: EditorState): boolean => !page.posable;

function arrow(state: EditorState, by: Vec, emit: Emit): EditorState {
  const target = arrowTarget(state);
  if (target === 'lens') return moveLens(state, by);
  if (target === 'ring') return nudgeRingCorner(state, by, emit);
  if (target === 'corner' && state.focus.corner) return nudgeCorner(state, state.focus.corner, by, emit);
  if (target === 'handles') return nudge(state, by, emit);
  if (target === 'crosshair') return moveCrosshair(state, by, emit);
  return target ? moveCamera(state, panned(state.view.camera, scaled(by, -PAN_CSS_PX))) : state;
}

function moveCrosshair(state: EditorState, by: Vec, emit: Emit): EditorState {
  const at = crosshairMoved(state, by, draftOf(state.tools)?.corners.at(-1));
  // A stroke of the pointer is in progress: it must not become one of the keys.
  if (isBrushing(state) && isPressing(state.tools) && !isHeldByKeys(state)) return state;
  if (isHeldByKeys(state)) {
    const outcome = pressMove(state.tools, pressAt(at), contextWithoutHandles(state));
    const pushed = applyTools(state, outcome, emit);
    return { ...pushed, display: { ...pushed.display, crosshair: at } };
  }
  const tools = hover(state.tools, pressAt(at), toolContext(state));
  const moved = { ...state, tools, display: { ...state.display, crosshair: at } };
  return announce(moved, say('spoken.at', Math.round(at[0]), Math.round(at[1])));
}

/** A push needs a direction: the picture is held, and arrows lead it. */
function hold(state: EditorState, emit: Emit): EditorState {
  const crosshair = crosshairPlace(state);
  const outcome = pressDown(state.tools, pressAt(crosshair), contextWithoutHandles(state));
  const held = applyTools(state, outcome, emit);
  const shown = { ...held, display: { ...held.display, crosshair } };
  return isPressing(held.tools) ? announce(shown, say('spoken.held')) : shown;
}

/** Places a handle or sets a corner at the crosshair; without a crosshair, finishes the current drawing. */
function place(before: EditorState, emit: Emit): EditorState {
  if (isHeldByKeys(before)) return releaseByKeys(before, emit);
  // A press of the pointer is in progress: ignore the key.
  if (!takesPlace(before) || isPressing(before.tools)) return before;
  if (draftOf(before.tools) && !before.display.crosshair) return finish(before, emit);
  if (isBrushing(before) && before.brush.kind === 'push') return hold(before, emit);
  const press = pressAt(crosshairPlace(before));
  const down = applyTools(before, pressDown(before.tools, press, contextWithoutHandles(before)), emit);
  const up = applyTools(down, pressUp(down.tools, press, contextWithoutHandles(down)), emit);
  const [added] = selectionOf(up);
  if (added !== undefined && handleById(documentOf(up), added)) focus(emit, added);
  // A person continues with the brush from there.
  return isBrushing(up) ? up : hideCrosshair(up);
}

export const keyHandlers: Handlers<
  'space-held' | 'alt-held' | 'arrow-pressed' | 'turn-pressed' | 'place-pressed'
> = {
  'space-held': (state, { held }) =>
    state.pointer.space === held ? state : withPointer(state, { space: held }),
  'alt-held': (state, { held }) => holdAlt(state, held),
  'arrow-pressed': (state, { by }, emit) => arrow(state, by, emit),
  'turn-pressed': (state, { degrees, scale }, emit) =>
    takesTurn(state) ? turn(state, degrees, scale, emit) : state,
  'place-pressed': (state, _, emit) => place(state, emit),
};
