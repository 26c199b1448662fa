/** Edits of a document: pure functions that return the changed document. */
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
  withoutNewDefaults,
} from './handle';
import { nameFault } from './names';
import type { Handle, LineHandle, Project } from './project';
import { withChangedCorners, withoutLostTracks } from './tracks';

const withHandles = (document: Document, handles: readonly Handle[]): Document => ({
  ...document,
  project: { ...document.project, handles },
});

/** Applies `change` to the handles with these ids. */
export const changeHandles = (
  document: Document,
  ids: readonly string[],
  change: (handle: Handle) => Handle,
): Document =>
  withHandles(
    document,
    document.project.handles.map((handle) =>
      ids.includes(handle.id) ? withoutNewDefaults(change(handle), handle) : handle,
    ),
  );

/** Replaces the handles with the same ids. Other ids are ignored. */
export function putHandles(document: Document, handles: readonly Handle[]): Document {
  const put = new Map(handles.map((handle) => [handle.id, handle]));
  return withHandles(
    document,
    document.project.handles.map((handle) => withoutNewDefaults(put.get(handle.id) ?? handle, handle)),
  );
}

export interface Pasted {
  readonly document: Document;
  /** Copied handles without a counterpart in the document. */
  readonly unmatched: readonly Handle[];
}

/**
 * Poses handles like the copied ones of the same id and kind. A single copied handle poses all selected handles of its
 * kind, if there are any. Rest positions stay: a pose is relative to them.
 *
 * @throws RangeError if the solver cannot pose a result.
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

/** Adds a handle at the end and selects only it. */
export const addHandle = (document: Document, handle: Handle): Document => ({
  ...withHandles(document, [...document.project.handles, handle]),
  selection: [handle.id],
});

/** Removes handles and their tracks. */
export function removeHandles(document: Document, ids: readonly string[]): Document {
  const { project, selection } = document;
  const handles = project.handles.filter((handle) => !ids.includes(handle.id));
  return {
    ...document,
    project: withoutLostTracks({ ...project, handles }),
    selection: selection.filter((id) => !ids.includes(id)),
  };
}

export const moveHandles = (document: Document, ids: readonly string[], by: Vec): Document =>
  changeHandles(document, ids, (handle) => moved(handle, by));

/** Turns each handle about its own anchor to the rotation that `degrees` returns for it. */
export const turnHandles = (
  document: Document,
  ids: readonly string[],
  degrees: (handle: Handle) => number,
): Document => changeHandles(document, ids, (handle) => turnedTo(handle, degrees(handle)));

/** Moves one corner of a handle. The handle's turn continues from `before`, in degrees. */
export const putCorner = (
  document: Document,
  id: string,
  index: number,
  at: Vec,
  before?: number,
): Document => changeLine(document, id, (handle) => cornerPut(handle, index, at, before));

/** Adds a corner on an edge of a handle. */
export const addCorner = (document: Document, id: string, at: LinePlace): Document =>
  changeCorners(document, id, (handle) => cornerAdded(handle, at));

/** Removes one corner of a handle. */
export const removeCorner = (document: Document, id: string, index: number): Document =>
  changeCorners(document, id, (handle) => cornerRemoved(handle, index));

/** Changes the corners of a handle, and those in the keys of its tracks. */
function changeCorners(document: Document, id: string, change: (handle: LineHandle) => LineHandle): Document {
  const handle = handleById(document, id);
  if (!handle || !isLine(handle)) return document;
  const changed = changeLine(document, id, change);
  return { ...changed, project: withChangedCorners(changed.project, handle, change) };
}

/** Adds `by` to the depth of handles: positive is nearer to the eye. */
export const raiseHandles = (document: Document, ids: readonly string[], by: number): Document =>
  changeHandles(document, ids, (handle) => atDepth(handle, depthOf(handle) + by));

/** Fixes or frees the boundary of the domain. */
export const holdBoundary = (document: Document, held: boolean): Document => ({
  ...document,
  project: { ...document.project, fix_boundary: held },
});

/** Draws or omits the edges where parts cross. */
export const withEdges = (document: Document, edges: boolean): Document => ({
  ...document,
  project: { ...document.project, edges },
});

export const resetHandles = (document: Document, ids: readonly string[]): Document =>
  changeHandles(document, ids, (handle) => atRest(handle, restingRotation(document.project)));

/** Selects handles. Repeated and unknown ids are ignored. */
export function selectHandles(document: Document, ids: readonly string[]): Document {
  const known = new Set(document.project.handles.map((handle) => handle.id));
  return { ...document, selection: [...new Set(ids)].filter((id) => known.has(id)) };
}

/**
 * Returns an id such as "bar-2" that reads like no other. Numbers start after the count of ids with this word: reuse is
 * rare.
 */
export function freeId(project: Project, word = 'handle'): string {
  let number = project.handles.filter(({ id }) => id.startsWith(`${word}-`)).length + 1;
  while (nameFault(project, '', `${word}-${number}`)) number++;
  return `${word}-${number}`;
}
