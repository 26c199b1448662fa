/**
 * Places a box beside an anchor along one axis, and returns where the box starts.
 *
 * The box lies after the anchor or, without room there, before it. It never leaves the range `least` to `most`; a box
 * longer than the range starts at `least`.
 *
 * @param gap The distance between anchor and box.
 */
export function beside(
  at: number,
  gap: number,
  size: number,
  [least, most]: readonly [number, number],
): number {
  const after = at + gap;
  const start = after + size <= most ? after : at - gap - size;
  return Math.max(least, Math.min(start, most - size));
}
