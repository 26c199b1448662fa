/** The domain, the part of the picture that bends: all of it, its opaque part, or the inside of drawn rings. */
import { enclosedBy } from '../geometry/enclosed';
import {
  areaOf,
  clipped,
  isInsideOf,
  islandsOf,
  isSimple,
  isWithin,
  type Ring,
  ringsMeet,
  touches,
} from '../geometry/ring';
import { corners, isClosed, isLine, roundedVec } from './handle';
import type { Domain, Fill, Handle, Project } from './project';
import { withoutLostTracks } from './tracks';

/** Smaller rings are accidental. Square pixels. */
export const LEAST_AREA = 16;

/** The fill of a new lasso. */
const FILL: Fill = { method: 'patches', seed: 0 };

/** Whether the picture behind the drawn rings is filled. */
export const isFilled = (project: Project): boolean =>
  project.fill !== undefined && ringsOf(project).length > 0;

/** Fills the picture behind the drawn rings, or leaves it empty where they move away. */
export function withFill({ fill, ...project }: Project, on: boolean): Project {
  return on ? { ...project, fill: fill ?? FILL } : project;
}

/**
 * The domain of a picture without drawn rings.
 *
 * @param threshold the alpha threshold, `null` for an opaque picture.
 */
export const domainOf = (threshold: number | null): Domain =>
  threshold === null ? { kind: 'image' } : { kind: 'alpha', threshold };

/** Lets all of a picture with this alpha threshold bend. An opaque one holds its boundary. */
export function withoutLasso(project: Project, threshold: number | null): Project {
  const whole = { ...withFill(project, false), domain: domainOf(threshold) };
  return threshold === null ? { ...whole, fix_boundary: true } : whole;
}

/** The drawn rings; empty if the picture determines the domain. */
export const ringsOf = ({ domain }: Project): readonly Ring[] =>
  domain?.kind === 'polygon' ? domain.rings : [];

/** The widest feather, image pixels. */
export const MOST_FEATHER = 64;

/** The width of the soft rim around drawn rings, image pixels; null without rings. */
export const featherOf = ({ domain }: Project): number | null =>
  domain?.kind === 'polygon' ? (domain.feather ?? 0) : null;

/** Gives the drawn rings a soft rim of a width in image pixels. Without rings nothing changes. */
export const withFeather = (project: Project, feather: number): Project =>
  project.domain?.kind === 'polygon' ? { ...project, domain: { ...project.domain, feather } } : project;

/** The domain without its feather, which lies beyond it. */
const unfeathered = ({ domain }: Project): Domain | undefined =>
  domain?.kind === 'polygon' ? { kind: 'polygon', rings: domain.rings } : domain;

/** Whether the same part of the picture bends in two projects. Cheap while it is the same object. */
export const isSameDomain = (a: Project, b: Project): boolean =>
  a.domain === b.domain || JSON.stringify(unfeathered(a)) === JSON.stringify(unfeathered(b));

/**
 * Adds the inside of a drawn line to the domain, or cuts it out as a hole. Returns `null` if the line goes around
 * nothing of the picture. A line that crosses itself has several parts.
 *
 * A hole must lie inside the domain. Otherwise the parts are added, and `cut` is false. They replace the rings that
 * they meet; the others stay. Handles outside the domain are removed.
 */
export function withLasso(
  project: Project,
  drawn: Ring,
  hole: boolean,
): { readonly project: Project; readonly cut: boolean } | null {
  const { width, height } = project.image;
  const within = clipped(drawn, { min: [0, 0], max: [width, height] });
  const parts = (isSimple(within) ? [within] : enclosedBy([within], LEAST_AREA)).map((ring) =>
    ring.map(roundedVec),
  );
  if (!parts.some((ring) => areaOf(ring) >= LEAST_AREA)) return null;
  const before = ringsOf(project);
  const holed = hole ? withHoles(before, parts) : null;
  const rings = holed ?? [...elsewhere(before, parts), ...parts];
  return { project: withRings(project, rings), cut: holed !== null };
}

/** The project with these rings as its domain, and without the handles outside. */
export function withRings(project: Project, rings: readonly Ring[]): Project {
  const handles = project.handles.filter((handle) => isOn(rings, handle));
  return withoutLostTracks({ ...project, domain: ringDomain(project, rings), handles });
}

/** The domain of rings, with the feather that a project has. */
export const ringDomain = ({ domain }: Project, rings: readonly Ring[]): Domain =>
  domain?.kind === 'polygon' ? { ...domain, rings } : { kind: 'polygon', rings };

/** Returns the rings with the holes, or `null` if these are not inside the domain. */
function withHoles(rings: readonly Ring[], holes: readonly Ring[]): readonly Ring[] | null {
  const left = rings.filter((ring) => !holes.some((hole) => isWithin(ring, hole)));
  const fits = (hole: Ring) =>
    hole.every((p) => isInsideOf(left, p)) && !left.some((ring) => touches(hole, true, ring));
  return holes.every(fits) ? [...left, ...holes] : null;
}

/** The islands that none of some parts meets, with their holes. */
function elsewhere(rings: readonly Ring[], parts: readonly Ring[]): readonly Ring[] {
  const kept = islandsOf(rings).filter((one) => !parts.some((part) => ringsMeet(one, part)));
  return rings.filter((one) => kept.some((other) => other === one || isWithin(one, other)));
}

/** Whether a part of the handle rests inside the rings. */
const isOn = (rings: readonly Ring[], handle: Handle): boolean => {
  const rest = corners(handle, 'rest');
  const closed = isClosed(handle.kind);
  return (
    rest.some((p) => isInsideOf(rings, p)) ||
    (isLine(handle) && rings.some((ring) => touches(rest, closed, ring)))
  );
};
