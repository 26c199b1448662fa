/** The alpha at which the pieces of thin strands are connected. */
import type { Rgba } from './pixels';

/** Alphas to try. Pieces that are connected below the last one merely touch with the rims of their edges. */
const LOWER = [112, 96, 80, 64, 48, 36, 26];
const LEAST = Math.min(...LOWER);
/** A larger picture is reduced first. Each pixel of the smaller one has the greatest alpha of its cell. */
const MOST_PIXELS = 2e6;

/**
 * Returns the greatest alpha, from `edge` down, at which no two pieces of at least `edge` are separate that are
 * connected at a lower one.
 *
 * Cost: linear in the pixels. Each alpha that is tried also visits the pixels at edges.
 */
export function connectingAlpha(picture: Rgba, edge: number): number {
  const { alpha, width } = reduced(picture);
  const pieces = new Pieces(alpha, edge);
  const blocks: number[] = [];
  for (let at = 0; at + width < alpha.length; at++) {
    if ((at + 1) % width === 0) continue;
    const corners = cornersOf(alpha, width, at);
    const most = Math.max(...corners);
    if (Math.min(...corners) >= edge) pieces.joinBlock(at, width);
    else if (most >= LEAST) blocks.push(at);
  }
  let found = edge;
  let above = 256;
  for (const level of [edge, ...LOWER]) {
    for (const at of blocks) {
      const linked = linksOf(alpha, width, at, level, above).filter(([one, other]) =>
        pieces.join(one, other),
      );
      if (linked.length > 0 && level < edge) found = level;
    }
    above = level;
  }
  return found;
}

/** Sets of connected pixels. */
class Pieces {
  readonly #parent: Uint32Array;
  /** By root: whether a pixel of the piece has at least the alpha `edge`. Other pieces only connect such ones. */
  readonly #counts: Uint8Array;

  constructor(alpha: Uint8Array, edge: number) {
    this.#parent = new Uint32Array(alpha.length);
    this.#counts = new Uint8Array(alpha.length);
    for (let at = 0; at < alpha.length; at++) {
      this.#parent[at] = at;
      this.#counts[at] = Number((alpha[at] ?? 0) >= edge);
    }
  }

  /** Joins two pieces. Returns whether they were separate and both count. */
  join(one: number, other: number): boolean {
    const [a, b] = [this.#root(one), this.#root(other)];
    if (a === b) return false;
    const [first, second] = [this.#counts[a] ?? 0, this.#counts[b] ?? 0];
    const low = Math.min(a, b);
    this.#parent[Math.max(a, b)] = low;
    this.#counts[low] = first | second;
    return (first & second) === 1;
  }

  joinBlock(at: number, width: number): void {
    this.join(at, at + 1);
    this.join(at, at + width);
    this.join(at, at + width + 1);
  }

  #root(from: number): number {
    const parent = this.#parent;
    let at = from;
    for (let above = parent[at] ?? 0; above !== at; above = parent[at] ?? 0) {
      parent[at] = parent[above] ?? 0;
      at = parent[at] ?? 0;
    }
    return at;
  }
}

type Corners = readonly [number, number, number, number];

/** The alpha of a block of four pixels. */
const cornersOf = (alpha: Uint8Array, width: number, at: number): Corners => [
  alpha[at] ?? 0,
  alpha[at + 1] ?? 0,
  alpha[at + width] ?? 0,
  alpha[at + width + 1] ?? 0,
];

/**
 * The pairs of neighbours in a block that an outline connects at `level` but not at `above`. It connects diagonal
 * neighbours if the mean of the block reaches the level.
 */
function linksOf(
  alpha: Uint8Array,
  width: number,
  at: number,
  level: number,
  above: number,
): readonly (readonly [number, number])[] {
  const [a, b, c, d] = cornersOf(alpha, width, at);
  const mean = Math.floor((a + b + c + d) / 4);
  const [right, below, across] = [at + 1, at + width, at + width + 1];
  const links = [
    [Math.min(a, b), at, right],
    [Math.min(a, c), at, below],
    [Math.min(b, d), right, across],
    [Math.min(c, d), below, across],
    [Math.min(a, d, mean), at, across],
    [Math.min(b, c, mean), right, below],
  ] as const;
  return links
    .filter(([reached]) => reached >= level && reached < above)
    .map(([, one, other]) => [one, other]);
}

function reduced({ width, height, rgba }: Rgba): { readonly alpha: Uint8Array; readonly width: number } {
  const cell = Math.ceil(Math.sqrt(Math.max(1, (width * height) / MOST_PIXELS)));
  const columns = Math.ceil(width / cell);
  const alpha = new Uint8Array(columns * Math.ceil(height / cell));
  for (let y = 0; y < height; y++) {
    const row = Math.floor(y / cell) * columns;
    for (let x = 0; x < width; x++) {
      const at = row + Math.floor(x / cell);
      alpha[at] = Math.max(alpha[at] ?? 0, rgba[(y * width + x) * 4 + 3] ?? 0);
    }
  }
  return { alpha, width: columns };
}
