/**
 * Poses of handles as one flat array, which the solver receives in every frame.
 *
 * Layout of a handle: corner count n (1 for a point), rotation in degrees (NaN if automatic), scale, depth, then n × 2
 * coordinates. The handles of the solution come first, in its order.
 */
import type { Vec } from '../geometry/vec';
import { corners, depthOf, isLine, scaleOf } from './handle';
import type { Handle, Project } from './project';
import { followedHandles } from './solved';

/** Count of numbers before the corners of a handle. */
const HEAD = 4;

/** The pose of one handle. */
export interface HandlePose {
  readonly posed: readonly Vec[];
  /** Degrees; NaN if automatic. */
  readonly rotation: number;
  readonly scale: number;
  readonly depth: number;
}

/** Returns the poses of the solved project's handles, taken from `project` if it has them. */
export const projectPoses = (solved: Project, project: Project): Float64Array =>
  handlePoses(followedHandles(solved, project));

export function handlePoses(handles: readonly Handle[]): Float64Array {
  const length = handles.reduce((sum, handle) => sum + HEAD + 2 * corners(handle).length, 0);
  const numbers = new Float64Array(length);
  let at = 0;
  for (const handle of handles) {
    const places = corners(handle);
    numbers.set([places.length, rotationNumber(handle), scaleOf(handle), depthOf(handle)], at);
    at += HEAD;
    for (const place of places) {
      numbers.set(place, at);
      at += 2;
    }
  }
  return numbers;
}

/** Reads the poses of an array of this layout. */
export function readPoses(numbers: Float64Array): readonly HandlePose[] {
  const poses: HandlePose[] = [];
  let at = 0;
  while (at < numbers.length) {
    const [count = 0, rotation = 0, scale = 1, depth = 0] = numbers.subarray(at, at + HEAD);
    at += HEAD;
    const posed = Array.from(
      { length: count },
      (_, k): Vec => [numbers[at + 2 * k] ?? 0, numbers[at + 2 * k + 1] ?? 0],
    );
    at += 2 * count;
    poses.push({ posed, rotation, scale, depth });
  }
  return poses;
}

/** Poses the handle. Returns `handle` itself if nothing changes. Writes only the keys that change. */
export function withPose(handle: Handle, { posed, rotation, scale, depth }: HandlePose): Handle {
  const isTurned = !Object.is(rotation, rotationNumber(handle));
  const isScaled = scale !== scaleOf(handle);
  const isRaised = depth !== depthOf(handle);
  const isMoved = corners(handle).some(([x, y], k) => x !== posed[k]?.[0] || y !== posed[k]?.[1]);
  if (!isTurned && !isScaled && !isRaised && !isMoved) return handle;
  const changes = {
    ...(isTurned ? { rotation: Number.isNaN(rotation) ? ('auto' as const) : rotation } : {}),
    ...(isScaled ? { scale } : {}),
    ...(isRaised ? { depth } : {}),
  };
  return isLine(handle)
    ? { ...handle, ...changes, posed }
    : { ...handle, ...changes, posed: posed[0] ?? handle.posed };
}

const rotationNumber = ({ rotation = 0 }: Handle): number => (rotation === 'auto' ? Number.NaN : rotation);
