/** Poses between two poses of the same handles, for a guard to try when the second one goes too far. */
import { centre } from '../geometry/polyline';
import { add, bearing, distance, rotated, scaled, subtract, type Vec, wrapDegrees } from '../geometry/vec';
import { corners, isLine, rotationOf, rounded, roundedVec, scaleOf, type Turns } from './handle';
import type { Handle, Project } from './project';

/**
 * The project posed at `share` of the way: 0 is the pose of `from`, 1 that of `to`. All but the poses is taken from
 * `to`, as are handles that `from` lacks.
 *
 * @param turns how far automatic points are turned in `from`.
 * @param about where handles go around as one, instead of straight on, each by at most half a turn.
 */
export function between(from: Project, to: Project, share: number, turns: Turns, about?: Vec): Project {
  const before = new Map(from.handles.map((handle) => [handle.id, handle]));
  return {
    ...to,
    handles: to.handles.map((handle) => {
      const start = before.get(handle.id);
      return start && start !== handle ? eased(start, handle, share, turns, about) : handle;
    }),
  };
}

function eased(from: Handle, to: Handle, share: number, turns: Turns, about: Vec | undefined): Handle {
  const start = rotationOf(from, turns);
  const by = rotationOf(to, turns) - start;
  // The turn of a point is kept without whole turns.
  const end = start + (about || !isLine(to) ? wrapDegrees(by) : by);
  const turn = start + share * (end - start);
  const middle = underway(centre(corners(from)), centre(corners(to)), share, about);
  const rotation =
    typeof to.rotation === 'number' ? { rotation: rounded(isLine(to) ? turn : wrapDegrees(turn)) } : {};
  const scale = scaleOf(from) + share * (scaleOf(to) - scaleOf(from));
  const common = { ...rotation, ...(to.scale === undefined ? {} : { scale }) };
  return isLine(to)
    ? { ...to, ...common, posed: turnedBetween(from, to, share, middle, [start, turn, end]) }
    : { ...to, ...common, posed: roundedVec(middle) };
}

function underway(from: Vec, to: Vec, share: number, about: Vec | undefined): Vec {
  const [before, after] = about ? [distance(about, from), distance(about, to)] : [0, 0];
  if (!about || before === 0) return mix(from, to, share);
  const turn = wrapDegrees(bearing(about, to) - bearing(about, from));
  const growth = 1 + share * (after / before - 1);
  return add(about, rotated(scaled(subtract(from, about), growth), share * turn));
}

/** Turns a line as a whole, so that it keeps its length on the way. */
function turnedBetween(
  from: Handle,
  to: Handle,
  share: number,
  middle: Vec,
  [start, turn, end]: readonly [number, number, number],
): readonly Vec[] {
  const [a, b] = [corners(from), corners(to)];
  if (a.length !== b.length) return b;
  const [heart, goal] = [centre(a), centre(b)];
  return b.map((corner, k) => {
    const before = rotated(subtract(a[k] ?? heart, heart), turn - start);
    const after = rotated(subtract(corner, goal), turn - end);
    return roundedVec(add(middle, mix(before, after, share)));
  });
}

const mix = (a: Vec, b: Vec, share: number): Vec => add(scaled(a, 1 - share), scaled(b, share));
