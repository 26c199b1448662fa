/** Renaming a handle: the panel shows a field for its name. A new name is one undo step. */

import { handleById } from '../../document/document';
import { isLine, nameOf } from '../../document/handle';
import { nameFault, nameWords, renameHandle, tidyName } from '../../document/names';
import type { Vec } from '../../geometry/vec';
import { say } from '../../texts/wording';
import { hit } from '../../tools/hit';
import type { Emit } from '../effects';
import { toolContext } from '../hit_areas';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, projectOf, type Renaming, selectionOf } from '../state';
import { focus, toggleCorner } from './corners';
import { openSettings } from './display';
import { withDocument } from './document_slice';
import type { Handlers } from './handlers';
import { announce, inform } from './notices';
import { select } from './selection';
import { step } from './steps';
import { showStudy } from './study';

const withRenaming = (state: EditorState, renaming: Renaming | null): EditorState => ({
  ...state,
  display: { ...state.display, renaming },
});

/** Shows the field for the name of a handle, and selects only that handle. */
function beginRenaming(before: EditorState, id: string, emit: Emit): EditorState {
  if (!mayEdit(before) || !handleById(documentOf(before), id)) return before;
  emit({ type: 'focus-control', control: 'name' });
  const state = showStudy(select(before, [id], emit), null, emit);
  return withRenaming(state.display.settings ? openSettings(state, false) : state, { id, fault: null });
}

/** Renames the only selected handle. */
export function renameSelected(state: EditorState, emit: Emit): EditorState {
  const [id, ...others] = selectionOf(state);
  return id !== undefined && others.length === 0 ? beginRenaming(state, id, emit) : state;
}

/** A double click renames a point, or the polygon around it. On a line it adds or removes a corner. */
export function doublePress(state: EditorState, at: Vec, emit: Emit): EditorState {
  const context = toolContext(state);
  const under = hit(context, at);
  const handle = under?.part === 'handle' ? handleById(documentOf(state), under.id) : undefined;
  const isName = handle && (!isLine(handle) || !hit(context, at, false));
  return isName ? beginRenaming(state, handle.id, emit) : toggleCorner(state, at, emit);
}

function typed(state: EditorState, name: string): EditorState {
  const { renaming } = state.display;
  if (!renaming) return state;
  const fault = nameFault(projectOf(state), renaming.id, tidyName(name));
  if (fault === renaming.fault) return state;
  const next = withRenaming(state, { ...renaming, fault });
  return fault ? announce(next, say(`panel.nameFaults.${fault}`)) : next;
}

function given(before: EditorState, text: string, keyed: boolean, emit: Emit): EditorState {
  const state = typed(before, text);
  const { renaming } = state.display;
  // A field that goes is left too.
  if (!renaming) return state;
  const { id, fault } = renaming;
  const handle = handleById(documentOf(state), id);
  if (fault && keyed) return state;
  const ended = withRenaming(state, null);
  if (!handle || !mayEdit(ended)) return ended;
  if (fault) return inform(ended, say(`notices.nameStays.${fault}`, nameWords(handle)), emit);
  const name = tidyName(text);
  const isNew = ![text, name].includes(nameOf(handle));
  if (keyed) focus(emit, isNew ? name : id);
  return isNew ? renamed(ended, id, name, emit) : ended;
}

function renamed(state: EditorState, id: string, name: string, emit: Emit): EditorState {
  const { drawn } = state.document;
  const follows = drawn?.handle.id === id ? { ...drawn, handle: { ...drawn.handle, id: name } } : drawn;
  const label = say('steps.rename', nameWords({ id }), name);
  return step(
    withDocument(state, { drawn: follows }),
    label,
    renameHandle(documentOf(state), id, name),
    emit,
  );
}

export const renamingHandlers: Handlers<'rename-asked' | 'name-typed' | 'name-given' | 'renaming-ended'> = {
  'rename-asked': (state, { id }, emit) => beginRenaming(state, id, emit),
  'name-typed': (state, { name }) => typed(state, name),
  'name-given': (state, { name, keyed }, emit) => given(state, name, keyed, emit),
  'renaming-ended': (state, _, emit) => {
    if (state.display.renaming) focus(emit, state.display.renaming.id);
    return withRenaming(state, null);
  },
};
