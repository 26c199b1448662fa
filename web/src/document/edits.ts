/** Changes of a document, each a pure function from the document before to the document after. */
import type { LinePlace } from '../geometry/polyline';
import type { Vec } from '../geometry/vec';
import { restingRotation } from './bending';
import { type Document, handleById, selectedHandles } from './document';
import {
  atDepth,
  atRest,
  checkedHandle,
  cornerAdded,
  cornerPut,
  cornerRemoved,
  depthOf,
  isLine,
  moved,
  posedLike,
  turnedTo,
} from './handle';
import type { Handle, LineHandle, Project } from './project';

const withHandles = (document: Document, handles: readonly Handle[]): Document => ({
  ...document,
  project: { ...document.project, handles },
});

/** The document with `change` applied to every handle named. */
export const changeHandles = (
  document: Document,
  ids: readonly string[],
  change: (handle: Handle) => Handle,
): Document =>
  withHandles(
    document,
    document.project.handles.map((handle) => (ids.includes(handle.id) ? change(handle) : handle)),
  );

/** The document with these handles in place of those with the same ids. */
export function putHandles(document: Document, handles: readonly Handle[]): Document {
  const put = new Map(handles.map((handle) => [handle.id, handle]));
  return withHandles(
    document,
    document.project.handles.map((handle) => put.get(handle.id) ?? handle),
  );
}

export interface Pasted {
  readonly document: Document;
  /** Copied handles that no handle is posed like. */
  readonly unmatched: readonly Handle[];
}

/**
 * The document with handles posed like the copied ones of the same id and kind, or the selected ones like the only one
 * copied, if they are of its kind. Handles keep their rest places: a pose is how far they are from there.
 *
 * @throws RangeError where that leads a handle to numbers that the solver cannot pose.
 */
export function pastePose(document: Document, copied: readonly Handle[]): Pasted {
  const [only, ...others] = copied;
  const chosen = selectedHandles(document).filter(({ kind }) => kind === only?.kind);
  if (only && others.length === 0 && chosen.length > 0) {
    const posed = chosen.map((handle) => checkedHandle(posedLike(handle, only)));
    return { document: putHandles(document, posed), unmatched: [] };
  }
  const counterpart = ({ id, kind }: Handle) => {
    const handle = handleById(document, id);
    return handle?.kind === kind ? handle : undefined;
  };
  const posed = copied.flatMap((like) => {
    const handle = counterpart(like);
    return handle ? checkedHandle(posedLike(handle, like)) : [];
  });
  return { document: putHandles(document, posed), unmatched: copied.filter((like) => !counterpart(like)) };
}

const changeLine = (document: Document, id: string, change: (handle: LineHandle) => LineHandle): Document =>
  changeHandles(document, [id], (handle) => (isLine(handle) ? change(handle) : handle));

/** Adds a handle at the end and selects it alone. */
export const addHandle = (document: Document, handle: Handle): Document => ({
  ...withHandles(document, [...document.project.handles, handle]),
  selection: [handle.id],
});

export const removeHandles = (document: Document, ids: readonly string[]): Document => ({
  ...withHandles(
    document,
    document.project.handles.filter((handle) => !ids.includes(handle.id)),
  ),
  selection: document.selection.filter((id) => !ids.includes(id)),
});

export const moveHandles = (document: Document, ids: readonly string[], by: Vec): Document =>
  changeHandles(document, ids, (handle) => moved(handle, by));

/** Turns each handle about its own anchor to the rotation that `degrees` returns for it. */
export const turnHandles = (
  document: Document,
  ids: readonly string[],
  degrees: (handle: Handle) => number,
): Document => changeHandles(document, ids, (handle) => turnedTo(handle, degrees(handle)));

/** Moves one corner of a handle; the handle's turn continues from `before` (degrees). */
export const putCorner = (
  document: Document,
  id: string,
  index: number,
  at: Vec,
  before?: number,
): Document => changeLine(document, id, (handle) => cornerPut(handle, index, at, before));

/** Adds a corner on an edge of a handle. */
export const addCorner = (document: Document, id: string, at: LinePlace): Document =>
  changeLine(document, id, (handle) => cornerAdded(handle, at));

/** Removes one corner of a handle. */
export const removeCorner = (document: Document, id: string, index: number): Document =>
  changeLine(document, id, (handle) => cornerRemoved(handle, index));

/** Adds `by` to the depth of handles: positive is nearer to the eye. */
export const raiseHandles = (document: Document, ids: readonly string[], by: number): Document =>
  changeHandles(document, ids, (handle) => atDepth(handle, depthOf(handle) + by));

/** Sets whether the boundary of the warped area stays where it is. */
export const holdBoundary = (document: Document, held: boolean): Document => ({
  ...document,
  project: { ...document.project, fix_boundary: held },
});

export const resetHandles = (document: Document, ids: readonly string[]): Document =>
  changeHandles(document, ids, (handle) => atRest(handle, restingRotation(document.project)));

/** The selection, without repeats and without ids that name no handle. */
export function selectHandles(document: Document, ids: readonly string[]): Document {
  const known = new Set(document.project.handles.map((handle) => handle.id));
  return { ...document, selection: [...new Set(ids)].filter((id) => known.has(id)) };
}

/** A free id such as "bar-2". Numbers start after the count of ids with this word, so that ids are rarely reused. */
export function freeId(project: Project, word = 'handle'): string {
  const taken = new Set(project.handles.map((handle) => handle.id));
  let number = project.handles.filter(({ id }) => id.startsWith(`${word}-`)).length + 1;
  while (taken.has(`${word}-${number}`)) number++;
  return `${word}-${number}`;
}
