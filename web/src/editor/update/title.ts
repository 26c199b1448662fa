/** Tells the page the title of the document: the picture's name, and whether there are unsaved changes. */
import type { Emit } from '../effects';
import { type EditorState, isUnsaved } from '../state';
import { withDocument } from './document_slice';

export function reportTitle(state: EditorState, emit: Emit): EditorState {
  const { picture, document, opening } = state;
  if (opening.trial) return state;
  const { reported } = document;
  const [name, unsaved] = [picture?.name ?? null, isUnsaved(state)];
  if (name === (reported.title?.name ?? null) && unsaved === (reported.title?.unsaved ?? false)) return state;
  const title = name === null ? null : { name, unsaved };
  emit({ type: 'notify-page', notification: { type: 'titlechange', title } });
  return withDocument(state, { reported: { ...reported, title } });
}
