/**
 * How strong the edges of a picture are, in a window of its luminance: the steepness of the blurred luminance.
 *
 * Cost: linear in the nodes of the window, and in the numbers below it.
 */
import type { Luminance } from './luminance';
import type { Vec } from './vec';

/** A part of a luminance in nodes, each the mean of `step` × `step` numbers. */
export interface EdgeWindow {
  readonly width: number;
  readonly height: number;
  /** Image pixels of the upper left corner, and per node. */
  readonly origin: Vec;
  readonly pitch: number;
  /** Steepness at each node, levels per node. */
  readonly steepness: Float32Array;
}

/** Less steep places are noise. Levels per node. */
export const LEAST_STEEPNESS = 6;

/**
 * @param from the corner of the window in image pixels, @param to the opposite one.
 * @param most nodes of the window.
 */
export function edgeWindow(luminance: Luminance, from: Vec, to: Vec, most: number): EdgeWindow {
  const wanted = extent(luminance, from, to);
  const shrink = Math.sqrt((wanted.width * wanted.height) / most);
  // No move of a pointer reads all of a large picture. Means of some numbers follow the wanted size more closely.
  let source = luminance;
  for (let left = shrink; left >= 4 && source.coarser; left /= 2) source = source.coarser;
  const { left, top, ...size } = extent(source, from, to);
  const coarse = Math.max(1, Math.ceil(Math.sqrt((size.width * size.height) / most)));
  const [width, height] = [
    Math.max(1, Math.floor(size.width / coarse)),
    Math.max(1, Math.floor(size.height / coarse)),
  ];
  const levels = means(source, left, top, width, height, coarse);
  // Twice the binomial filter: edges stay where they are, and noise of single pixels goes.
  for (let pass = 0; pass < 2; pass++) blur(levels, width, height);
  return {
    width,
    height,
    origin: [left * source.step, top * source.step],
    pitch: coarse * source.step,
    steepness: steepness(levels, width, height),
  };
}

/** The part of a luminance between two corners in image pixels; at least one number. */
function extent({ width, height, step }: Luminance, from: Vec, to: Vec) {
  const low = (value: number, end: number) => Math.min(end - 1, Math.max(0, Math.floor(value / step)));
  const high = (value: number, start: number, end: number) =>
    Math.max(start + 1, Math.min(end, Math.ceil(value / step)));
  const [left, top] = [low(Math.min(from[0], to[0]), width), low(Math.min(from[1], to[1]), height)];
  const right = high(Math.max(from[0], to[0]), left, width);
  const bottom = high(Math.max(from[1], to[1]), top, height);
  return { left, top, width: right - left, height: bottom - top };
}

function means(
  { values, width: stride, height: rows }: Luminance,
  left: number,
  top: number,
  width: number,
  height: number,
  coarse: number,
): Float32Array {
  const levels = new Float32Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let dy = 0; dy < coarse; dy++) {
        const row = Math.min(rows - 1, top + y * coarse + dy) * stride;
        for (let dx = 0; dx < coarse; dx++)
          sum += values[row + Math.min(stride - 1, left + x * coarse + dx)] ?? 0;
      }
      levels[y * width + x] = sum / (coarse * coarse);
    }
  return levels;
}

/** Weighs each number with its neighbours by 1, 2, 1 along both axes. */
function blur(levels: Float32Array, width: number, height: number): void {
  const along = (start: number, by: number, count: number) => {
    let before = levels[start] ?? 0;
    for (let k = 0; k < count; k++) {
      const at = start + k * by;
      const here = levels[at] ?? 0;
      const after = k + 1 < count ? (levels[at + by] ?? 0) : here;
      levels[at] = (before + 2 * here + after) / 4;
      before = here;
    }
  };
  for (let y = 0; y < height; y++) along(y * width, 1, width);
  for (let x = 0; x < width; x++) along(x, width, height);
}

/** By the filter of Sobel, in levels per node. */
function steepness(levels: Float32Array, width: number, height: number): Float32Array {
  const result = new Float32Array(width * height);
  for (let y = 0; y < height; y++) {
    const [above, here, below] = [Math.max(0, y - 1), y, Math.min(height - 1, y + 1)].map(
      (row) => row * width,
    ) as [number, number, number];
    for (let x = 0; x < width; x++) {
      const [before, after] = [Math.max(0, x - 1), Math.min(width - 1, x + 1)];
      const at = (row: number, column: number) => levels[row + column] ?? 0;
      const across =
        at(above, after) -
        at(above, before) +
        2 * (at(here, after) - at(here, before)) +
        at(below, after) -
        at(below, before);
      const down =
        at(below, before) -
        at(above, before) +
        2 * (at(below, x) - at(above, x)) +
        at(below, after) -
        at(above, after);
      result[here + x] = Math.sqrt(across * across + down * down) / 8;
    }
  }
  return result;
}
