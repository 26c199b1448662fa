/**
 * Several handles as one thing, turned and scaled about the centre of their posed places. Turning and scaling leave that
 * centre where it is, so that steps in a row have it in common.
 */
import { bestTurn, centre } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { type Document, selectedHandles } from './document';
import { changeHandles } from './edits';
import { anchor, corners, rotationOf, SCALES, scaleOf, turnedAbout } from './handle';
import type { Handle } from './project';

/** How far what is selected in a document is turned as one, in degrees, and scaled. */
export interface GroupTransform {
  readonly origin: Document;
  readonly turn: number;
  readonly scale: number;
}

/** A document, and how what is selected in it is turned and scaled as one, if it is. */
export interface PosedDocument {
  readonly document: Document;
  readonly transform?: GroupTransform;
}

export const groupCentre = (handles: readonly Handle[]): Vec =>
  centre(handles.map((handle) => anchor(handle)));

/**
 * How far their places are turned from rest as a whole, in degrees: like the corners of a polygon. Where all are in one
 * place their corners tell it, or the first of them.
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

/** The distance from the centre to the farthest posed corner. */
export function groupSpan(handles: readonly Handle[]): number {
  const pivot = groupCentre(handles);
  return Math.max(...handles.flatMap((handle) => corners(handle)).map((corner) => distance(pivot, corner)));
}

/**
 * Turns what is selected as one, by degrees, and scales it as far as no handle's scale leaves {@link SCALES}. Automatic
 * rotations stay automatic.
 */
export function transformGroup(document: Document, turn: number, scale = 1): Document {
  const selected = selectedHandles(document);
  const [pivot, scales] = [groupCentre(selected), selected.map(scaleOf)];
  const least = Math.min(1, SCALES.least / Math.min(...scales));
  const most = Math.max(1, SCALES.most / Math.max(...scales));
  const allowed = Math.min(most, Math.max(least, scale));
  return changeHandles(document, document.selection, (handle) => turnedAbout(handle, pivot, turn, allowed));
}

/** {@link transformGroup}, with how: for a guard, which lets it go a part of the way. */
export const posedGroup = (origin: Document, turn: number, scale: number): PosedDocument => ({
  document: transformGroup(origin, turn, scale),
  transform: { origin, turn, scale },
});

/** A part of the way from one pose to another, of the same origin. */
export function interpolatedTransform(
  from: GroupTransform,
  to: GroupTransform,
  share: number,
): GroupTransform {
  const way = (a: number, b: number) => a + share * (b - a);
  return { origin: to.origin, turn: way(from.turn, to.turn), scale: way(from.scale, to.scale) };
}
