/**
 * The group transform: turns and scales several handles about the centre of their posed anchors.
 *
 * The centre is a fixed point of the transform, so that consecutive transforms share it.
 */
import { bestTurn, centre } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { type Document, selectedHandles } from './document';
import { changeHandles } from './edits';
import { anchor, corners, rotationOf, SCALES, scaleOf, turnedAbout } from './handle';
import type { Handle } from './project';

/** The turn in degrees and the scale of the handles selected in `origin`. */
export interface GroupTransform {
  readonly origin: Document;
  readonly turn: number;
  readonly scale: number;
}

/** A document, and the group transform that it results from, if any. */
export interface PosedDocument {
  readonly document: Document;
  readonly transform?: GroupTransform;
  /** For a stroke: whether its own guard has stopped it at a fold. */
  readonly stopped?: boolean;
}

export const groupCentre = (handles: readonly Handle[]): Vec =>
  centre(handles.map((handle) => anchor(handle)));

/**
 * Returns the turn of the anchors from rest in degrees, as for the corners of a polygon.
 *
 * If all anchors coincide, the corners determine the turn, or else the first handle.
 */
export function groupTurn(handles: readonly Handle[]): number {
  const [first] = handles;
  const turn = (places: (handle: Handle, of: 'rest' | 'posed') => readonly Vec[]) =>
    bestTurn(
      handles.flatMap((handle) => places(handle, 'rest')),
      handles.flatMap((handle) => places(handle, 'posed')),
    );
  const found = turn((handle, of) => [anchor(handle, of)]) ?? turn(corners);
  return found ?? (first ? rotationOf(first) : 0);
}

/** Returns the distance from the centre to the farthest posed corner. */
export function groupSpan(handles: readonly Handle[]): number {
  const pivot = groupCentre(handles);
  return Math.max(...handles.flatMap((handle) => corners(handle)).map((corner) => distance(pivot, corner)));
}

/**
 * Turns the selected handles by degrees, and scales them. The scale is limited so that those of all handles stay in
 * {@link SCALES}. Automatic rotations stay automatic.
 */
export function transformGroup(document: Document, turn: number, scale = 1): Document {
  const selected = selectedHandles(document);
  const [pivot, scales] = [groupCentre(selected), selected.map(scaleOf)];
  const least = Math.min(1, SCALES.least / Math.min(...scales));
  const most = Math.max(1, SCALES.most / Math.max(...scales));
  const allowed = Math.min(most, Math.max(least, scale));
  return changeHandles(document, document.selection, (handle) => turnedAbout(handle, pivot, turn, allowed));
}

/** Returns the result of {@link transformGroup} with the transform, which the fold guard can shorten. */
export const posedGroup = (origin: Document, turn: number, scale: number): PosedDocument => ({
  document: transformGroup(origin, turn, scale),
  transform: { origin, turn, scale },
});

/** Interpolates two transforms of the same origin. */
export function interpolatedTransform(
  from: GroupTransform,
  to: GroupTransform,
  share: number,
): GroupTransform {
  const way = (a: number, b: number) => a + share * (b - a);
  return { origin: to.origin, turn: way(from.turn, to.turn), scale: way(from.scale, to.scale) };
}
