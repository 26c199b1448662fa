/** Double clicks of pointers that are captured, for which browsers do not send one. */
import { distance, type Vec } from '../geometry/vec';

/** Two clicks within this time and distance are a double click. CSS pixels, for a mouse and for a finger. */
const TWICE = { ms: 500, fine: 4, coarse: 24 } as const;

/** Where and when a click ended, and with which tool: one that places a handle and one that selects it are no pair. */
export interface Click {
  readonly place: Vec;
  readonly time: number;
  readonly tool: string;
}

export function isDoubleClick(before: Click | null, { place, time, tool }: Click, coarse: boolean): boolean {
  if (before === null || before.tool !== tool || time - before.time > TWICE.ms) return false;
  return distance(before.place, place) <= (coarse ? TWICE.coarse : TWICE.fine);
}
