/**
 * The ring around several selected handles, which turns and scales them together. It encloses all of them if the view
 * has room.
 */
import { type Document, selectedHandles } from '../document/document';
import { groupCentre, groupSpan, groupTurn } from '../document/group';
import { add, rotated, type Vec } from '../geometry/vec';
import type { Grips } from './state';

export interface GroupRing {
  readonly pivot: Vec;
  readonly radius: number;
  /** Degrees. At 0, the knob is at the top. */
  readonly turn: number;
  readonly knob: Vec;
  /** Position of the grip, which scales. */
  readonly grip: Vec;
  /** Distance of the ring from the farthest corner inside; at most half its radius. */
  readonly clearance: number;
}

/** The angle from the knob to the grip, clockwise. Unturned, the grip is at the lower right. */
export const GRIP_DEGREES = 135;

/** Null unless several handles are selected. */
export function groupRing(document: Document, { handle, band, ring, view }: Grips): GroupRing | null {
  const selected = selectedHandles(document);
  if (selected.length < 2) return null;
  const [pivot, span, turn] = [groupCentre(selected), groupSpan(selected), groupTurn(selected)];
  const { min, max } = view;
  const room = Math.min(pivot[0] - min[0], max[0] - pivot[0], pivot[1] - min[1], max[1] - pivot[1]);
  const radius = Math.max(ring, Math.min(span + handle + band, room));
  const at = (degrees: number) => add(pivot, rotated([0, -radius], turn + degrees));
  const clearance = Math.min(Math.max(0, radius - span), radius / 2);
  return { pivot, radius, turn, knob: at(0), grip: at(GRIP_DEGREES), clearance };
}
