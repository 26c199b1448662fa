/**
 * How the brush has moved places of the picture at rest: a cubic B-spline over it, of control points in a grid.
 *
 * Control point (i, j) stands at ((i − 1) · spacing, (j − 1) · spacing): one row and column lies beyond each edge. A
 * place p of the picture goes where the handles would take p + d(p).
 */
import type { Vec } from '../geometry/vec';
import { fromBase64, toBase64 } from './base64';
import type { Displacement, ImageRef, Project } from './project';

/** Control points, and how each moves. */
export interface Field {
  /** Columns and rows of control points. */
  readonly width: number;
  readonly height: number;
  /** Between columns, and between rows, image pixels. */
  readonly spacing: Vec;
  /** Control points × 2, rows from top to bottom, image pixels. */
  readonly values: Float64Array;
}

/** Intervals along the longer side of a picture. */
const INTERVALS = 128;
/** Control points beyond those at the ends of the intervals. */
const BEYOND = 3;
/** A file has whole numbers of this part of the spacing, in 16 bits. */
const PARTS = 256;
const MOST = 2 ** 15 - 1;

/** The field of a picture in which nothing has moved, as square as it can be. */
export function restingField(image: ImageRef): Field {
  const longer = Math.max(image.width, image.height);
  const [across, down] = [image.width, image.height].map((side) =>
    Math.max(1, Math.round((INTERVALS * side) / longer)),
  );
  return fieldOf(image, (across ?? 1) + BEYOND, (down ?? 1) + BEYOND);
}

const fieldOf = (image: ImageRef, width: number, height: number): Field => ({
  width,
  height,
  spacing: [image.width / (width - BEYOND), image.height / (height - BEYOND)],
  values: new Float64Array(2 * width * height),
});

/** The displacement read last. Strokes continue from it. */
let read: { readonly of: Displacement; readonly numbers: Int16Array } | null = null;
/** The numbers of displacements that have no text yet. */
const unwritten = new WeakMap<Displacement, Int16Array>();

/** Control points × 2: the numbers of a displacement. */
export function numbersOf(displacement: Displacement): Int16Array {
  const own = unwritten.get(displacement);
  if (own) return own;
  if (read?.of !== displacement) read = { of: displacement, numbers: numbersIn(displacement.values) };
  return read.numbers;
}

function numbersIn(text: string): Int16Array {
  const bytes = fromBase64(text);
  const view = new DataView(bytes.buffer);
  return Int16Array.from({ length: bytes.length / 2 }, (_, at) => view.getInt16(2 * at, true));
}

/** A displacement whose text is made when it is first read: a drag makes many that nobody stores. */
export function displacementOf(width: number, height: number, numbers: Int16Array): Displacement {
  let text: string | null = null;
  const displacement: Displacement = {
    width,
    height,
    get values() {
      if (text === null) {
        text = textOf(numbers);
        unwritten.delete(displacement);
        read = { of: displacement, numbers };
      }
      return text;
    },
  };
  unwritten.set(displacement, numbers);
  return displacement;
}

function textOf(numbers: Int16Array): string {
  const bytes = new Uint8Array(2 * numbers.length);
  const view = new DataView(bytes.buffer);
  numbers.forEach((number, at) => {
    view.setInt16(2 * at, number, true);
  });
  return toBase64(bytes);
}

/** Whether two displacements move all places alike. */
export function isSameDisplacement(a: Displacement | undefined, b: Displacement | undefined): boolean {
  if (a === b || !a || !b) return a === b;
  if (a.width !== b.width || a.height !== b.height) return false;
  if (!unwritten.has(a) && !unwritten.has(b)) return a.values === b.values;
  const [one, other] = [numbersOf(a), numbersOf(b)];
  for (let at = 0; at < one.length; at++) if (one[at] !== other[at]) return false;
  return true;
}

