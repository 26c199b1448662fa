/**
 * The filters of PNG: each byte of a row becomes its difference from a prediction, which compresses better.
 *
 * The filter of a row is the one with the least sum of absolute differences, as in libpng. A part of the row's pixels
 * decides, which takes a fraction of the time and gives nearly the same files.
 */

/** Predictions from the bytes to the left, above, and above to the left. The index is the type in the file. */
type Filter = 0 | 1 | 2 | 3 | 4;

const FILTERS: readonly Filter[] = [0, 1, 2, 3, 4];

/** Bytes of a pixel. */
const PIXEL = 4;

/** One of so many pixels decides on the filter. */
const STRIDE = 11;

export class RowFilter {
  readonly #length: number;
  /** The row above. */
  #above: Uint8Array;

  constructor(width: number) {
    this.#length = width * PIXEL;
    this.#above = new Uint8Array(this.#length);
  }

  /** @throws Error if the bytes are not whole rows. */
  rowsOf(rgba: Uint8Array): number {
    const rows = rgba.length / this.#length;
    if (!Number.isInteger(rows)) throw new Error(`${rgba.length} bytes are not rows of ${this.#length}`);
    return rows;
  }

  /** Returns rows that follow the last ones, each after the type of its filter. */
  filtered(rgba: Uint8Array): Uint8Array<ArrayBuffer> {
    const rows = this.rowsOf(rgba);
    const out = new Uint8Array(rgba.length + rows);
    for (let index = 0; index < rows; index++) {
      const row = rgba.subarray(index * this.#length, (index + 1) * this.#length);
      const filter = chosen(row, this.#above);
      const start = index * (this.#length + 1);
      out[start] = filter;
      write(filter, row, this.#above, out.subarray(start + 1, start + 1 + this.#length));
      this.#above = row;
    }
    return out;
  }
}

/** Returns the filter with the least differences. */
function chosen(row: Uint8Array, above: Uint8Array): Filter {
  let [best, least]: [Filter, number] = [0, Number.POSITIVE_INFINITY];
  for (const filter of FILTERS) {
    let sum = 0;
    for (let pixel = 0; pixel < row.length; pixel += PIXEL * STRIDE)
      for (let at = pixel; at < pixel + PIXEL; at++)
        sum += Math.abs((((row[at] as number) - predicted(filter, row, above, at)) << 24) >> 24);
    if (sum < least) [best, least] = [filter, sum];
  }
  return best;
}

function predicted(filter: Filter, row: Uint8Array, above: Uint8Array, at: number): number {
  const left = at < PIXEL ? 0 : (row[at - PIXEL] as number);
  const up = above[at] as number;
  switch (filter) {
    case 0:
      return 0;
    case 1:
      return left;
    case 2:
      return up;
    case 3:
      return (left + up) >> 1;
    case 4:
      return paeth(left, up, at < PIXEL ? 0 : (above[at - PIXEL] as number));
  }
}

/** Whichever is nearest to left + up − corner. */
function paeth(left: number, up: number, corner: number): number {
  const toLeft = Math.abs(up - corner);
  const toUp = Math.abs(left - corner);
  const toCorner = Math.abs(left + up - 2 * corner);
  if (toLeft <= toUp && toLeft <= toCorner) return left;
  return toUp <= toCorner ? up : corner;
}

/** One loop per filter: the choice inside of a loop takes several times as long. */
function write(filter: Filter, row: Uint8Array, above: Uint8Array, out: Uint8Array): void {
  if (filter === 0) {
    out.set(row);
    return;
  }
  for (let at = 0; at < PIXEL; at++) out[at] = (row[at] as number) - predicted(filter, row, above, at);
  const { length } = row;
  switch (filter) {
    case 1:
      for (let at = PIXEL; at < length; at++) out[at] = (row[at] as number) - (row[at - PIXEL] as number);
      break;
    case 2:
      for (let at = PIXEL; at < length; at++) out[at] = (row[at] as number) - (above[at] as number);
      break;
    case 3:
      for (let at = PIXEL; at < length; at++)
        out[at] = (row[at] as number) - (((row[at - PIXEL] as number) + (above[at] as number)) >> 1);
      break;
    case 4:
      for (let at = PIXEL; at < length; at++) {
        const left = row[at - PIXEL] as number;
        const up = above[at] as number;
        out[at] = (row[at] as number) - paeth(left, up, above[at - PIXEL] as number);
      }
  }
}
