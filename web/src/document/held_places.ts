/** Places that the brush leaves while the boundary is held: the outline, and those close to it. */
import type { Vec } from '../geometry/vec';
import type { Field } from './displacement';

/** Pieces × 2 ends × 2, at rest, image pixels. */
export type Outline = ArrayLike<number>;

/** Spacings of control points. Farther ones do not belong to a place. */
const HELD = 3;
/** From this distance on, the brush counts fully. */
const FREE = 8;

/**
 * For each control point, how much of a dab it takes: nothing close to the outline, so that the field is 0 on it, and
 * smoothly more up to all of it. Cost: linear in the length of the outline.
 */
export function takenShares({ width, height, spacing }: Field, outline: Outline): Float32Array {
  const away = new Float32Array(width * height).fill(FREE);
  const unit = Math.max(...spacing);
  for (let at = 0; at + 3 < outline.length; at += 4) {
    const [a, b] = [place(outline, at), place(outline, at + 2)];
    const [columns, rows] = ([0, 1] as const).map((axis) => {
      const room = FREE * unit;
      const count = axis === 0 ? width : height;
      return [
        Math.max(0, Math.ceil((Math.min(a[axis], b[axis]) - room) / spacing[axis] + 1)),
        Math.min(count - 1, Math.floor((Math.max(a[axis], b[axis]) + room) / spacing[axis] + 1)),
      ] as const;
    }) as [readonly [number, number], readonly [number, number]];
    for (let row = rows[0]; row <= rows[1]; row++)
      for (let column = columns[0]; column <= columns[1]; column++) {
        const p: Vec = [(column - 1) * spacing[0], (row - 1) * spacing[1]];
        const index = row * width + column;
        away[index] = Math.min(away[index] ?? FREE, distanceTo(p, a, b) / unit);
      }
  }
  return away.map((spacings) => {
    const t = Math.min(Math.max((spacings - HELD) / (FREE - HELD), 0), 1);
    return t * t * t * (t * (6 * t - 15) + 10);
  });
}

const place = (outline: Outline, at: number): Vec => [outline[at] ?? 0, outline[at + 1] ?? 0];

function distanceTo(p: Vec, a: Vec, b: Vec): number {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const [px, py] = [p[0] - a[0], p[1] - a[1]];
  const square = x * x + y * y;
  const share = square === 0 ? 0 : Math.min(Math.max((x * px + y * py) / square, 0), 1);
  return Math.hypot(px - share * x, py - share * y);
}
