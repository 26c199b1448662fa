/** Running the commands of buttons, menus and keys. */

import { say } from '../../texts/wording';
import {
  bailOut,
  cancelPress,
  draftOf,
  hasTakenCorners,
  isPressing,
  pressDown,
  pressUp,
  redoCorner,
  TOOLS,
  takeBackCorner,
} from '../../tools/machine';
import { pressAt } from '../../tools/state';
import { canRun, reasonAgainst } from '../can_run';
import type { CommandName } from '../commands';
import { hideCrosshair } from '../crosshair';
import type { Emit } from '../effects';
import { contextWithoutHandles } from '../hit_areas';
import { holdsKeys } from '../keys_in_hand';
import type { MenuState } from '../menu_state';
import { mayEdit } from '../permissions';
import { stem } from '../picture';
import { ringCornerInHand } from '../ring_corner';
import { handleWords } from '../selection_words';
import { type EditorState, filedProject, projectOf, selectionOf } from '../state';
import { fitView, showActualSize, zoom } from '../view';
import { resizeBrush, switchBrush } from './brush';
import { mirrorSelectedKeys, pasteKeys, removeSelectedKeys, selectAllKeys, setKeys } from './clip_keys';
import { withTimeline } from './clip_slice';
import { copyKeys, copyPose } from './clipboard';
import { addCornerToSelected, focus, removeFocusedCorner } from './corners';
import { openSettings, togglePreview } from './display';
import { mirror, raise, removeSelected, reset } from './edits';
import { cancelExport, exportChosen, exportPicture, projectForFile } from './exporting';
import type { Handlers } from './handlers';
import { turnPart } from './lasso';
import { addRingCorner, removeRingCorner } from './lasso_corners';
import { announce, dismiss, shownNotice } from './notices';
import { openTimeline, play } from './playhead';
import { applyTools } from './press';
import { renameSelected } from './renaming';
import { select } from './selection';
import { redo, undo } from './steps';
import { showStudy } from './study';
import { askForHandles, stopSuggesting } from './suggesting';
import { takeTool } from './tool_choice';
import { leaveFolds } from './unfolding';

type Run = (state: EditorState, emit: Emit, menu: MenuState | null) => EditorState;

/** An edit runs only while people may change the document. */
const edit =
  (change: Run): Run =>
  (state, emit, menu) =>
    mayEdit(state) ? change(state, emit, menu) : state;

const takeBack: Run = (state, emit) => applyTools(state, takeBackCorner(state.tools), emit);
const isDrawing = ({ tools }: EditorState): boolean => draftOf(tools) !== null;

const effect =
  (type: 'pick-file' | 'paste' | 'toggle-keys' | 'toggle-export'): Run =>
  (state, emit) => {
    emit({ type });
    return state;
  };

const RUN: Readonly<Record<CommandName, Run>> = {
  select: (state, emit) => takeTool(state, 'select', emit),
  point: (state, emit) => takeTool(state, 'point', emit),
  bar: (state, emit) => takeTool(state, 'bar', emit),
  polygon: (state, emit) => takeTool(state, 'polygon', emit),
  lasso: (state, emit) => takeTool(state, 'lasso', emit),
  brush: (state, emit) => takeTool(state, 'brush', emit),
  'brush-erase': (state) => switchBrush(state),
  'brush-smaller': (state) => resizeBrush(state, -1),
  'brush-larger': (state) => resizeBrush(state, 1),
  hand: (state, emit) => takeTool(state, 'hand', emit),
  timeline: (state, emit) => openTimeline(state, !state.timeline.open, emit),
  play: (state, emit) => play(state, !state.timeline.playing, emit),
  'set-key': edit((state, emit) => setKeys(state, emit)),
  'copy-keys': copyKeys,
  'cut-keys': edit((state, emit) => removeSelectedKeys(copyKeys(state, emit), emit)),
  'paste-keys': edit((state, emit) => pasteKeys(state, state.timeline.copied, emit)),
  'mirror-keys': edit(mirrorSelectedKeys),
  'remove-keys': edit(removeSelectedKeys),
  'select-all-keys': selectAllKeys,
  lens: (state, emit) => showStudy(state, state.study.page === 'lens' ? null : 'lens', emit),
  open: effect('pick-file'),
  save: (state, emit) => save(state, false, emit),
  'save-whole': (state, emit) => save(state, true, emit),
  export: exportChosen,
  'export-as': effect('toggle-export'),
  'export-all': (state, emit) => exportPicture(state, emit, { instead: { area: 'grown' } }),
  'export-whole': (state, emit) =>
    exportPicture(state, emit, { instead: { format: 'png' }, holdsPicture: true }),
  // During a drawing, undo takes back its last corner.
  undo: edit((state, emit, menu) => (isDrawing(state) ? takeBack(state, emit, menu) : undo(state, emit))),
  redo: edit((state, emit) =>
    isDrawing(state) || hasTakenCorners(state.tools)
      ? applyTools(state, redoCorner(state.tools), emit)
      : redo(state, emit),
  ),
  reset: edit((state, emit) => reset(state, false, emit)),
  'reset-all': edit((state, emit) => reset(state, true, emit)),
  mirror: edit((before, emit) => {
    const state = mirror(before, emit);
    // Keys act on the focused handle: the one that was posed.
    if (before.focus.on === 'handle' || before.focus.on === 'corner') focus(emit, selectionOf(state)[0]);
    return state;
  }),
  suggest: edit((state, emit) => askForHandles(state, emit)),
  'without-folds': edit((state, emit) => leaveFolds(state, emit)),
  rename: edit(renameSelected),
  remove: edit((state, emit, menu) =>
    isDrawing(state)
      ? takeBack(state, emit, menu)
      : ringCornerInHand(state)
        ? removeRingCorner(state, emit)
        : removeSelected(state, emit),
  ),
  copy: copyPose,
  paste: effect('paste'),
  'add-point': edit((before, emit, menu) => {
    if (!menu) return before;
    const state = applyTools(before, cancelPress(before.tools), emit);
    const press = pressAt(menu.at);
    const down = applyTools(
      state,
      pressDown(state.tools, press, contextWithoutHandles(state), TOOLS.point),
      emit,
    );
    const up = applyTools(down, pressUp(down.tools, press, contextWithoutHandles(down)), emit);
    focus(emit, selectionOf(up)[0]);
    return up;
  }),
  'turn-part': edit(turnPart),
  'add-corner': edit((state, emit, menu) =>
    ringCornerInHand(state) ? addRingCorner(state, emit) : addCornerToSelected(state, menu?.at ?? null, emit),
  ),
  'remove-corner': edit((state, emit) =>
    ringCornerInHand(state) ? removeRingCorner(state, emit) : removeFocusedCorner(state, emit),
  ),
  forward: edit((state, emit) => raise(state, 1, emit)),
  backward: edit((state, emit) => raise(state, -1, emit)),
  settings: (state) => openSettings(state, !state.display.settings),
  'select-all': (state, emit) => {
    const { handles } = projectOf(state);
    const selected = select(
      state,
      handles.map(({ id }) => id),
      emit,
    );
    return handles.length > 0 ? announce(selected, say('spoken.selected', handleWords(handles))) : selected;
  },
  compare: (state, emit) => togglePreview(state, 'compare', emit),
  preview: (state, emit) => togglePreview(state, 'preview', emit),
  fit: (state) => fitView(state),
  actual: showActualSize,
  'zoom-in': (state) => zoom(state, 1),
  'zoom-out': (state) => zoom(state, -1),
  keys: effect('toggle-keys'),
  bail: (state, emit) => bail(state, emit),
};

