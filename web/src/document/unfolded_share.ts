/**
 * How much of a change a field takes without turning the picture over.
 *
 * At control points and halfway between them, the field brings a small square to a parallelogram. Its area must keep
 * above a bound, and above a part of the mean square of its sides: a long thin one could turn over between the samples.
 * Both are quadratics of the share of the change, so the first root of their difference is the limit.
 *
 * Slopes of a spline lie between the differences of its neighbouring control points. Where all of these are small,
 * before and after the change, nothing is sampled.
 *
 * Cost: linear in the control points. Limit: nothing looks between the samples.
 */
import type { Vec } from '../geometry/vec';
import type { Window } from './box_means';
import type { Field } from './displacement';

/** The least area of a unit square. With less, rounding in the file could turn it over. */
const LEAST_AREA = 0.06;
/** The least area, as a part of the mean square of the sides. */
const LEAST_PART = 0.1;

/**
 * With slopes up to ε, the area is at least 1 − 2ε, and the mean square of the sides at most 1 + 2ε + 2ε². This ε keeps
 * above both bounds.
 */
const CALM = 0.36;

/**
 * How much of the way from one field to another keeps the picture, from 0 to 1. They differ within a window. Where a
 * parallelogram is beyond the bounds already, it must not get worse.
 */
export function unfoldedShare(before: Field, after: Field, changed: Window): number {
  const { width, height, spacing } = before;
  // A place has control points at most two away.
  const left = Math.max(0, changed.left - 3);
  const top = Math.max(0, changed.top - 3);
  const columns = Math.min(width - 1, changed.left + changed.columns + 2) - left + 1;
  const rows = Math.min(height - 1, changed.top + changed.rows + 2) - top + 1;
  const both = sideBySide(before, after, { left, top, columns, rows });
  const perPixel: Vec = [1 / spacing[0], 1 / spacing[1]];
  const steepness = steepnessOf(both, columns, rows, perPixel);
  const steep = new Uint8Array(columns);
  const down = new Float64Array(8 * columns);
  let share = 1;
  for (let row = 0; row + 3 < rows; row++) {
    if (!findSteep(steepness, row * columns, columns, steep)) continue;
    for (const halfway of [false, true]) {
      combineDown(both, 4 * row * columns, columns, halfway, perPixel[1], down);
      for (let column = 0; column + 3 < columns; column++) {
        if (steep[column] === 0) continue;
        share = Math.min(share, shareAt(down, 8 * column, false, perPixel[0]));
        share = Math.min(share, shareAt(down, 8 * column, true, perPixel[0]));
      }
    }
  }
  return share;
}

/** For each control point, the largest difference from the next one across and down, before and after the change. */
function steepnessOf(both: Float64Array, columns: number, rows: number, perPixel: Vec): Float64Array {
  const steepness = new Float64Array(columns * rows);
  for (let row = 0, own = 0; row < rows; row++)
    for (let column = 0; column < columns; column++, own++) {
      const across = column + 1 < columns ? differenceOf(both, 4 * own, 4 * own + 4) * perPixel[0] : 0;
      const down = row + 1 < rows ? differenceOf(both, 4 * own, 4 * (own + columns)) * perPixel[1] : 0;
      steepness[own] = Math.max(across, down);
    }
  return steepness;
}

function differenceOf(both: Float64Array, at: number, next: number): number {
  const x = (both[next] as number) - (both[at] as number);
  const y = (both[next + 1] as number) - (both[at + 1] as number);
  const dx = (both[next + 2] as number) - (both[at + 2] as number);
  const dy = (both[next + 3] as number) - (both[at + 3] as number);
  return Math.max(Math.abs(x), Math.abs(x + dx), Math.abs(y), Math.abs(y + dy));
}

/** Marks the columns of four control points each way that are not all calm. Returns whether there are any. */
function findSteep(steepness: Float64Array, from: number, columns: number, steep: Uint8Array): boolean {
  steep.fill(0);
  let any = false;
  for (let row = 0; row < 4; row++)
    for (let column = 0, at = from + row * columns; column < columns; column++, at++) {
      if ((steepness[at] as number) <= CALM) continue;
      any = true;
      for (let before = Math.max(0, column - 3); before <= column; before++) steep[before] = 1;
    }
  return any;
}

/** Control points of a window × 4: those of the first field in x and y, then the differences of the second. */
function sideBySide(before: Field, after: Field, { left, top, columns, rows }: Window): Float64Array {
  const both = new Float64Array(4 * columns * rows);
  for (let row = 0, to = 0; row < rows; row++)
    for (let column = 0; column < columns; column++, to += 4) {
      const at = 2 * ((top + row) * before.width + left + column);
      const [x, y] = [before.values[at] as number, before.values[at + 1] as number];
      both[to] = x;
      both[to + 1] = y;
      both[to + 2] = (after.values[at] as number) - x;
      both[to + 3] = (after.values[at + 1] as number) - y;
    }
  return both;
}

/**
 * The value and the slope of a spline by four control points: at the second one, or halfway to the third.
 * Factors, as a division takes longer.
 */
const levelOf = (a: number, b: number, c: number, d: number, halfway: boolean): number =>
  halfway ? (a + 23 * (b + c) + d) * (1 / 48) : (a + 4 * b + c) * (1 / 6);
const slopeOf = (a: number, b: number, c: number, d: number, halfway: boolean): number =>
  halfway ? (5 * (c - b) + d - a) * (1 / 8) : (c - a) * (1 / 2);

/** Columns × 8: the values, then the slopes down, of the four numbers of each column. */
function combineDown(
  both: Float64Array,
  from: number,
  columns: number,
  halfway: boolean,
  perPixel: number,
  down: Float64Array,
): void {
  const row = 4 * columns;
  for (let k = 0; k < row; k++) {
    const at = from + k;
    const a = both[at] as number;
    const b = both[at + row] as number;
    const c = both[at + 2 * row] as number;
    const d = both[at + 3 * row] as number;
    // Four numbers a column, of eight.
    const to = k + (k & ~3);
    down[to] = levelOf(a, b, c, d, halfway);
    down[to + 4] = slopeOf(a, b, c, d, halfway) * perPixel;
  }
}

const levelAt = (down: Float64Array, at: number, halfway: boolean): number =>
  levelOf(
    down[at] as number,
    down[at + 8] as number,
    down[at + 16] as number,
    down[at + 24] as number,
    halfway,
  );

const slopeAt = (down: Float64Array, at: number, halfway: boolean): number =>
  slopeOf(
    down[at] as number,
    down[at + 8] as number,
    down[at + 16] as number,
    down[at + 24] as number,
    halfway,
  );

function shareAt(down: Float64Array, at: number, halfway: boolean, perPixel: number): number {
  const dxx = slopeAt(down, at + 2, halfway) * perPixel;
  const dyx = slopeAt(down, at + 3, halfway) * perPixel;
  const dxy = levelAt(down, at + 6, halfway);
  const dyy = levelAt(down, at + 7, halfway);
  if (dxx === 0 && dyx === 0 && dxy === 0 && dyy === 0) return 1;
  const xx = 1 + slopeAt(down, at, halfway) * perPixel;
  const yx = slopeAt(down, at + 1, halfway) * perPixel;
  const xy = levelAt(down, at + 4, halfway);
  const yy = 1 + levelAt(down, at + 5, halfway);
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
