/** A round path around a straight line. */
import type { Ring } from './ring';
import { distance, type Vec } from './vec';

/** Corners of half a circle. */
const HALF = 8;

/** All places nearer than `radius` to a straight line, as a ring. */
export function capsule(from: Vec, to: Vec, radius: number): Ring {
  const length = distance(from, to);
  const [x, y] = length > 0 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0];
  const half = (centre: Vec, sign: number): Ring =>
    Array.from({ length: HALF + 1 }, (_, k) => {
      const angle = Math.PI * (k / HALF - 0.5);
      const [along, aside] = [sign * radius * Math.cos(angle), sign * radius * Math.sin(angle)];
      return [centre[0] + along * x - aside * y, centre[1] + along * y + aside * x] as const;
    });
  return [...half(to, 1), ...half(from, -1)];
}
