/** Opening the context menu for a place, and running its commands. */

import { handleById } from '../../document/document';
import { anchor, isLine } from '../../document/handle';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import type { Hit } from '../../tools/hit';
import { cancelPress, drawingOf, isPressing, places } from '../../tools/machine';
import { withoutRings } from '../../tools/pressing';
import type { Corner } from '../corner';
import { crosshairPlace } from '../crosshair';
import type { Emit } from '../effects';
import type { Focus } from '../focus';
import { hitAt, isLassoing, pressOf, toolContext } from '../hit_areas';
import { mayEdit } from '../permissions';
import { selectionName } from '../selection_words';
import type { StagePointer } from '../stage_pointer';
import { documentOf, type EditorState, selectionOf } from '../state';
import { reveal } from '../view';
import { awaitsPicture } from '../waiting_input';
import { focus } from './corners';
import type { Handlers } from './handlers';
import { releaseByKeys } from './held_by_keys';
import { closeMenu } from './menu_closing';
import { noteKind } from './pointer';
import { applyTools } from './press';
import { select, withoutKeys } from './selection';

/** Whether there is a menu now: not during a drawing or a preview, nor where nothing can be changed. */
function hasMenu(state: EditorState): boolean {
  const { tools, display } = state;
  const drawing = drawingOf(tools) !== null;
  return (
    mayEdit(state) && !awaitsPicture(state) && display.preview === null && !isLassoing(state) && !drawing
  );
}

/** The part under a place that a menu would be about. */
const partUnder = (state: EditorState, at: Vec): Hit | null =>
  hitAt(state, at, state.tools.tool === 'select', withoutRings(toolContext(state)));

/** Whether a press would open a menu. Not for a finger that places something there. */
export function opensMenu(before: EditorState, pointer: StagePointer, resting: boolean): boolean {
  const state = noteKind(before, pointer.coarse);
  if (!hasMenu(state)) return false;
  if (resting && places(state.tools.tool) && !state.pointer.onHandle) return false;
  return !state.page.posable || partUnder(state, pressOf(state, pointer).at) !== null;
}

/** Whether the menu key opens a menu, or a press under way ignores it. */
export const takesMenuKey = (state: EditorState): boolean =>
  isPressing(state.tools) || (hasMenu(state) && (!state.page.posable || focusedPart(state) !== null));

/** The handle or the corner that has the focus. */
export function focusedPart({ focus: { on, handle, corner } }: EditorState): Hit | null {
  if (on === 'handle' && handle !== null) return { part: 'handle', id: handle };
  return on === 'corner' && corner ? { part: 'corner', id: corner.id, index: corner.index } : null;
}

/** Opens the menu about a part of a handle, which is selected then, or about the picture. */
function openMenu(before: EditorState, under: Hit | null, at: Vec, emit: Emit): EditorState {
  const selects = under && !selectionOf(before).includes(under.id);
  const closed = closeMenu(before, emit);
  const state = selects ? select(closed, [under.id], emit) : under ? withoutKeys(closed) : closed;
  const selection = selectionOf(state);
  // With several handles selected the menu is about all of them: a corner then stands for its handle.
  const alone = selection.length === 1;
  const corner = alone && under?.part === 'corner' ? { id: under.id, index: under.index } : null;
  if (under) focus(emit, under.id, corner?.index ?? null);
  else if (!isOnStage(state.focus)) focus(emit);
  const name = under ? selectionName(documentOf(state)) : say('stage.pictureMenu');
  emit({ type: 'show-menu', at });
  return {
    ...state,
    menu: {
      about: under ? 'handles' : 'picture',
      name: corner ? say('stage.cornerMenu', corner.index + 1, name) : name,
      corner,
      at,
      bends: toolContext(state).place(at) !== null,
      selection,
      focus: focusAfter(state, under, corner),
    },
  };
}

/** The focus once the menu has closed: where it was before, or on the handle that the menu was about. */
function focusAfter({ focus }: EditorState, under: Hit | null, corner: Corner | null): Focus {
  if (under) return { on: corner ? 'corner' : 'handle', handle: under.id, corner, ring: null };
  return isOnStage(focus) ? focus : { on: 'stage', handle: null, corner: null, ring: null };
}

const isOnStage = ({ on }: Focus): boolean => on === 'stage' || on === 'handle' || on === 'corner';

/** Opens the menu of the focused handle or corner, or of the picture. */
function openByKey(state: EditorState, emit: Emit): EditorState {
  if (isPressing(state.tools) || !takesMenuKey(state)) return state;
  const part = focusedPart(state);
  const handle = part && handleById(documentOf(state), part.id);
  const corner = handle && isLine(handle) && part.part === 'corner' ? handle.posed[part.index] : undefined;
  const at = corner ?? (handle ? anchor(handle) : crosshairPlace(state));
  return openMenu(state.page.posable ? state : reveal(state, at), part, at, emit);
}

export const menuHandlers: Handlers<'menu-asked' | 'menu-key-pressed' | 'menu-command-run'> = {
  'menu-asked': (before, { pointer, resting }, emit) => {
    if (!opensMenu(before, pointer, resting)) return before;
    const noted = noteKind(releaseByKeys(before, emit), pointer.coarse);
    const state = applyTools(noted, cancelPress(noted.tools), emit);
    const { at } = pressOf(state, pointer);
    return openMenu(state, partUnder(state, at), at, emit);
  },
  'menu-key-pressed': (state, _, emit) => openByKey(state, emit),
  'menu-command-run': (state, { command }, emit) => {
    if (command) emit({ type: 'follow-up', event: { type: 'command-run', command, menu: state.menu } });
    return closeMenu(state, emit);
  },
};
