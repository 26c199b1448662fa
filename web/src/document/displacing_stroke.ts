/**
 * A stroke of the brush that moves places of the picture: dabs along the way of the pointer.
 *
 * A dab acts on material that is already moved: control point x counts by the distance of y = x + d(x) from the middle
 * of the dab. Places of the stroke are such moved places too. Dabs are close enough together that the result hardly
 * depends on how often the pointer reports. A stroke adds up in floating point, and only the project is rounded.
 */
import { distance, lerp, scaled, subtract, type Vec } from '../geometry/vec';
import { boxMeans, type Window } from './box_means';
import { type Field, fieldForStrokes, towardsRest, withField } from './displacement';
import { type Outline, takenShares } from './held_places';
import type { Project } from './project';
import { unfoldedShare } from './unfolded_share';

export const DISPLACING = ['push', 'pinch', 'bloat', 'smooth', 'restore'] as const;
/** What a brush does that moves places. */
export type Displacing = (typeof DISPLACING)[number];

export interface DisplacingBrush {
  readonly kind: Displacing;
  /** Image pixels. */
  readonly radius: number;
  /** From 0 to 1. */
  readonly strength: number;
}

/** The limits of a stroke. */
export interface StrokeLimits {
  /** No place is turned over. */
  readonly guarded: boolean;
  /** The outline that stays; null where the boundary is free. */
  readonly held: Outline | null;
}

export interface DisplacingStroke {
  readonly project: Project;
  readonly brush: DisplacingBrush;
  readonly guarded: boolean;
  readonly field: Field;
  /** How much of a dab each control point takes; null for all of it. */
  readonly taken: Float32Array | null;
  /** The way to the next dab, image pixels. */
  readonly left: number;
  /** Whether the guard has held the last step back. */
  readonly stopped: boolean;
}

/** Parts of the radius between dabs, and between the steps of a push. */
const BETWEEN = 1 / 4;
const STEP = 1 / 8;
/** The effect of a dab of full strength in its middle. */
const RATES = { pinch: -0.12, bloat: 0.12, smooth: 0.6, restore: 0.3 } as const;
/** Smoothing takes the mean over squares: this part of the radius on each side. */
const SMOOTHED = 1 / 3;

export function beginDisplacing(
  project: Project,
  brush: DisplacingBrush,
  { guarded, held }: StrokeLimits,
): DisplacingStroke {
  const field = fieldForStrokes(project);
  return { project, brush, guarded, field, taken: held && takenShares(field, held), left: 0, stopped: false };
}

/**
 * The stroke, led on straight between two moved places; from `null` it begins there. The guard takes as much of all its
 * dabs together as turns nothing over.
 */
export function ledDisplacing(stroke: DisplacingStroke, from: Vec | null, to: Vec): DisplacingStroke {
  const field = { ...stroke.field, values: stroke.field.values.slice() };
  const { kind, radius } = stroke.brush;
  const way = from ? distance(from, to) : 0;
  const reached: Window[] = [];
  const add = (middle: Vec, move: Vec) => {
    const window = dab(stroke, field, middle, move);
    if (window) reached.push(window);
  };
  let left = 0;
  if (kind === 'push') {
    const steps = Math.ceil(way / (STEP * radius));
    for (let k = 0; from && k < steps; k++)
      add(lerp(from, to, k / steps), scaled(subtract(to, from), 1 / steps));
  } else {
    let next = from ? stroke.left : 0;
    for (; next <= way; next += BETWEEN * radius)
      add(from && way > 0 ? lerp(from, to, next / way) : to, [0, 0]);
    left = next - way;
  }
  const share = stroke.guarded ? guard(stroke.field, field, reached) : 1;
  return { ...stroke, field, left, stopped: share < 1 };
}

/** Leads a changed field back towards the one before, until nothing is turned over. Returns the share that it keeps. */
function guard(before: Field, field: Field, reached: readonly Window[]): number {
  if (reached.length === 0) return 1;
  const left = Math.min(...reached.map((window) => window.left));
  const top = Math.min(...reached.map((window) => window.top));
  const columns = Math.max(...reached.map((window) => window.left + window.columns)) - left;
  const rows = Math.max(...reached.map((window) => window.top + window.rows)) - top;
  const share = unfoldedShare(before, field, { left, top, columns, rows });
  if (share < 1)
    for (let at = 2 * top * field.width; at < 2 * (top + rows) * field.width; at++) {
      const from = before.values[at] as number;
      field.values[at] = from + share * ((field.values[at] as number) - from);
    }
  return share;
}

/** The project after the stroke. Restoring must come to rest in the end, also by weak strokes. */
export const withDisplacing = ({ project, field, brush }: DisplacingStroke): Project =>
  withField(project, field, brush.kind === 'restore' ? towardsRest : undefined);

/** Changes a field by one dab. Returns the control points that it reaches; null for none. */
function dab(stroke: DisplacingStroke, field: Field, middle: Vec, move: Vec): Window | null {
  const change = changeOf(stroke, field, middle, move);
  if (!change) return null;
  for (let row = 0; row < change.rows; row++) {
    const to = 2 * ((change.top + row) * field.width + change.left);
    for (let k = 0; k < 2 * change.columns; k++)
      field.values[to + k] =
        (field.values[to + k] as number) + (change.values[2 * row * change.columns + k] as number);
  }
  return change;
}

