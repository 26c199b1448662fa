/** The document in the state, and small changes of it. */
import type { Document } from '../../document/document';
import type { History } from '../../document/history';
import { endGuarding } from '../fold_guard';
import type { DocumentState, EditorState } from '../state';

export const withDocument = (state: EditorState, change: Partial<DocumentState>): EditorState => ({
  ...state,
  document: { ...state.document, ...change },
});

export const withHistory = (state: EditorState, next: History<Document>): EditorState =>
  withDocument(state, { history: next });

export const guardEnded = (state: EditorState): EditorState => ({
  ...state,
  guard: endGuarding(state.guard),
});
