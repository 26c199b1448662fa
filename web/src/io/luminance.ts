/** How light a picture is, in few numbers. */

export interface Luminance {
  readonly width: number;
  readonly height: number;
  /** Rows from the top, 0 to 255. */
  readonly values: Uint8Array<ArrayBuffer>;
  /** Pixels of the picture per number, along either axis. */
  readonly step: number;
  /** The same in numbers for 2 × 2 of these each; null if these are few. */
  readonly coarser: Luminance | null;
}

/** The most numbers: 4 MB, enough for edges within two pixels of twelve million. */
const MOST = 4e6;

/** So few numbers need no coarser ones. */
const FEW = 40_000;

/** Of one pixel, by the weights of ITU-R BT.709 for encoded levels. Transparent pixels are black. */
const luma = (rgba: Uint8Array, at: number): number =>
  (((rgba[at] ?? 0) * 54 + (rgba[at + 1] ?? 0) * 183 + (rgba[at + 2] ?? 0) * 19) * (rgba[at + 3] ?? 0)) /
  (256 * 255);

/** @param rgba straight alpha, rows from the top. Each number is the mean of `step` × `step` pixels. */
export function luminanceOf(rgba: Uint8Array, width: number, height: number, most = MOST): Luminance {
  const step = Math.max(1, Math.ceil(Math.sqrt((width * height) / most)));
  const [columns, rows] = [width, height].map((side) => Math.max(1, Math.floor(side / step))) as [
    number,
    number,
  ];
  const values = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      let [sum, count] = [0, 0];
      for (let y = row * step; y < Math.min(height, (row + 1) * step); y++)
        for (let x = column * step; x < Math.min(width, (column + 1) * step); x++, count++)
          sum += luma(rgba, 4 * (y * width + x));
      values[row * columns + column] = Math.round(sum / Math.max(1, count));
    }
  return { width: columns, height: rows, values, step, coarser: coarserOf(values, columns, rows, step) };
}

function coarserOf(finer: Uint8Array, columns: number, rows: number, step: number): Luminance | null {
  if (columns * rows <= FEW) return null;
  const [width, height] = [columns >> 1, rows >> 1];
  const values = new Uint8Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const at = 2 * y * columns + 2 * x;
      const [a = 0, b = 0, c = 0, d = 0] = [
        finer[at],
        finer[at + 1],
        finer[at + columns],
        finer[at + columns + 1],
      ];
      values[y * width + x] = (a + b + c + d + 2) >> 2;
    }
  const half = 2 * step;
  return { width, height, values, step: half, coarser: coarserOf(values, width, height, half) };
}

/** The buffers of all numbers, to be transferred. */
export const buffersOf = ({ values, coarser }: Luminance): readonly ArrayBuffer[] => [
  values.buffer,
  ...(coarser ? buffersOf(coarser) : []),
];
