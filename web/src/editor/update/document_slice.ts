/** The document in the state, and small changes of it. */
import { type Document, isSameWork } from '../../document/document';
import * as history from '../../document/history';
import { absorbed } from '../../document/moment';
import { endGuarding } from '../fold_guard';
import type { DocumentState, EditorState } from '../state';

export const withDocument = (state: EditorState, change: Partial<DocumentState>): EditorState => ({
  ...state,
  document: { ...state.document, ...change },
});

export const withHistory = (state: EditorState, next: history.History<Document>): EditorState =>
  withDocument(state, { history: next });

export const guardEnded = (state: EditorState): EditorState => ({
  ...state,
  guard: endGuarding(state.guard),
});

/** Ends the open step. */
export function committed(state: EditorState): EditorState {
  const { history: steps } = state.document;
  const present = steps.open ? landed(state, steps.open.value, steps.present) : steps.present;
  return withHistory(state, history.commit(history.update(steps, present), isSameWork));
}

/**
 * A document that a step has changed. In the timeline, changes of poses become keys. Of a clip that the page shows, the
 * pose becomes the document's own.
 */
export function landed({ timeline }: EditorState, before: Document, after: Document): Document {
  if (timeline.open) return absorbed(before, after);
  const { moment: _, ...own } = after;
  return after.moment && after !== before ? own : after;
}
