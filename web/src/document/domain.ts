/** The part of the picture that bends: all of it, its opaque part, or what the person has drawn rings around. */
import { isInside } from '../geometry/polyline';
import { areaOf, clipped, isWithin, type Ring, ringsMeet, simpleRing, touches } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import { corners, isClosed, isLine, roundedVec } from './handle';
import type { Domain, Handle, Project } from './project';

/** Rings smaller than this were not meant: square pixels. */
const LEAST_AREA = 16;

/** The domain of a picture by itself. @param threshold of its alpha; `null` for an opaque picture. */
export const domainOf = (threshold: number | null): Domain =>
  threshold === null ? { kind: 'image' } : { kind: 'alpha', threshold };

/** The rings that the person has drawn; none where the picture decides. */
export const ringsOf = ({ domain }: Project): readonly Ring[] =>
  domain?.kind === 'polygon' ? domain.rings : [];

/**
 * The project with the domain inside a ring drawn by hand, or with a hole there if it lies inside of what bends, and
 * whether it has been cut; null if the ring holds nothing of the picture. Rings elsewhere stay, and those that it meets
 * give way to it. Handles outside are left out.
 */
export function withLasso(
  project: Project,
  drawn: Ring,
  hole: boolean,
): { readonly project: Project; readonly cut: boolean } | null {
  const { width, height } = project.image;
  const ring = simpleRing(clipped(drawn, { min: [0, 0], max: [width, height] })).map(roundedVec);
  if (areaOf(ring) < LEAST_AREA) return null;
  const before = ringsOf(project);
  const holed = hole ? withHole(before, ring) : null;
  const rings = holed ?? [...elsewhere(before, ring), ring];
  const handles = project.handles.filter((handle) => isOn(rings, handle));
  return { project: { ...project, domain: { kind: 'polygon', rings }, handles }, cut: holed !== null };
}

/** Null where the ring does not lie within what is there. */
function withHole(rings: readonly Ring[], hole: Ring): readonly Ring[] | null {
  const left = rings.filter((ring) => !isWithin(ring, hole));
  const fits = hole.every((p) => isInsideOf(left, p)) && !left.some((ring) => touches(hole, true, ring));
  return fits ? [...left, hole] : null;
}

/** The islands that a ring does not meet, with their holes. */
function elsewhere(rings: readonly Ring[], ring: Ring): readonly Ring[] {
  const outer = rings.filter((one) => !rings.some((other) => other !== one && isWithin(one, other)));
  const kept = outer.filter((one) => !ringsMeet(one, ring));
  return rings.filter((one) => kept.some((other) => other === one || isWithin(one, other)));
}

const isInsideOf = (rings: readonly Ring[], p: Vec): boolean =>
  rings.filter((ring) => isInside(ring, p)).length % 2 === 1;

/** Whether some of the handle rests inside. */
const isOn = (rings: readonly Ring[], handle: Handle): boolean => {
  const rest = corners(handle, 'rest');
  const closed = isClosed(handle.kind);
  return (
    rest.some((p) => isInsideOf(rings, p)) ||
    (isLine(handle) && rings.some((ring) => touches(rest, closed, ring)))
  );
};
