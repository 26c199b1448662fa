/** Checks lists of points from a page. */

/** @throws TypeError unless `points` is a Float64Array of pairs. */
export function checkedPairs(method: string, points: unknown): Float64Array {
  if (!(points instanceof Float64Array) || points.length % 2 !== 0)
    throw new TypeError(`${method}: expected a Float64Array of pairs, x and y of each point`);
  return points;
}
