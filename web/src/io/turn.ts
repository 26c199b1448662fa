/** Turns pictures upright. */
import type { Orientation } from './formats/exif';

export interface Turned {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array<ArrayBuffer>;
}

/** Orientations with exchanged rows and columns, and those mirrored across and down afterwards. */
const TRANSPOSED: readonly Orientation[] = [5, 6, 7, 8];
const MIRRORED: readonly Orientation[] = [2, 3, 7, 8];
const FLIPPED: readonly Orientation[] = [3, 4, 6, 7];

/** Returns a picture of an orientation as upright. */
export function turned({ width, height, rgba }: Turned, orientation: Orientation): Turned {
  const [from, to] = [new Uint32Array(rgba.buffer), new Uint32Array(width * height)];
  const transposed = TRANSPOSED.includes(orientation);
  const [mirrored, flipped] = [MIRRORED.includes(orientation), FLIPPED.includes(orientation)];
  const [columns, rows] = transposed ? [height, width] : [width, height];
  for (let y = 0, at = 0; y < rows; y++) {
    for (let x = 0; x < columns; x++) {
      const [u, v] = transposed ? [y, x] : [x, y];
      const row = flipped ? height - 1 - v : v;
      to[at++] = from[row * width + (mirrored ? width - 1 - u : u)] ?? 0;
    }
  }
  return { width: columns, height: rows, rgba: new Uint8Array(to.buffer) };
}
