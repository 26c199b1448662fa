/** Texts for people about the selection, its place and depth, corners and drawings. */
import { type Document, selectedHandles } from '../document/document';
import { groupCentre, groupTurn } from '../document/group';
import {
  DEPTHS,
  depthOf,
  nameOf,
  rotationOf,
  rounded,
  scaleOf,
  type Turns,
  turnWords,
} from '../document/handle';
import type { Handle, LineHandle } from '../document/project';
import type { Draft } from '../tools/state';

export function selectionName(document: Document): string {
  const selected = selectedHandles(document);
  return selected.length === 0 ? 'nothing' : handleWords(selected);
}

/** Handles by name or, if there are more, by number. */
export const handleWords = (handles: readonly Handle[]): string => {
  const [only, ...more] = handles;
  return only && more.length === 0 ? nameOf(only) : `${handles.length} handles`;
};

/** The pose of the selected handle, that of several as one; empty without any. */
export function placeWords(document: Document, turns: Turns): string {
  const selected = selectedHandles(document);
  const [first, ...more] = selected;
  if (!first) return '';
  const [x, y] = groupCentre(selected).map(Math.round);
  const turn = more.length > 0 ? groupTurn(selected) : rotationOf(first, turns);
  const [scale, ...others] = new Set(selected.map((handle) => rounded(scaleOf(handle))));
  const scaled = scale === 1 || others.length > 0 ? '' : `, scale ${scale}`;
  return `${handleWords(selected)}: x ${x}, y ${y}, ${turnWords(turn)}${scaled}`;
}

/** Where a corner of a bar or polygon is; its index counts from 0. */
export function cornerWords(handle: LineHandle, index: number): string {
  const [x, y] = handle.posed[index]?.map(Math.round) ?? [];
  return `Corner ${index + 1} of ${nameOf(handle)}: x ${x}, y ${y}`;
}

/** The depth of the first selected handle; null without one. */
export function depthWords(document: Document): string | null {
  const [handle] = selectedHandles(document);
  if (!handle) return null;
  const depth = depthOf(handle);
  const end = depth === DEPTHS.most ? ', in front' : depth === DEPTHS.least ? ', at the back' : '';
  return `${nameOf(handle)}: depth ${depth}${end}`;
}

/** The corner last set of a drawing; without a drawing, that it was given up. */
export function draftWords(draft: Draft | null): string {
  const [at] = draft?.corners.slice(-1) ?? [];
  const [x, y] = at?.map(Math.round) ?? [];
  return draft ? `${draft.kind}, corner ${draft.corners.length}: x ${x}, y ${y}` : 'Drawing given up';
}
