/** Mirrors the poses of handles to their counterparts on the other side of the domain's vertical axis. */
import type { Box } from '../geometry/box';
import { distanceToLine } from '../geometry/polyline';
import { midpoint, type Vec } from '../geometry/vec';
import { type Document, selectedHandles } from './document';
import { addHandle, freeId, putHandles, selectHandles } from './edits';
import { MAX_NAME } from './generated/settings';
import { corners, edges, isClosed, isLine, posedLike, rounded, roundedVec } from './handle';
import { nameFault, ofOtherSide } from './names';
import type { Handle, Project } from './project';

/**
 * The largest distance between the rest positions of a counterpart and of the mirror image, as a fraction of the
 * domain's larger side. Handles that are placed by eye differ by less.
 */
const NEAR = 1 / 32;

export interface Mirrored {
  readonly document: Document;
  /** Handles whose mirror images lie outside the domain. */
  readonly unmatched: readonly Handle[];
}

/**
 * Poses the counterparts of the selected handles as mirror images, and selects them. Missing counterparts are added.
 *
 * A handle on the axis is its own counterpart, so that mirroring all handles flips the whole pose.
 *
 * @param bounds the bounds of the domain at rest. The axis is in the middle.
 * @param bends whether a point of the original is in the domain.
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
    // Counterparts are mutual: of two neighbours, only the nearer one has the third as its counterpart.
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

/** Returns the distance of two handles at rest: the largest distance of a corner to the other handle. */
function apart(a: Handle, b: Handle): number {
  if (a.kind !== b.kind) return Number.POSITIVE_INFINITY;
  const [p, q] = [corners(a, 'rest'), corners(b, 'rest')];
  const closed = isClosed(a.kind);
  return Math.max(
    ...p.map((corner) => distanceToLine(q, closed, corner)),
    ...q.map((corner) => distanceToLine(p, closed, corner)),
  );
}

/** Returns "right-hand" for "left-hand" if that id is free, or else another free id. */
function idOpposite(project: Project, { id, kind }: Handle): string {
  const opposite = ofOtherSide(id);
  const isRefused = nameFault(project, '', opposite) !== null || [...opposite].length > MAX_NAME;
  return isRefused ? freeId(project, kind === 'point' ? undefined : kind) : opposite;
}
