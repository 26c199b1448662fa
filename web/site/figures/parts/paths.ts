/** Paths as flat arrays: points × 2. */

export function pathLength(path: Float64Array): number {
  let length = 0;
  for (let at = 2; at < path.length; at += 2) {
    length += Math.hypot(
      (path[at] as number) - (path[at - 2] as number),
      (path[at + 1] as number) - (path[at - 1] as number),
    );
  }
  return length;
}
