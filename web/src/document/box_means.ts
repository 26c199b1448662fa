/** Means over squares of a grid. */
import type { Field } from './displacement';

/** A rectangle of control points. */
export interface Window {
  readonly left: number;
  readonly top: number;
  readonly columns: number;
  readonly rows: number;
}

/**
 * Columns × rows × 2: for each control point of a window, the mean over those at most `by` columns and rows away. The
 * edge of the field is extended. Cost: linear in the window, however large the squares are.
 */
export function boxMeans({ width, height, values }: Field, window: Window, by: number): Float64Array {
  const { left, top, columns, rows } = window;
  const within = (place: number, count: number) => Math.min(Math.max(place, 0), count - 1);
  const tall = rows + 2 * by;
  const across = new Float64Array(2 * columns * tall);
  for (let row = 0; row < tall; row++) {
    const line = within(top - by + row, height) * width;
    const value = (column: number) => values[2 * (line + within(column, width))] as number;
    const other = (column: number) => values[2 * (line + within(column, width)) + 1] as number;
    slide(across, 2 * row * columns, 2, columns, by, (k) => value(left + k));
    slide(across, 2 * row * columns + 1, 2, columns, by, (k) => other(left + k));
  }
  const means = new Float64Array(2 * columns * rows);
  for (let k = 0; k < 2 * columns; k++)
    slide(means, k, 2 * columns, rows, by, (row) => across[2 * (row + by) * columns + k] as number);
  const count = (2 * by + 1) ** 2;
  return means.map((sum) => sum / count);
}

/** Writes the sums of `2 by + 1` values around each of the first `count`, `step` apart. */
function slide(
  sums: Float64Array,
  at: number,
  step: number,
  count: number,
  by: number,
  value: (k: number) => number,
): void {
  let sum = 0;
  for (let k = -by; k <= by; k++) sum += value(k);
  for (let k = 0; k < count; k++) {
    sums[at + k * step] = sum;
    if (k + 1 < count) sum += value(k + by + 1) - value(k - by);
  }
}
