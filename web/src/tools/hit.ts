/** What lies under a press: a handle, the rotation ring of a selected one, or nothing. */

import { anchor } from '../document/handle';
import { distance, type Vec } from '../geometry/vec';
import type { Scene } from './state';

export interface Hit {
  readonly part: 'handle' | 'ring';
  readonly id: string;
}

/** The nearest handle within reach, before the nearest ring: a handle inside another's ring stays reachable. */
export function hit({ document, grips }: Pick<Scene, 'document' | 'grips'>, at: Vec): Hit | null {
  let best: Hit | null = null;
  let least = grips.handle;
  for (const handle of document.project.handles) {
    const away = distance(anchor(handle), at);
    // "<=": of two on one spot the later is drawn on top.
    if (away <= least) [best, least] = [{ part: 'handle', id: handle.id }, away];
  }
  if (best) return best;
  least = grips.band;
  for (const handle of document.project.handles) {
    const off = Math.abs(distance(anchor(handle), at) - grips.ring);
    if (document.selection.includes(handle.id) && off <= least)
      [best, least] = [{ part: 'ring', id: handle.id }, off];
  }
  return best;
}
