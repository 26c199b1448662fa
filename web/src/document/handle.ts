/** Properties of one handle, and pure edits of it. */
import {
  bestTurn,
  centre,
  edgesOf,
  type LinePlace,
  lineCentroid,
  nearestPlace,
  nearestTurn,
} from '../geometry/polyline';
import { add, lerp, rotated, scaled, subtract, type Vec } from '../geometry/vec';
import { shownName } from '../texts/shown_name';
import { MAX_NAME } from './generated/settings';
import type { Handle, LineHandle, Rotation } from './project';

/** The current turn of each automatic handle: degrees by id. */
export type Turns = ReadonlyMap<string, number>;

const NO_TURNS: Turns = new Map();

/** For each handle by id, whether each of its corners lies behind another part of the picture. */
export type HiddenCorners = ReadonlyMap<string, readonly boolean[]>;

/** Larger numbers are rejected, without rounding: hundredths mean nothing, and drawing them would overflow. */
const BEYOND = 1e12;

/** Rounds to hundredths of a pixel or degree, as the file stores and the panel shows them. */
const rounded = (value: number): number =>
  Math.abs(value) < BEYOND ? Math.round(value * 100) / 100 || 0 : value;
/** Finer than hundredths, which would lose small steps of a small scale. */
const roundedScale = (scale: number): number => Math.round(scale * 1e4) / 1e4;
const roundedVec = (p: Vec): Vec => [rounded(p[0]), rounded(p[1])];

/** The corners of a handle, at rest or posed; a point has one. */
export const corners = (handle: Handle, of: 'rest' | 'posed' = 'posed'): readonly Vec[] =>
  handle.kind === 'point' ? [handle[of]] : handle[of];

/** The point by which a handle is dragged: the mean of its corners. */
export const anchor = (handle: Handle, of: 'rest' | 'posed' = 'posed'): Vec => centre(corners(handle, of));

/** Whether an edge connects the last corner to the first. A point counts as closed. */
export const isClosed = (kind: Handle['kind'] | 'lasso'): boolean => kind !== 'bar';

/** The handle's edges. A point has one edge, of length 0. */
export const edges = (handle: Handle, of: 'rest' | 'posed' = 'posed'): readonly (readonly [Vec, Vec])[] =>
  edgesOf(corners(handle, of), isClosed(handle.kind));

export const isLine = (handle: Handle): handle is LineHandle => handle.kind !== 'point';

/** Whether the turn of a point follows from the pose of the others. Bars and polygons turn with their corners. */
export const isAutomatic = (handle: Handle): boolean => !isLine(handle) && handle.rotation === 'auto';

/**
 * The handle's rotation in degrees.
 *
 * For a bar or polygon, the turn of its corners, with the whole turns that bring it nearest to its own `rotation`. For
 * an automatic point, its entry in `turns`.
 */
export function rotationOf(handle: Handle, turns = NO_TURNS): number {
  const given = typeof handle.rotation === 'number' ? handle.rotation : 0;
  if (isLine(handle)) return turnNear(handle, given);
  return handle.rotation === 'auto' ? (turns.get(handle.id) ?? 0) : given;
}

export const scaleOf = (handle: Handle): number => handle.scale ?? 1;
export const depthOf = (handle: Handle): number => handle.depth ?? 0;

/** The range of depths that an edit can give a handle. */
export const DEPTHS = { least: -10, most: 10 } as const;

/** The range of scales that an edit can give a handle. */
export const SCALES = { least: 0.01, most: 100 } as const;

/** The handle's name for people: its id, as words if it is written in small letters and hyphens. */
export const nameOf = ({ id }: Pick<Handle, 'id'>): string =>
  /[\s\p{Lu}]/u.test(id) ? id : id.replace(/[-_]+/g, ' ').trim() || id;

/** Applies `place` to every posed corner. */
export const replaced = (handle: Handle, place: (p: Vec) => Vec): Handle =>
  isLine(handle) ? { ...handle, posed: handle.posed.map(place) } : { ...handle, posed: place(handle.posed) };

export const moved = (handle: Handle, by: Vec): Handle => replaced(handle, (p) => roundedVec(add(p, by)));

/** Returns the map that turns a corner by degrees and scales it about a pivot. */
const around =
  (pivot: Vec, turn: number, scale: number) =>
  (corner: Vec): Vec =>
    roundedVec(add(pivot, rotated(scaled(subtract(corner, pivot), scale), turn)));

/**
 * Turns the handle about its anchor to a rotation in degrees.
 *
 * Whole turns are kept. Half a turn more and half a turn less look alike at the handle, but not between it and handles
 * with other turns.
 */
