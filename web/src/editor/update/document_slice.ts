/** The document in the state, and small changes of it. */
import { type Document, isSameWork } from '../../document/document';
import * as history from '../../document/history';
import { absorbed, atMoment, type IsFree } from '../../document/moment';
import { withShape } from '../../document/shape';
import type { Crossing } from '../crossing';
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

/** Ends the open step. The picture keeps the shape in which the drag has left it. */
export function committed(state: EditorState): EditorState {
  const { history: steps } = state.document;
  const present = steps.open
    ? shapeKept(state, landed(state, steps.open.value, steps.present))
    : steps.present;
  return withHistory(state, history.commit(history.update(steps, present), isSameWork));
}

/**
 * A document that a step has changed. In the timeline, changes of poses become keys. Of a clip that the page shows, the
 * pose becomes the document's own.
 */
export function landed(state: EditorState, before: Document, after: Document): Document {
  if (state.timeline.open) return absorbed(before, after, isFreeIn(state, before));
  const { moment: _, ...own } = after;
  return after.moment && after !== before ? own : after;
}

/** A document after a drag, with the shape in which the picture comes to rest. The poses of clips have no shape. */
export function shapeKept({ solution }: EditorState, document: Document): Document {
  const deformation = solution.shown?.deformation;
  if (!deformation || document.moment) return document;
  const project = withShape(document.project, deformation.shapeLeft(document.project));
  return project === document.project ? document : { ...document, project };
}

/** Answers for the clip that a document has. */
export function isFreeIn({ solution }: EditorState, document: Document): IsFree {
  const deformation = solution.shown?.deformation;
  const { moment } = document;
  if (!deformation || !moment) return () => false;
  return (handle, time) =>
    deformation.lead(atMoment(document, moment.clip, time, deformation.posesAt).project, [handle]) > 0;
}

/** Notes the depths that a crossing has decided. */
export const noteDepths = (state: EditorState, { depths }: Crossing): EditorState =>
  withDocument(state, { automaticDepths: new Map([...state.document.automaticDepths, ...depths]) });

/** Depths that a person has given to handles are not automatic. */
export const forgetDepths = (state: EditorState, ids: readonly string[]): EditorState =>
  withDocument(state, {
    automaticDepths: new Map([...state.document.automaticDepths].filter(([id]) => !ids.includes(id))),
  });
