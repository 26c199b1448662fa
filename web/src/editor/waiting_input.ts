/**
 * Input that comes before its picture.
 *
 * A person who has requested a picture may continue immediately: that input is for the new picture. It waits until the
 * picture is on the stage. Then it is carried out in its order, event by event, as if it came then. If the picture is
 * refused, its input is dropped with it.
 */
import { isAtRest } from '../document/handle';
import type { Vec } from '../geometry/vec';
import { isPressing, isToolName, type ToolName } from '../tools/machine';
import type { CommandName } from './commands';
import type { EditorEvent } from './events';
import { isOpening } from './opening_state';
import { mayChange } from './permissions';
import { type EditorState, projectOf } from './state';

/** Input that is for the picture on the stage. */
const FOR_PICTURE: ReadonlySet<EditorEvent['type']> = new Set([
  'press-began',
  'press-moved',
  'press-ended',
  'press-cancelled',
  'double-pressed',
  'arrow-pressed',
  'turn-pressed',
  'place-pressed',
  'drawing-finished',
  'corner-taken-back',
  'text-pasted',
]);

/** Commands that are not about the document, or that the browser allows only at once. */
const AT_ONCE: ReadonlySet<CommandName> = new Set([
  'open',
  'save',
  'save-whole',
  'export',
  'export-as',
  'export-all',
  'export-whole',
  'copy',
  'copy-keys',
  'paste',
  'compare',
  'preview',
  'settings',
  'fit',
  'actual',
  'zoom-in',
  'zoom-out',
  'keys',
]);

const isForPicture = (event: EditorEvent): boolean =>
  FOR_PICTURE.has(event.type) || (event.type === 'command-run' && !AT_ONCE.has(event.command));

/** The tool that an event chooses, or null. */
export const chosenTool = (event: EditorEvent): ToolName | null =>
  event.type === 'command-run' && isToolName(event.command) ? event.command : null;

/** The current tool once the waiting input is carried out. It is shown at once. */
export const toolToCome = ({ waiting, tools }: EditorState): ToolName =>
  waiting.map(chosenTool).findLast((tool) => tool !== null) ?? tools.tool;

/** Where waiting presses began, CSS pixels of the stage. */
export const waitingPlaces = ({ waiting }: EditorState): readonly Vec[] =>
  waiting.flatMap((event) => (event.type === 'press-began' ? [event.pointer.stage] : []));

/** Input that does not refer to the previous picture. */
const isNew = (event: EditorEvent): boolean =>
  event.type === 'press-began' ||
  event.type === 'place-pressed' ||
  chosenTool(event) !== null ||
  (event.type === 'command-run' && event.command === 'suggest');

/** Mirroring asks the solution where the other side is. */
const needsSolution = (event: EditorEvent): boolean =>
  event.type === 'command-run' && event.command === 'mirror';

/** Whether the picture that a person works on next is still to come. `input` is to be carried out on it. */
export function awaitsPicture(state: EditorState, input = state.waiting): boolean {
  const { picture, opening, solution, tools } = state;
  // An earlier press continues, and belongs to the picture on which it began.
  if (!mayChange(state) || isPressing(tools)) return false;
  if (!picture) return isOpening(opening);
  const { reading, trial } = opening;
  // The page replaces the picture, and the person continues with the previous one until then.
  if (reading) return reading.purpose.by !== 'load' && reading.purpose.by !== 'attributes';
  // Only a solution determines the positions in a bent picture.
  const isBent = () => !projectOf(state).handles.every(isAtRest);
  return trial !== null && solution.shown === null && (input.some(needsSolution) || isBent());
}

/** Whether an event waits for the picture to come. */
export function waits(state: EditorState, event: EditorEvent): boolean {
  const { picture, waiting, opening } = state;
  if (!isForPicture(event)) return false;
  // Behind input that is being released.
  if (waiting.length > 0) return true;
  return awaitsPicture(state, [event]) && (opening.reading === null || !picture || isNew(event));
}
