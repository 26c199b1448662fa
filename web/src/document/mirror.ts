/** Mirroring handles over the upright axis of what bends: their counterparts on the other side are posed as they are. */
import type { Box } from '../geometry/box';
import { distanceToLine } from '../geometry/polyline';
import { midpoint, type Vec } from '../geometry/vec';
import { type Document, selectedHandles } from './document';
import { addHandle, freeId, putHandles, selectHandles } from './edits';
import { corners, edges, isClosed, isLine, posedLike, rounded, roundedVec } from './handle';
import type { Handle, Project } from './project';

/**
 * How far a handle may rest from another's mirror image and still be its counterpart: a share of the larger side of what
 * bends. Two that were placed by eye differ by less.
 */
const NEAR = 1 / 32;

export interface Mirrored {
  readonly document: Document;
  /** Handles that are left out, as nothing bends on their other side. */
  readonly unmatched: readonly Handle[];
}

/**
 * The document with the counterparts of the selected handles posed as their mirror images, and selected. A counterpart
 * that is missing is added. Handles on the axis are their own counterparts, so that mirroring all flips the whole pose.
 *
 * @param bounds of what bends, at rest. The axis is its middle.
 * @param bends whether a place of the original is part of what bends.
 */
export function mirrorHandles(
  document: Document,
  { min, max }: Box,
  bends: (rest: Vec) => boolean,
): Mirrored {
  const axis = rounded((min[0] + max[0]) / 2);
  const near = NEAR * Math.max(max[0] - min[0], max[1] - min[1]);
  const { handles } = document.project;
  const opposite = (handle: Handle) => nearest(handles, mirrorImage(handle, axis), near);
  const [ids, unmatched]: [string[], Handle[]] = [[], []];
  let next = document;
  for (const handle of selectedHandles(document)) {
    const image = mirrorImage(handle, axis);
    const other = opposite(handle);
    // Of two beside one another only the nearer one is the counterpart of a third.
    if (other && opposite(other) === handle) {
      next = putHandles(next, [posedLike(other, image)]);
      ids.push(other.id);
    } else if (edges(image, 'rest').some(([a, b]) => [a, midpoint(a, b), b].some(bends))) {
      const id = idOpposite(next.project, handle);
      next = addHandle(next, { ...image, id });
      ids.push(id);
    } else unmatched.push(handle);
  }
  return { document: selectHandles(next, ids.length > 0 ? ids : document.selection), unmatched };
}

function mirrorImage(handle: Handle, axis: number): Handle {
  const over = ([x, y]: Vec) => roundedVec([2 * axis - x, y]);
  const turned = typeof handle.rotation === 'number' ? { rotation: rounded(-handle.rotation) } : {};
  return isLine(handle)
    ? { ...handle, ...turned, rest: handle.rest.map(over), posed: handle.posed.map(over) }
    : { ...handle, ...turned, rest: over(handle.rest), posed: over(handle.posed) };
}

function nearest(handles: readonly Handle[], image: Handle, within: number): Handle | null {
  let [best, least]: [Handle | null, number] = [null, within];
  for (const handle of handles) {
    const away = apart(handle, image);
    if (away < least) [best, least] = [handle, away];
  }
  return best;
}

/** How far two handles rest apart: the farthest that a corner of one is from the other. */
function apart(a: Handle, b: Handle): number {
  if (a.kind !== b.kind) return Number.POSITIVE_INFINITY;
  const [p, q] = [corners(a, 'rest'), corners(b, 'rest')];
  const closed = isClosed(a.kind);
  return Math.max(
    ...p.map((corner) => distanceToLine(q, closed, corner)),
    ...q.map((corner) => distanceToLine(p, closed, corner)),
  );
}

/** "right-hand" for "left-hand", where no handle is called so. */
function idOpposite(project: Project, { id, kind }: Handle): string {
  const opposite = id.replace(/(?<![a-z])(left|right)(?![a-z])/, (side) =>
    side === 'left' ? 'right' : 'left',
  );
  const taken = project.handles.some((handle) => handle.id === opposite);
  return taken ? freeId(project, kind === 'point' ? undefined : kind) : opposite;
}
