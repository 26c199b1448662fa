/** Tells the page the tool in hand. */
import type { Emit } from '../effects';
import type { EditorState } from '../state';
import { withDocument } from './document_slice';

export function reportTool(state: EditorState, emit: Emit): EditorState {
  const { tool } = state.tools;
  const { reported } = state.document;
  if (tool === reported.tool) return state;
  emit({ type: 'notify-page', notification: { type: 'toolchange', tool } });
  return withDocument(state, { reported: { ...reported, tool } });
}
