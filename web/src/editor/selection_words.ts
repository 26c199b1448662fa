/** Words about the selection, its place and depth, corners and drawings. */
import { type Document, selectedHandles } from '../document/document';
import { groupCentre, groupTurn } from '../document/group';
import { DEPTHS, depthOf, rotationOf, rounded, scaleOf, type Turns } from '../document/handle';
import { nameWords } from '../document/names';
import type { Handle, LineHandle } from '../document/project';
import { say, type Wording, type Words } from '../texts/wording';
import type { Draft } from '../tools/state';

export function selectionName(document: Document): Words {
  const selected = selectedHandles(document);
  return selected.length === 0 ? say('names.nothing') : handleWords(selected);
}

/** Handles by name or, if there are more, by number. */
export const handleWords = (handles: readonly Handle[]): Words => {
  const [only, ...more] = handles;
  return only && more.length === 0 ? nameWords(only) : say('names.handles', handles.length);
};

/** The pose of the selected handle, that of several as one; null without any. */
export function placeWords(document: Document, turns: Turns): Wording | null {
  const selected = selectedHandles(document);
  const [first, ...more] = selected;
  if (!first) return null;
  const [x, y] = groupCentre(selected);
  const turn = more.length > 0 ? groupTurn(selected) : rotationOf(first, turns);
  const [scale = 1, ...others] = new Set(selected.map((handle) => rounded(scaleOf(handle))));
  return say(
    'spoken.place',
    handleWords(selected),
    Math.round(x),
    Math.round(y),
    Math.round(turn),
    scale === 1 || others.length > 0 ? null : scale,
  );
}

/** Where a corner of a bar or polygon is; its index counts from 0. */
export function cornerWords(handle: LineHandle, index: number): Wording {
  const [x = 0, y = 0] = handle.posed[index]?.map(Math.round) ?? [];
  return say('spoken.cornerAt', index + 1, nameWords(handle), x, y);
}

/** The depth of the first selected handle; null without one. */
export function depthWords(document: Document): Wording | null {
  const [handle] = selectedHandles(document);
  if (!handle) return null;
  const depth = depthOf(handle);
  const name = nameWords(handle);
  if (depth === DEPTHS.most) return say('spoken.depthInFront', name, depth);
  return say(depth === DEPTHS.least ? 'spoken.depthAtBack' : 'spoken.depthOf', name, depth);
}

/** The corner last set of a drawing; without a drawing, that it was given up. */
export function draftWords(draft: Draft | null): Wording {
  const [at] = draft?.corners.slice(-1) ?? [];
  const [x = 0, y = 0] = at?.map(Math.round) ?? [];
  return draft ? say(`spoken.draft.${draft.kind}`, draft.corners.length, x, y) : say('spoken.drawingGivenUp');
}