/** The field of a project, as fine as {@link restingField}: a coarser one could not hold a stroke. */
export function fieldForStrokes({ displacement, image }: Project): Field {
  const resting = restingField(image);
  if (!displacement) return resting;
  const own = fieldOf(image, displacement.width, displacement.height);
  numbersOf(displacement).forEach((number, at) => {
    own.values[at] = (number / PARTS) * (own.spacing[at % 2] ?? 0);
  });
  return own.width === resting.width && own.height === resting.height ? own : resampled(own, resting);
}

/**
 * The project with a field. Without a place that moves it has no displacement.
 *
 * @param round of the numbers of a file.
 */
export function withField(
  project: Project,
  { width, height, spacing, values }: Field,
  round: (number: number) => number = Math.round,
): Project {
  const numbers = new Int16Array(values.length);
  let moves = false;
  for (let at = 0; at < values.length; at++) {
    const number = round((PARTS * (values[at] as number)) / (spacing[at % 2] as number));
    numbers[at] = Math.min(Math.max(number, -MOST), MOST);
    moves ||= numbers[at] !== 0;
  }
  if (!moves) return withoutDisplacement(project);
  return { ...project, displacement: displacementOf(width, height, numbers) };
}

/** Towards 0, except from an error of floating point. */
export const towardsRest = (number: number): number => Math.trunc(number + Math.sign(number) * 1e-6);

export function withoutDisplacement(project: Project): Project {
  const { displacement: _, ...resting } = project;
  return resting;
}

/** How a place of the picture moves. Beyond the picture, as its edge does. */
export function displacementAt(field: Field, place: Vec): Vec {
  const { width, height, spacing, values } = field;
  const [left, across] = basisAt(place[0] / spacing[0], width);
  const [top, down] = basisAt(place[1] / spacing[1], height);
  let [x, y] = [0, 0];
  for (let row = 0; row < 4; row++)
    for (let column = 0; column < 4; column++) {
      const weight = (down[row] ?? 0) * (across[column] ?? 0);
      const at = 2 * ((top + row) * width + left + column);
      x += weight * (values[at] ?? 0);
      y += weight * (values[at + 1] ?? 0);
    }
  return [x, y];
}

/** The first control point that counts at a place, measured in spacings, and the weights of it and the next. */
function basisAt(place: number, count: number): readonly [first: number, weights: readonly number[]] {
  const within = Math.min(Math.max(place, 0), count - BEYOND);
  const first = Math.min(Math.floor(within), count - BEYOND - 1);
  const t = within - first;
  const left = 1 - t;
  return [
    first,
    [left ** 3 / 6, (3 * t ** 3 - 6 * t * t + 4) / 6, (3 * left ** 3 - 6 * left * left + 4) / 6, t ** 3 / 6],
  ];
}

/** The field on other control points. The error falls with the fourth power of the spacing. */
function resampled(from: Field, to: Field): Field {
  const { width, height, spacing } = to;
  const at = (column: number, row: number): Vec =>
    displacementAt(from, [(column - 1) * spacing[0], (row - 1) * spacing[1]]);
  const sampled = new Float64Array(2 * width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) sampled.set(at(column, row), 2 * (row * width + column));
  const across = sharpened(sampled, width, height, 1, width);
  return { ...to, values: sharpened(across, height, width, width, 1) };
}

/** Control values of a spline that takes about these values at the control points, along lines of a grid. */
function sharpened(
  values: Float64Array,
  length: number,
  lines: number,
  step: number,
  lineStep: number,
): Float64Array {
  const result = values.slice();
  for (let line = 0; line < lines; line++)
    for (let k = 1; k < length - 1; k++)
      for (let axis = 0; axis < 2; axis++) {
        const at = 2 * (line * lineStep + k * step) + axis;
        const beside = (values[at - 2 * step] ?? 0) + (values[at + 2 * step] ?? 0);
        result[at] = (8 * (values[at] ?? 0) - beside) / 6;
      }
  return result;
}
