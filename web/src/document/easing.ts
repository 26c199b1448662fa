/** Poses between two poses of the same handles, for a guard to try when the second one goes too far. */
import { centre } from '../geometry/polyline';
import { add, lerp, rotated, subtract, type Vec } from '../geometry/vec';
import {
  corners,
  isLine,
  rotationOf,
  rounded,
  roundedScale,
  roundedVec,
  scaleOf,
  type Turns,
} from './handle';
import type { Handle, Project } from './project';

/**
 * The project posed at `fraction` of the way: 0 is the pose of `from`, 1 that of `to`. All but the poses is taken from
 * `to`, as are handles that `from` lacks.
 *
 * @param turns how far automatic points are turned in `from`.
 */
export function between(from: Project, to: Project, fraction: number, turns: Turns): Project {
  const before = new Map(from.handles.map((handle) => [handle.id, handle]));
  return {
    ...to,
    handles: to.handles.map((handle) => {
      const start = before.get(handle.id);
      return start && start !== handle ? eased(start, handle, fraction, turns) : handle;
    }),
  };
}

function eased(from: Handle, to: Handle, fraction: number, turns: Turns): Handle {
  const [start, end] = [rotationOf(from, turns), rotationOf(to, turns)];
  const turn = start + fraction * (end - start);
  const middle = lerp(centre(corners(from)), centre(corners(to)), fraction);
  const growth = scaleOf(to) - scaleOf(from);
  const common = {
    ...(typeof to.rotation === 'number' ? { rotation: rounded(turn) } : {}),
    ...(growth === 0 ? {} : { scale: roundedScale(scaleOf(from) + fraction * growth) }),
  };
  return isLine(to)
    ? { ...to, ...common, posed: turnedBetween(from, to, fraction, middle, [start, turn, end]) }
    : { ...to, ...common, posed: roundedVec(middle) };
}

/** Turns a line as a whole, so that it keeps its length on the way. */
function turnedBetween(
  from: Handle,
  to: Handle,
  fraction: number,
  middle: Vec,
  [start, turn, end]: readonly [number, number, number],
): readonly Vec[] {
  const [a, b] = [corners(from), corners(to)];
  if (a.length !== b.length) return b;
  const [heart, goal] = [centre(a), centre(b)];
  return b.map((corner, k) => {
    const before = rotated(subtract(a[k] ?? heart, heart), turn - start);
    const after = rotated(subtract(corner, goal), turn - end);
    return roundedVec(add(middle, lerp(before, after, fraction)));
  });
}
