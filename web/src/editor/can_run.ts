/** Whether a command can run now: one answer for buttons, menus, keys and the element. */
import { handleById, selectedHandles } from '../document/document';
import { CORNERS_NEEDED, DEPTHS, depthOf, isAtRest, isLine } from '../document/handle';
import { redoLabel, undoLabel } from '../document/history';
import type { Handle } from '../document/project';
import { draftOf, hasTakenCorners } from '../tools/machine';
import type { CommandName } from './commands';
import { documentOf, type EditorState, projectOf } from './state';
import { depthWords } from './wording';

export const canRun = (state: EditorState, command: CommandName): boolean =>
  !state.page.disabled && (CONDITIONS[command]?.(state) ?? true);

/** Why a command cannot run, where its key should say so; null if nothing is to be said. */
export function reasonAgainst(state: EditorState, command: CommandName): string | null {
  if (command === 'forward' || command === 'backward') return depthWords(documentOf(state));
  const corner = state.menu?.corner ?? state.focus.corner;
  const line = command === 'remove-corner' && corner ? lineInHand(state) : null;
  return line ? `A ${line.kind} needs ${CORNERS_NEEDED[line.kind]} corners` : null;
}

const isOpen = ({ picture }: EditorState): boolean => picture !== null;
const isChangeable = ({ page }: EditorState): boolean => !page.readonly;
const hasHandles = (state: EditorState): boolean =>
  isChangeable(state) && projectOf(state).handles.length > 0;

/** Whether any selected handle may be changed, and the change makes a difference to it. */
const someSelected =
  (differs: (handle: Handle) => boolean) =>
  (state: EditorState): boolean =>
    isChangeable(state) && selectedHandles(documentOf(state)).some(differs);

/** The bar or polygon whose corners the menu, the focus or the selection means. */
function lineInHand(state: EditorState) {
  const document = documentOf(state);
  const corner = state.menu?.corner ?? state.focus.corner;
  const [only, ...others] = selectedHandles(document);
  const line = corner ? handleById(document, corner.id) : others.length === 0 ? only : undefined;
  return line && isLine(line) ? line : null;
}

const isDrawing = ({ tools }: EditorState): boolean => draftOf(tools) !== null;

/** Commands that are missing can always run. */
const CONDITIONS: Partial<Readonly<Record<CommandName, (state: EditorState) => boolean>>> = {
  select: isChangeable,
  point: isChangeable,
  bar: isChangeable,
  polygon: isChangeable,
  lasso: isChangeable,
  open: isChangeable,
  save: isOpen,
  'save-whole': isOpen,
  'export-whole': isOpen,
  export: isOpen,
  'export-all': isOpen,
  compare: isOpen,
  preview: isOpen,
  settings: isOpen,
  undo: (state) =>
    isOpen(state) && isChangeable(state) && (isDrawing(state) || undoLabel(state.document.history) !== null),
  redo: (state) => {
    if (!isOpen(state) || !isChangeable(state)) return false;
    return hasTakenCorners(state.tools) || (!isDrawing(state) && redoLabel(state.document.history) !== null);
  },
  'reset-all': (state) => isChangeable(state) && !projectOf(state).handles.every(isAtRest),
  'select-all': hasHandles,
  copy: hasHandles,
  paste: hasHandles,
  reset: someSelected((handle) => !isAtRest(handle)),
  mirror: someSelected(() => true),
  remove: (state) => isDrawing(state) || someSelected(() => true)(state),
  forward: someSelected((handle) => depthOf(handle) !== DEPTHS.most),
  backward: someSelected((handle) => depthOf(handle) !== DEPTHS.least),
  'add-point': ({ menu }) => menu?.bends === true,
  'add-corner': (state) => isChangeable(state) && lineInHand(state) !== null,
  'remove-corner': (state) => {
    const line = lineInHand(state);
    return isChangeable(state) && line !== null && line.posed.length > CORNERS_NEEDED[line.kind];
  },
};
