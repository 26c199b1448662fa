/**
 * Where something stands along one axis, beside a place: after it, or before it where there is no room; always between
 * two ends, and at the first where it is longer than that.
 *
 * @param gap between it and the place.
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
