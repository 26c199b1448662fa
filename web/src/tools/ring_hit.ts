/** Which corner or edge of a drawn domain lies under a press. */
import { ringsOf } from '../document/domain';
import type { RingCorner } from '../document/lasso_corners';
import type { Project } from '../document/project';
import { type LinePlace, nearestPlace } from '../geometry/polyline';
import { distance, type Vec } from '../geometry/vec';
import type { Grips } from './state';

export type RingHit =
  | ({ readonly part: 'corner' } & RingCorner)
  | { readonly part: 'edge'; readonly ring: number; readonly place: LinePlace };

/** Corners are close together, so that their hit areas are smaller than those of handles. */
const REACH = 0.75;

/** The nearest corner within reach, or else the nearest edge; null where there is neither. */
export function ringHit(project: Project, grips: Grips, at: Vec): RingHit | null {
  const rings = ringsOf(project);
  let [corner, near]: [RingHit | null, number] = [null, REACH * grips.handle];
  let [edge, beside]: [RingHit | null, number] = [null, REACH * grips.line];
  rings.forEach((corners, ring) => {
    corners.forEach((place, index) => {
      const away = distance(place, at);
      if (away <= near) [corner, near] = [{ part: 'corner', ring, index }, away];
    });
    const place = nearestPlace(corners, true, at);
    if (place.distance <= beside) [edge, beside] = [{ part: 'edge', ring, place }, place.distance];
  });
  return corner ?? edge;
}
