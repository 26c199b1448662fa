/**
 * Limbs that cross: what is dragged comes to the front of the parts that it crosses.
 *
 * That is decided once per drag, and dropped where the drag ends without a crossing. A drag that starts behind another
 * part stays there, since a person or a file placed it there.
 */
import type { Document } from '../document/document';
import { changeHandles } from '../document/edits';
import { atDepth, DEPTHS, depthOf } from '../document/handle';
import type { Project } from '../document/project';
import type { Deformation } from './deformation';

export interface Crossing {
  /** Whether the drag may bring handles to the front. */
  readonly open: boolean;
  /** The depths by id that bring them there, once decided. */
  readonly depths: ReadonlyMap<string, number>;
}

export const NO_CROSSING: Crossing = { open: false, depths: new Map() };

/** The question about crossings; null before the first solution. */
export type Leader = Pick<Deformation, 'lead'> | null;

const lead = (leader: Leader, { project, selection }: Document): number =>
  selection.length === 0 ? 1 : (leader?.lead(project, selection) ?? 1);

/** At the start of a drag. */
export const beginCrossing = (leader: Leader, document: Document): Crossing => ({
  open: lead(leader, document) >= 0,
  depths: NO_CROSSING.depths,
});

/** Decides for one move of a drag. Handles that `before` lacks are being placed, and keep their depth. */
export function crossed(crossing: Crossing, leader: Leader, before: Document, moved: Document): Crossing {
  const isPlaced = (id: string) => before.project.handles.every((handle) => handle.id !== id);
  if (!crossing.open || crossing.depths.size > 0 || moved.selection.some(isPlaced)) return crossing;
  if (lead(leader, moved) > 0) return crossing;
  return { ...crossing, depths: frontDepths(moved.project, moved.selection) };
}

/** The document itself while nothing is decided. */
export const withDepths = (document: Document, { depths }: Crossing): Document =>
  depths.size === 0
    ? document
    : changeHandles(document, [...depths.keys()], (handle) => atDepth(handle, depths.get(handle.id) ?? 0));

/** The document at the end of a drag: with the depths from before, if these do as well. */
export function withNeededDepths(
  document: Document,
  { depths }: Crossing,
  leader: Leader,
  before: Document,
): Document {
  if (depths.size === 0) return document;
  const earlier = new Map(before.project.handles.map((handle) => [handle.id, handle.depth]));
  const lowered = changeHandles(document, [...depths.keys()], (handle) => {
    const { depth: _, ...rest } = handle;
    const depth = earlier.get(handle.id);
    return (depth === undefined ? rest : { ...rest, depth }) as typeof handle;
  });
  return lead(leader, lowered) > 0 ? lowered : document;
}

/**
 * The whole depths that bring the selected handles in front of all others, and keep the order of both. Others change
 * only where no depth is left in front of them.
 */
export function frontDepths({ handles }: Project, selection: readonly string[]): ReadonlyMap<string, number> {
  const selected = handles.filter(({ id }) => selection.includes(id));
  const others = handles.filter(({ id }) => !selection.includes(id));
  const most = Math.max(...others.map(depthOf));
  const steps = stepsOf(selected.map(depthOf));
  const isFront = (steps[0] ?? 0) > most;
  const raised = new Map(
    selected.map((handle) => {
      const depth = depthOf(handle);
      return [handle.id, isFront ? depth : Math.floor(most) + 1 + steps.indexOf(depth)] as const;
    }),
  );
  if (others.length === 0 || Math.max(...raised.values()) <= DEPTHS.most) return raised;
  const all = new Map([...others.map((handle) => [handle.id, depthOf(handle)] as const), ...raised]);
  const packed = stepsOf([...all.values()]);
  return new Map(
    [...all].map(([id, depth]) => [id, DEPTHS.most - (packed.length - 1 - packed.indexOf(depth))]),
  );
}

/** Different depths in ascending order. */
const stepsOf = (depths: readonly number[]): readonly number[] => [...new Set(depths)].sort((a, b) => a - b);
