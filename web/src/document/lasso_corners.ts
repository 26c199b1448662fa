/** The corners of a drawn domain: moving, adding and removing them. A ring never crosses itself or another one. */
import type { LinePlace } from '../geometry/polyline';
import { areaOf, isSimple, isWithin, type Ring, touches } from '../geometry/ring';
import { lerp, type Vec } from '../geometry/vec';
import { LEAST_AREA, ringsOf, withRings } from './domain';
import { CORNERS_NEEDED, roundedVec } from './handle';
import type { Project } from './project';

/** A corner of a drawn ring, both counted from 0. */
export interface RingCorner {
  readonly ring: number;
  readonly index: number;
}

export const ringCornerAt = (project: Project, { ring, index }: RingCorner): Vec | undefined =>
  ringsOf(project)[ring]?.[index];

/** Moves a corner, at most to the edge of the picture. Null if the ring would cross itself or another one. */
export function withRingCornerMoved(project: Project, { ring, index }: RingCorner, to: Vec): Project | null {
  const { width, height } = project.image;
  const at = roundedVec([Math.min(Math.max(to[0], 0), width), Math.min(Math.max(to[1], 0), height)]);
  return changed(project, ring, (corners) => corners.map((corner, k) => (k === index ? at : corner)));
}

/** Adds a corner on an edge, which stays straight. */
export const withRingCornerAdded = (project: Project, ring: number, place: LinePlace): Project =>
  withRings(
    project,
    ringsOf(project).map((corners, k) => (k === ring ? cornerInserted(corners, place) : corners)),
  );

function cornerInserted(corners: Ring, { edge, fraction }: LinePlace): Ring {
  const [from, to] = [corners[edge], corners[(edge + 1) % corners.length]];
  if (!from || !to) return corners;
  return [...corners.slice(0, edge + 1), roundedVec(lerp(from, to, fraction)), ...corners.slice(edge + 1)];
}

/** Removes a corner. Null if too few would be left, or the ring would cross itself or another one. */
export function withRingCornerRemoved(project: Project, { ring, index }: RingCorner): Project | null {
  if ((ringsOf(project)[ring]?.length ?? 0) <= CORNERS_NEEDED.lasso) return null;
  return changed(project, ring, (corners) => corners.filter((_, k) => k !== index));
}

function changed(project: Project, index: number, change: (ring: Ring) => Ring): Project | null {
  const rings = ringsOf(project);
  const before = rings[index];
  if (!before) return null;
  const after = change(before);
  const keeps = (other: Ring) =>
    !touches(after, true, other) &&
    isWithin(other, after) === isWithin(other, before) &&
    isWithin(after, other) === isWithin(before, other);
  const others = rings.filter((other) => other !== before);
  if (!isSimple(after) || areaOf(after) < LEAST_AREA || !others.every(keeps)) return null;
  return withRings(
    project,
    rings.map((ring) => (ring === before ? after : ring)),
  );
}
