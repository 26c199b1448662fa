/**
 * Several handles as one thing, turned and scaled about the centre of their posed places. Turning and scaling leave that
 * centre where it is, so that steps in a row have it in common.
 */
import { bestTurn, centre } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import { type Document, selectedHandles } from './document';
import { changeHandles } from './edits';
import { anchor, corners, SCALES, scaleOf, turnedAbout } from './handle';
import type { Handle } from './project';

const anchors = (handles: readonly Handle[], of: 'rest' | 'posed'): readonly Vec[] =>
  handles.map((handle) => anchor(handle, of));

export const groupCentre = (handles: readonly Handle[]): Vec => centre(anchors(handles, 'posed'));

/** How far their places are turned from rest as a whole, in degrees: like the corners of a polygon. */
export const groupTurn = (handles: readonly Handle[]): number =>
  bestTurn(anchors(handles, 'rest'), anchors(handles, 'posed')) ?? 0;

/** The distance from the centre to the farthest posed corner. */
export function groupSpan(handles: readonly Handle[]): number {
  const pivot = groupCentre(handles);
  return Math.max(...handles.flatMap((handle) => corners(handle)).map((corner) => distance(pivot, corner)));
}

/**
 * Turns what is selected as one, by degrees, and scales it as far as no handle's scale leaves {@link SCALES}. Automatic
 * rotations stay automatic.
 */
export function poseAsOne(document: Document, turn: number, growth = 1): Document {
  const selected = selectedHandles(document);
  const [pivot, scales] = [groupCentre(selected), selected.map(scaleOf)];
  const least = Math.min(1, SCALES.least / Math.min(...scales));
  const most = Math.max(1, SCALES.most / Math.max(...scales));
  const allowed = Math.min(most, Math.max(least, growth));
  return changeHandles(document, document.selection, (handle) => turnedAbout(handle, pivot, turn, allowed));
}
