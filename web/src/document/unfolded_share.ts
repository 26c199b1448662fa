/**
 * How much of a dab a field takes without turning the picture over.
 *
 * At control points and halfway between them, the field brings a small square to a parallelogram. Its area must keep
 * above a bound, and above a part of the mean square of its sides: a long thin one could turn over between the samples.
 * Both are quadratics of the share of the dab, so the first root of their difference is the limit.
 *
 * Cost: linear in the control points. Limit: nothing looks between the samples.
 */
import type { Field } from './displacement';

/** A change of control points in a rectangle of a grid. */
export interface Change {
  /** Its first column and row, and its size. */
  readonly left: number;
  readonly top: number;
  readonly columns: number;
  readonly rows: number;
  /** Columns × rows × 2, image pixels. */
  readonly values: Float64Array;
}

/** The least area of a unit square. With less, rounding in the file could turn it over. */
const LEAST_AREA = 0.06;
/** The least area, as a part of the mean square of the sides. */
const LEAST_PART = 0.1;

/** Weights of four control points for the value and the slope: at the second one, and halfway to the third. */
const VALUES = [
  [1 / 6, 4 / 6, 1 / 6, 0],
  [1 / 48, 23 / 48, 23 / 48, 1 / 48],
].map((weights) => Float64Array.from(weights)) as [Float64Array, Float64Array];
const SLOPES = [
  [-1 / 2, 0, 1 / 2, 0],
  [-1 / 8, -5 / 8, 5 / 8, 1 / 8],
].map((weights) => Float64Array.from(weights)) as [Float64Array, Float64Array];

/** From 0 to 1. Where a parallelogram is beyond the bounds already, it must not get worse. */
export function unfoldedShare(field: Field, change: Change): number {
  const { width, height, spacing } = field;
  let share = 1;
  // A place has control points at most two away.
  const columns = [Math.max(1, change.left - 2), Math.min(width - 3, change.left + change.columns)] as const;
  const rows = [Math.max(1, change.top - 2), Math.min(height - 3, change.top + change.rows)] as const;
  const length = columns[1] - columns[0] + 4;
  // For each column: values and slopes down of the field in x and y, then those of the change.
  const down = new Float64Array(8 * Math.max(0, length));
  for (let row = rows[0]; row <= rows[1]; row++)
    for (let halfRow = 0; halfRow < 2; halfRow++) {
      combineDown(field, change, row, halfRow, columns[0] - 1, length, down, spacing[1]);
      for (let column = 0; column + 3 < length; column++)
        for (let half = 0; half < 2; half++) share = Math.min(share, shareAt(down, column, half, spacing[0]));
    }
  return share;
}

function combineDown(
  { width, values }: Field,
  change: Change,
  row: number,
  half: number,
  first: number,
  length: number,
  down: Float64Array,
  spacing: number,
): void {
  down.fill(0);
  for (let k = 0; k < 4; k++) {
    const value = VALUES[half]?.[k] ?? 0;
    const slope = (SLOPES[half]?.[k] ?? 0) / spacing;
    const from = row - 1 + k;
    const own = from - change.top;
    const isChanged = own >= 0 && own < change.rows;
    for (let column = 0; column < length; column++) {
      const to = 8 * column;
      const at = 2 * (from * width + first + column);
      const [x, y] = [values[at] ?? 0, values[at + 1] ?? 0];
      down[to] = (down[to] as number) + value * x;
      down[to + 1] = (down[to + 1] as number) + value * y;
      down[to + 2] = (down[to + 2] as number) + slope * x;
      down[to + 3] = (down[to + 3] as number) + slope * y;
      const along = first + column - change.left;
      if (!isChanged || along < 0 || along >= change.columns) continue;
      const changed = 2 * (own * change.columns + along);
      const [dx, dy] = [change.values[changed] ?? 0, change.values[changed + 1] ?? 0];
      down[to + 4] = (down[to + 4] as number) + value * dx;
      down[to + 5] = (down[to + 5] as number) + value * dy;
      down[to + 6] = (down[to + 6] as number) + slope * dx;
      down[to + 7] = (down[to + 7] as number) + slope * dy;
    }
  }
}

function shareAt(down: Float64Array, column: number, half: number, spacing: number): number {
  let [xx, xy, yx, yy] = [1, 0, 0, 1];
  let [dxx, dxy, dyx, dyy] = [0, 0, 0, 0];
  for (let k = 0; k < 4; k++) {
    const at = 8 * (column + k);
    const value = VALUES[half]?.[k] ?? 0;
    const slope = (SLOPES[half]?.[k] ?? 0) / spacing;
    xx += slope * (down[at] as number);
    yx += slope * (down[at + 1] as number);
    xy += value * (down[at + 2] as number);
    yy += value * (down[at + 3] as number);
    dxx += slope * (down[at + 4] as number);
    dyx += slope * (down[at + 5] as number);
    dxy += value * (down[at + 6] as number);
    dyy += value * (down[at + 7] as number);
  }
  const part = LEAST_PART / 2;
  const c = xx * yy - xy * yx - part * (xx * xx + xy * xy + yx * yx + yy * yy) - LEAST_AREA;
  const b =
    xx * dyy + dxx * yy - xy * dyx - dxy * yx - 2 * part * (xx * dxx + xy * dxy + yx * dyx + yy * dyy);
  const a = dxx * dyy - dxy * dyx - part * (dxx * dxx + dxy * dxy + dyx * dyx + dyy * dyy);
  return firstRoot(a, b, Math.max(0, c));
}

/** Where a t² + b t + c, which is not negative at 0, first becomes negative; 1 if it does not up to there. */
function firstRoot(a: number, b: number, c: number): number {
  // Almost everywhere: a bound of the whole way suffices.
  if (c + Math.min(b, 0) + Math.min(a, 0) > 0) return 1;
  if (c === 0 && (b < 0 || (b === 0 && a < 0))) return 0;
  const square = b * b - 4 * a * c;
  if (square <= 0 && a >= 0) return 1;
  const q = -(b + Math.sign(b || 1) * Math.sqrt(Math.max(square, 0))) / 2;
  const roots = [a === 0 ? Number.NaN : q / a, q === 0 ? Number.NaN : c / q].filter((root) => root > 0);
  return Math.min(1, ...roots);
}
