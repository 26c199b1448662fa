/** Growing a drawn domain, so that a place beside it bends too. */
import { capsule } from '../geometry/capsule';
import { simpleRing, unionOf } from '../geometry/enclosed';
import { isInside, nearestPlace } from '../geometry/polyline';
import { clipped, isInsideOf, islandsOf, isWithin, type Ring, ringsMeet } from '../geometry/ring';
import { distance, lerp, type Vec } from '../geometry/vec';
import { ringDomain, ringsOf } from './domain';
import { roundedVec } from './handle';
import type { Project } from './project';

/** The room around the new place, as a fraction of the longer side of the picture. */
const ROOM = 0.08;

/**
 * Grows the drawn domain to a place of the original, by a round path from the nearest part. In a hole, all of the hole
 * is filled. Islands on the way become one.
 *
 * Returns `null` without drawn rings, for a place outside the picture, and for one that bends already.
 */
export function withPlaceAdded(project: Project, at: Vec): Project | null {
  const rings = ringsOf(project);
  const { width, height } = project.image;
  const within = at[0] >= 0 && at[1] >= 0 && at[0] <= width && at[1] <= height;
  if (rings.length === 0 || !within || isInsideOf(rings, at)) return null;
  const hole = rings
    .filter((ring) => isInside(ring, at))
    .find((ring, _, around) => isInnermost(ring, around));
  return {
    ...project,
    domain: ringDomain(project, hole ? filled(rings, hole) : grown(project, rings, at)),
  };
}

const isInnermost = (ring: Ring, all: readonly Ring[]): boolean =>
  !all.some((other) => other !== ring && isWithin(other, ring));

const filled = (rings: readonly Ring[], hole: Ring): readonly Ring[] =>
  rings.filter((ring) => ring !== hole && !isWithin(ring, hole));

function grown({ image }: Project, rings: readonly Ring[], at: Vec): readonly Ring[] {
  const islands = islandsOf(rings);
  const away = (ring: Ring) => nearestPlace(ring, true, at).distance;
  const nearest = islands.reduce((best, ring) => (away(ring) < away(best) ? ring : best));
  const { edge, fraction } = nearestPlace(nearest, true, at);
  const from = nearest[edge] ?? at;
  const foot = lerp(from, nearest[(edge + 1) % nearest.length] ?? from, fraction);
  const room = ROOM * Math.max(image.width, image.height);
  // From inside the ring, so that no corner of the path lies on it.
  const inside = lerp(at, foot, 1 + room / (3 * Math.max(distance(at, foot), 1)));
  const path = capsule(inside, at, room);
  const box = { min: [0, 0], max: [image.width, image.height] } as const;
  let ring = simpleRing(clipped(unionOf(nearest, path), box));
  const met = new Set([nearest]);
  for (const island of islands) {
    if (met.has(island) || !ringsMeet(island, ring)) continue;
    met.add(island);
    ring = unionOf(ring, island);
  }
  return [...rings.filter((one) => !met.has(one)), ring.map(roundedVec)];
}
