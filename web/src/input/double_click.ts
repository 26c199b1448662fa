/** Double clicks of pointers that are captured, for which browsers send none. */
import { distance, type Vec } from '../geometry/vec';

/** Two clicks within this time and distance are a double click. CSS pixels, for a mouse and for a finger. */
const TWICE = { ms: 500, fine: 4, coarse: 24 } as const;

/** Where and when a click ended. */
export interface Click {
  readonly place: Vec;
  readonly time: number;
}

export function isDoubleClick(before: Click | null, { place, time }: Click, coarse: boolean): boolean {
  if (before === null || time - before.time > TWICE.ms) return false;
  return distance(before.place, place) <= (coarse ? TWICE.coarse : TWICE.fine);
}