/** A change of control points within a window. */
interface Change extends Window {
  /** Columns × rows × 2, image pixels. */
  readonly values: Float64Array;
}

/** The change by a dab; null where it reaches no control point. */
function changeOf(
  { brush: { kind, radius, strength }, taken }: DisplacingStroke,
  field: Field,
  middle: Vec,
  move: Vec,
): Change | null {
  const reached = reachedBy(field, middle, radius);
  if (!reached) return null;
  const { left, top, columns, rows, shares, away } = reached;
  const values = new Float64Array(2 * columns * rows);
  const means = kind === 'smooth' ? boxMeans(field, reached, smoothedBy(field, radius)) : null;
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const own = row * columns + column;
      const weight = strength * (shares[own] ?? 0);
      if (weight === 0) continue;
      const at = (top + row) * field.width + left + column;
      // What once left a held place may always return.
      const share = kind === 'restore' ? 1 : (taken?.[at] ?? 1);
      for (let axis = 0; axis < 2; axis++) {
        const value = field.values[2 * at + axis] as number;
        const to = 2 * own + axis;
        const pulled = pull(kind, value, away[to] as number, move[axis] as number, means?.[to] ?? 0);
        values[to] = share * weight * pulled;
      }
    }
  return { left, top, columns, rows, values };
}

/** How a dab would move a control point of this value by full weight, along one axis. */
function pull(kind: Displacing, value: number, away: number, move: number, mean: number): number {
  switch (kind) {
    case 'push':
      return move;
    case 'pinch':
    case 'bloat':
      return RATES[kind] * away;
    case 'smooth':
      return RATES.smooth * (mean - value);
    case 'restore':
      return -RATES.restore * value;
  }
}

/** Control points on each side that smoothing takes the mean over. */
const smoothedBy = ({ spacing }: Field, radius: number): number =>
  Math.max(1, Math.round((SMOOTHED * radius) / Math.max(...spacing)));

/** The rectangle of control points that a dab reaches. */
interface Reached extends Window {
  /** Columns × rows: the weights, from 1 in the middle of the dab to 0 at its radius. */
  readonly shares: Float64Array;
  /** Columns × rows × 2: the way from the middle of the dab. */
  readonly away: Float64Array;
}

function reachedBy(field: Field, middle: Vec, radius: number): Reached | null {
  const near = nearTo(field, middle, radius);
  if (!near) return null;
  const { width, spacing, values } = field;
  const { left, top, columns, rows } = near;
  const shares = new Float64Array(columns * rows);
  const away = new Float64Array(2 * columns * rows);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const at = 2 * ((top + row) * width + left + column);
      const own = row * columns + column;
      const x = (left + column - 1) * spacing[0] + (values[at] as number) - middle[0];
      const y = (top + row - 1) * spacing[1] + (values[at + 1] as number) - middle[1];
      const px = x + unevenness(field, left + column, top + row, 0);
      const py = y + unevenness(field, left + column, top + row, 1);
      const square = (px * px + py * py) / (radius * radius);
      if (square >= 1) continue;
      const rest = 1 - square;
      shares[own] = rest * rest * rest;
      away[2 * own] = px;
      away[2 * own + 1] = py;
    }
  return { ...near, shares, away };
}

/**
 * A rectangle of control points that has all within the radius. A control point's own value is close to that of the
 * field there: cheap enough to rule most points out.
 */
function nearTo({ width, height, spacing, values }: Field, middle: Vec, radius: number): Window | null {
  const near = (radius + spacing[0] + spacing[1]) ** 2;
  let [left, right, top, bottom] = [width, -1, height, -1];
  for (let row = 0, at = 0; row < height; row++) {
    const below = (row - 1) * spacing[1] - middle[1];
    for (let column = 0; column < width; column++, at += 2) {
      const x = (column - 1) * spacing[0] - middle[0] + (values[at] as number);
      const y = below + (values[at + 1] as number);
      if (x * x + y * y >= near) continue;
      if (column < left) left = column;
      if (column > right) right = column;
      if (row < top) top = row;
      bottom = row;
    }
  }
  return right < 0 ? null : { left, top, columns: right - left + 1, rows: bottom - top + 1 };
}

/** The field at a control point, less the value of the control point. */
function unevenness({ width, height, values }: Field, column: number, row: number, axis: number): number {
  if (column > 0 && column < width - 1 && row > 0 && row < height - 1) {
    const at = 2 * (row * width + column) + axis;
    const line = 2 * width;
    const value = (by: number) => values[at + by] as number;
    const corners = value(-line - 2) + value(-line + 2) + value(line - 2) + value(line + 2);
    return (corners + 4 * (value(-line) + value(line) + value(-2) + value(2)) - 20 * value(0)) / 36;
  }
  let sum = 0;
  for (let down = -1; down <= 1; down++) {
    const line = Math.min(Math.max(row + down, 0), height - 1) * width;
    for (let across = -1; across <= 1; across++) {
      const weight = (down === 0 ? 4 : 1) * (across === 0 ? 4 : 1);
      sum += weight * (values[2 * (line + Math.min(Math.max(column + across, 0), width - 1)) + axis] ?? 0);
    }
  }
  return sum / 36 - (values[2 * (row * width + column) + axis] ?? 0);
}