export function turnedTo(handle: Handle, degrees: number): Handle {
  if (!isLine(handle)) return { ...handle, rotation: rounded(degrees) };
  const turn = degrees - rotationOf(handle);
  return { ...replaced(handle, around(anchor(handle), turn, 1)), rotation: rounded(degrees) };
}

/** Turns the handle by degrees and scales it about a pivot. An automatic rotation stays automatic. */
export function turnedAbout(handle: Handle, pivot: Vec, turn: number, scale: number): Handle {
  return {
    ...replaced(handle, around(pivot, turn, scale)),
    ...(turn === 0 || isAutomatic(handle) ? {} : { rotation: rounded(rotationOf(handle) + turn) }),
    ...(scale === 1 ? {} : { scale: roundedScale(scaleOf(handle) * scale) }),
  };
}

/**
 * Moves one corner of the handle. Its turn continues from `before`, in degrees: a corner that goes around the others by
 * more than half a turn does not flip the picture.
 */
export function cornerPut(
  handle: LineHandle,
  index: number,
  at: Vec,
  before = rotationOf(handle),
): LineHandle {
  const posed = handle.posed.map((corner, k) => (k === index ? roundedVec(at) : corner));
  const next: LineHandle = { ...handle, posed };
  const turn = turnNear(next, before);
  const counted = typeof handle.rotation === 'number' || Math.abs(turn) > 180;
  return counted ? { ...next, rotation: rounded(turn) } : next;
}

/** The least number of corners of a bar or polygon, and of a lasso. */
export const CORNERS_NEEDED: Readonly<Record<LineHandle['kind'] | 'lasso', number>> = {
  bar: 2,
  polygon: 3,
  lasso: 3,
};

/** Adds a corner at the same fraction of an edge, at rest and posed. The edge stays straight. */
export function cornerAdded(handle: LineHandle, { edge, fraction }: LinePlace): LineHandle {
  const divided = (corners: readonly Vec[]): readonly Vec[] => {
    const ends = edgesOf(corners, isClosed(handle.kind))[edge];
    if (!ends) return corners;
    return [...corners.slice(0, edge + 1), roundedVec(lerp(...ends, fraction)), ...corners.slice(edge + 1)];
  };
  return { ...handle, rest: divided(handle.rest), posed: divided(handle.posed) };
}

/** Removes one corner of the handle. */
export function cornerRemoved(handle: LineHandle, index: number): LineHandle {
  const without = (corners: readonly Vec[]) => corners.filter((_, k) => k !== index);
  return { ...handle, rest: without(handle.rest), posed: without(handle.posed) };
}

const KEYS: readonly string[] = ['id', 'kind', 'rest', 'posed', 'rotation', 'scale', 'depth', 'stiffness'];
const KINDS: readonly string[] = ['point', 'bar', 'polygon'];

/**
 * Returns the handle if the solver can pose it.
 * @throws RangeError with the handle, the invalid key and the expected value.
 */
export function checkedHandle(handle: Handle): Handle {
  const { id, rotation = 0, scale = 1, depth = 0 } = handle;
  const refuse = (what: string) => {
    throw new RangeError(`handle "${shownName(String(id).slice(0, MAX_NAME))}", ${what}`);
  };
  const isNumber = (value: unknown) => typeof value === 'number' && Math.abs(value) < BEYOND;
  if (typeof id !== 'string' || id === '') refuse('id: expected a name');
  if ([...id].length > MAX_NAME) refuse(`id: expected a name of at most ${MAX_NAME} characters`);
  if (!KINDS.includes(handle.kind)) refuse('kind: expected "point", "bar" or "polygon"');
  const unknown = Object.keys(handle).find((key) => !KEYS.includes(key));
  if (unknown !== undefined) refuse(`${unknown}: unknown key; expected one of ${KEYS.join(', ')}`);
  for (const key of ['rest', 'posed'] as const) {
    const needed = isLine(handle) ? CORNERS_NEEDED[handle.kind] : 1;
    const places: unknown = isLine(handle) ? handle[key] : [handle[key]];
    const isPlace = (p: unknown) => Array.isArray(p) && p.length === 2 && p.every(isNumber);
    if (!Array.isArray(places) || places.length < needed || !places.every(isPlace)) {
      refuse(`${key}: expected ${needed > 1 ? `${needed} points or more` : 'a point'} [x, y]`);
    }
  }
  if (corners(handle).length !== corners(handle, 'rest').length)
    refuse('posed: expected as many points as in rest');
  if (rotation !== 'auto' && !isNumber(rotation)) refuse('rotation: expected degrees or "auto"');
  if (!(isNumber(scale) && scale > 0)) refuse(`scale: expected a number above 0 and below ${BEYOND}`);
  if (!isNumber(depth)) refuse(`depth: expected a number above -${BEYOND} and below ${BEYOND}`);
  return handle;
}

