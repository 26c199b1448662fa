/** Poses from pages, in the format of project files, and their motions as a clip. */
import type { RigClip } from './clip';
import { depthOrder } from './depth_order';
import type { PosedSites } from './posing';
import type { Rig } from './rig';
import type { Handle, Place } from './shares';

/** Corners as in project files: one position for a point, a list for a bar or polygon. */
export type Corners = Place | readonly Place[];

/** A handle with its pose, as in project files. */
export interface PosedHandle extends Omit<Handle, 'rest' | 'posed'> {
  readonly rest: Corners;
  readonly posed: Corners;
}

/** A handle with changes of its pose. The kind and the rest position of a project's handle are ignored. */
export type HandlePose = Pick<PosedHandle, 'id'> & Partial<PosedHandle>;

/** A copy of a handle in the format of project files. */
export function fileHandle({ rest, posed, ...handle }: Handle): PosedHandle {
  const corners = (places: readonly Place[]) =>
    handle.kind === 'point' ? ([...(places[0] as Place)] as Place) : places.map(([x, y]): Place => [x, y]);
  return { ...handle, rest: corners(rest), posed: corners(posed) };
}

/**
 * @param turns whether automatic rotations are allowed.
 * @throws RangeError that names the handle; TypeError without a list.
 */
export function posedHandles(
  handles: readonly Handle[],
  poses: readonly HandlePose[],
  turns: boolean,
): readonly Handle[] {
  if (!Array.isArray(poses)) throw new TypeError('pose: expected a list of handles');
  const changes = new Map<string, HandlePose>(poses.map((pose) => [pose.id, pose]));
  for (const id of changes.keys())
    if (!handles.some((handle) => handle.id === id)) throw new RangeError(`there is no handle "${id}"`);
  return handles.map((handle) => changed(handle, changes.get(handle.id) ?? handle, turns));
}

function changed(handle: Handle, pose: HandlePose | Handle, turns: boolean): Handle {
  const { id } = handle;
  const check = (isRight: boolean, key: string, wanted: string) => {
    if (!isRight) throw new RangeError(`${id}: ${key}: expected ${wanted}`);
  };
  const {
    posed = handle.posed,
    rotation = handle.rotation,
    scale = handle.scale,
    depth = handle.depth,
  } = pose;
  const places = (Array.isArray(posed) && !Array.isArray(posed[0]) ? [posed] : posed) as readonly Place[];
  const isPlace = (place: Place) => place.length === 2 && place.every(Number.isFinite);
  const count = handle.rest.length;
  check(
    Array.isArray(places) && places.length === count && places.every(isPlace),
    'posed',
    count === 1 ? 'two numbers' : `${count} points of two numbers`,
  );
  check(
    Number.isFinite(rotation) || (turns && rotation === 'auto'),
    'rotation',
    turns ? 'degrees or "auto"' : 'degrees, because automatic rotation needs the solver',
  );
  check(Number.isFinite(scale) && scale > 0, 'scale', 'a number above 0');
  check(Number.isFinite(depth), 'depth', 'a number');
  return { ...handle, posed: places.map(([x, y]): Place => [x, y]), rotation, scale, depth };
}

/**
 * The rig with posed sites, as a clip of one frame. With `before`, it has two: from these motions, sites × 6, to the
 * pose.
 */
export function posedClip(rig: Rig, { motions, depths }: PosedSites, before?: Float64Array): RigClip {
  // Parts may cross anywhere.
  const orders = [{ frame: 0, crosses: true, triangles: depthOrder(rig, depths) }];
  const pose = { name: '', duration: 0, end: 0, orders };
  if (!before) return { ...pose, lastFrame: 0, keys: Uint32Array.of(0), motions };
  const both = new Float64Array([...before, ...motions]);
  return { ...pose, lastFrame: 1, keys: Uint32Array.of(0, 1), motions: both };
}
