/** One handle: reading it, and the pure changes that a person makes to it. */
import { add, bearing, scaled, type Vec, wrapDegrees } from '../geometry/vec';
import type { Handle, Rotation } from './project';

/** How far each automatic handle is turned now, degrees by id. */
export type Turns = ReadonlyMap<string, number>;

const NO_TURNS: Turns = new Map();

/** Hundredths of a pixel and of a degree: what the file keeps and the panel shows. */
const rounded = (value: number): number => Math.round(value * 100) / 100 || 0;
const roundedVec = (p: Vec): Vec => [rounded(p[0]), rounded(p[1])];

/** The corners of a handle at rest or posed; a point has one. */
const corners = (handle: Handle, of: 'rest' | 'posed'): readonly Vec[] =>
  handle.kind === 'point' ? [handle[of]] : handle[of];

/** Where a handle is taken hold of: the mean of its corners. */
export function anchor(handle: Handle, of: 'rest' | 'posed' = 'posed'): Vec {
  const all = corners(handle, of);
  return scaled(
    all.reduce<Vec>((sum, p) => add(sum, p), [0, 0]),
    1 / all.length,
  );
}

export const isAutomatic = (handle: Handle): boolean => handle.rotation === 'auto';

/** The handle's rotation in degrees. An automatic one reads as the turn of its own corners, a lone point as in `turns`. */
export function rotationOf(handle: Handle, turns = NO_TURNS): number {
  if (typeof handle.rotation === 'number') return handle.rotation;
  if (handle.rotation === undefined) return 0;
  if (handle.kind === 'point') return turns.get(handle.id) ?? 0;
  const turn = (of: 'rest' | 'posed') => bearing(handle[of][0] ?? [0, 0], handle[of].at(-1) ?? [0, 0]);
  return wrapDegrees(turn('posed') - turn('rest'));
}

export const scaleOf = (handle: Handle): number => handle.scale ?? 1;

/** What screen readers and messages call it: its id as words. */
export const nameOf = (handle: Handle): string => handle.id.replace(/[-_]+/g, ' ').trim() || handle.id;

/** The handle with every posed corner passed through `place`. */
function replaced(handle: Handle, place: (p: Vec) => Vec): Handle {
  return handle.kind === 'point'
    ? { ...handle, posed: place(handle.posed) }
    : { ...handle, posed: handle.posed.map(place) };
}

export const moved = (handle: Handle, by: Vec): Handle => replaced(handle, (p) => roundedVec(add(p, by)));

/** Turned about its own anchor to a rotation in degrees, kept in (−180, 180]. */
export function turnedTo(handle: Handle, degrees: number): Handle {
  const pivot = anchor(handle);
  const turn = ((degrees - rotationOf(handle)) * Math.PI) / 180;
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const about = ([x, y]: Vec): Vec => {
    const [dx, dy] = [x - pivot[0], y - pivot[1]];
    return roundedVec([pivot[0] + cos * dx - sin * dy, pivot[1] + sin * dx + cos * dy]);
  };
  const placed = handle.kind === 'point' ? handle : replaced(handle, about);
  return { ...placed, rotation: rounded(wrapDegrees(degrees)) };
}

/** Turned by whatever is around it. */
export const freed = (handle: Handle): Handle => ({ ...handle, rotation: 'auto' });

export const scaledTo = (handle: Handle, scale: number): Handle => ({ ...handle, scale: rounded(scale) });

/** Back at rest: where it was placed, not scaled, and turned by nothing or by what is around it. */
export const atRest = (handle: Handle, rotation: Rotation): Handle => ({
  ...(handle.kind === 'point' ? { ...handle, posed: handle.rest } : { ...handle, posed: handle.rest }),
  rotation,
  scale: 1,
});

/** An automatic rotation is never a change of its own. */
export function isAtRest(handle: Handle): boolean {
  const rest = corners(handle, 'rest');
  const same = corners(handle, 'posed').every((p, k) => p[0] === rest[k]?.[0] && p[1] === rest[k]?.[1]);
  return same && rotationOf(handle) === 0 && scaleOf(handle) === 1;
}

export { rounded, roundedVec };