/** The values of keys that a file leaves out. */
const DEFAULTS = { rotation: 0, scale: 1, depth: 0, stiffness: 0 } as const;

/** A changed handle without defaults that it left out before: they would change the file, and nothing else. */
export function withoutNewDefaults<H extends Handle>(handle: H, before: Handle): H {
  const isNew = (key: string): boolean =>
    Reflect.get(handle, key) === Reflect.get(DEFAULTS, key) && Reflect.get(before, key) === undefined;
  const added = Object.keys(DEFAULTS).filter(isNew);
  if (added.length === 0) return handle;
  const others = Object.entries(handle).filter(([key]) => !added.includes(key));
  return Object.fromEntries(others) as unknown as H;
}

/** Makes the rotation automatic. */
export const withAutoRotation = (handle: Handle): Handle => ({ ...handle, rotation: 'auto' });

/** Sets the scale of the handle. The corners of a bar or polygon are scaled about its anchor. */
export function scaledTo(handle: Handle, scale: number): Handle {
  const grown = { ...handle, scale: rounded(scale) };
  if (!isLine(handle)) return grown;
  // From the rounded scale, since the next change starts from it.
  return replaced(grown, around(anchor(handle), 0, grown.scale / scaleOf(handle)));
}

export const atDepth = (handle: Handle, depth: number): Handle => ({
  ...handle,
  depth: rounded(Math.min(DEPTHS.most, Math.max(DEPTHS.least, depth))),
});

/** Returns the handle in its rest pose, with a scale of 1. A point takes `rotation`. */
export const atRest = (handle: Handle, rotation: Rotation): Handle =>
  isLine(handle)
    ? { ...handle, posed: handle.rest, rotation: 'auto', scale: 1 }
    : { ...handle, posed: handle.rest, rotation, scale: 1 };

/**
 * Poses the handle like another one of the same kind, relative to their rest poses.
 *
 * It is moved by the same vector, turned and scaled about its own middle, and bent at the corresponding positions. It
 * takes the depth of `like`.
 */
export function posedLike(handle: Handle, like: Handle): Handle {
  const apart = subtract(restMiddle(handle), restMiddle(like));
  const along = (rest: Vec) => roundedVec(add(followed(like, subtract(rest, apart)), apart));
  const { posed } = replaced({ ...handle, posed: handle.rest } as Handle, along);
  return posedAs(handle, { ...like, posed } as Handle);
}

/** A handle with the pose of another one of the same form. Values that the other one leaves out are left out. */
export function posedAs(handle: Handle, { posed, rotation, scale, depth }: Handle): Handle {
  const values = Object.entries({ ...handle, posed, rotation, scale, depth });
  return Object.fromEntries(values.filter(([, value]) => value !== undefined)) as unknown as Handle;
}

const restMiddle = (handle: Handle): Vec => lineCentroid(corners(handle, 'rest'), isClosed(handle.kind));

/** Returns the posed position of a rest position that is fixed to the nearest part of a handle. */
function followed(handle: Handle, at: Vec): Vec {
  const { edge, fraction } = nearestPlace(corners(handle, 'rest'), isClosed(handle.kind), at);
  const [from, to] = [edges(handle, 'rest')[edge], edges(handle)[edge]];
  if (!from || !to) return at;
  const beside = scaled(subtract(at, lerp(...from, fraction)), scaleOf(handle));
  return add(lerp(...to, fraction), rotated(beside, rotationOf(handle)));
}

/** Whether every corner is at its rest position. Rotation and scale do not count. */
export function isInPlace(handle: Handle): boolean {
  const rest = corners(handle, 'rest');
  return corners(handle).every((p, k) => p[0] === rest[k]?.[0] && p[1] === rest[k]?.[1]);
}

/** Whether the handle is not moved, turned or scaled. An automatic rotation of a point does not count. */
export const isAtRest = (handle: Handle): boolean =>
  isInPlace(handle) && rotationOf(handle) === 0 && scaleOf(handle) === 1;

/** The turn of the corners, with the whole turns that bring it nearest to `degrees`. */
function turnNear({ rest, posed }: LineHandle, degrees: number): number {
  const turn = bestTurn(rest, posed);
  return turn === null ? degrees : nearestTurn(turn, degrees);
}

export { rounded, roundedScale, roundedVec };