/** What Escape would cancel or dismiss: the innermost thing in progress. */
function bailTarget(
  state: EditorState,
):
  | 'press'
  | 'crosshair'
  | 'settings'
  | 'suggestion'
  | 'export'
  | 'notice'
  | 'keys'
  | 'selection'
  | 'study'
  | null {
  const notice = shownNotice(state);
  if (isPressing(state.tools) || isDrawing(state)) return 'press';
  if (state.display.crosshair) return 'crosshair';
  if (state.display.settings) return 'settings';
  if (state.suggesting) return 'suggestion';
  if (state.exporting.running) return 'export';
  if (notice && !notice.action) return 'notice';
  if (holdsKeys(state)) return 'keys';
  // The lens looks through the selection.
  if (state.tools.tool === 'lens' && state.study.page) return 'study';
  if (selectionOf(state).length > 0) return 'selection';
  if (notice) return 'notice';
  return state.study.page ? 'study' : null;
}

/** Whether Escape is the editor's. Waiting input may begin something that it ends. */
export const takesBail = (state: EditorState): boolean =>
  state.waiting.length > 0 || bailTarget(state) !== null;

function bail(state: EditorState, emit: Emit): EditorState {
  switch (bailTarget(state)) {
    case 'press':
      return applyTools(state, bailOut(state.tools), emit);
    case 'crosshair':
      return hideCrosshair(state);
    case 'settings':
      return openSettings(state, false);
    case 'suggestion':
      return stopSuggesting(state, emit);
    case 'export':
      return cancelExport(state, emit);
    case 'notice':
      return dismiss(state, emit);
    case 'keys':
      return withTimeline(state, { selected: [] });
    case 'selection':
      return select(state, [], emit);
    case 'study':
      return showStudy(state, null, emit);
    case null:
      return state;
  }
}

/** Mirroring twice changes nothing, and once keys are gone their handle would be next. */
const ONCE: readonly CommandName[] = ['mirror', 'mirror-keys', 'remove', 'remove-keys'];

/** Whether a command runs again while its key is held. */
export const repeats = (state: EditorState, command: CommandName): boolean =>
  isDrawing(state) || !ONCE.includes(command);

/** @param whole the file holds the picture too. */
function save(state: EditorState, whole: boolean, emit: Emit): EditorState {
  const project = projectForFile(state);
  const name = `${stem(project.image.src)}.c2warp.json`;
  const of = filedProject(state);
  emit({ type: 'save-project', name, project, of, picture: whole ? state.picture : null });
  return state;
}

export const commandHandlers: Handlers<'command-run'> = {
  'command-run': (state, { command, menu = null }, emit) => {
    // A menu closes before its command runs, which may depend on the menu.
    if (canRun(menu ? { ...state, menu } : state, command)) return RUN[command](state, emit, menu);
    const reason = mayEdit(state) ? reasonAgainst(state, command) : null;
    return reason === null ? state : announce(state, reason);
  },
};
