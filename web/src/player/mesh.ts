/** The mesh of a rig and its weights, in the layout for a graphics card. */
import type { Bytes } from './bytes';

export interface Mesh {
  /** Vertices × 2 at rest, image pixels. */
  readonly positions: Float32Array;
  /** Triangles × 3 in drawing order. */
  readonly triangles: Uint32Array;
  /** Sites × 2: their rest positions. */
  readonly rest: Float64Array;
  /** Positions are multiples of 2 to the power of minus this, in pixels. */
  readonly placeBits: number;
}

export interface Weights {
  /** Vertices × 2: the first entry, and the number of entries. */
  readonly rows: Uint32Array;
  /** Entries × 2: site and weight. */
  readonly entries: Float32Array;
}

export function readMesh(from: Bytes): Mesh {
  const bits = from.byte();
  from.check(bits <= 16, 'has positions with too many bits');
  const [vertices, triangles, sites] = [from.count(2), from.count(3), from.count(2)];
  const positions = Float32Array.from(readPlaces(from, vertices, bits));
  const rest = readPlaces(from, sites, bits);
  let seen = 0;
  const corners = Uint32Array.from({ length: 3 * triangles }, () => {
    const back = from.varint();
    from.check(back <= seen, 'has a corner before the first vertex');
    return back === 0 ? seen++ : seen - back;
  });
  from.check(seen === vertices, 'has triangles that do not match its vertices');
  return { positions, triangles: corners, rest, placeBits: bits };
}

/** Vertices × 2 of a mesh, with the displacement of each. */
export function readDisplaced(from: Bytes, { positions, placeBits }: Mesh): Float32Array {
  const by = readPlaces(from, positions.length / 2, placeBits);
  return positions.map((place, at) => place + (by[at] ?? 0));
}

/** Numbers × 2 in pixels: first along x, then along y, each as the difference from the previous one. */
function readPlaces(from: Bytes, count: number, bits: number): Float64Array {
  const values = new Float64Array(2 * count);
  for (const axis of [0, 1]) {
    let place = 0;
    for (let at = axis; at < values.length; at += 2) {
      place = (place + from.signed()) | 0;
      values[at] = place / 2 ** bits;
    }
  }
  return values;
}

export function readWeights(from: Bytes, vertices: number, sites: number): Weights {
  const bits = from.byte();
  from.check(bits <= 24 && from.has(vertices), 'have too many bits, or end too early');
  const rows = new Uint32Array(2 * vertices);
  let count = 0;
  for (let row = 0; row < rows.length; row += 2) {
    rows[row] = count;
    count += rows[row + 1] = from.varint();
    from.check(from.has(count), 'end too early');
  }
  const entries = new Float32Array(2 * count);
  let entry = 0;
  for (let row = 1; row < rows.length; row += 2) {
    let next = 0;
    for (let left = rows[row] ?? 0; left > 0; left--) {
      const site = next + from.varint();
      from.check(site < sites, 'refer to an unknown site');
      entries[entry] = site;
      entry += 2;
      next = site + 1;
    }
  }
  const whole = 2 ** bits;
  let before = new Map<number, number>();
  for (let row = 0; row < rows.length; row += 2) {
    const shares = new Map<number, number>();
    const first = 2 * (rows[row] ?? 0);
    const end = first + 2 * (rows[row + 1] ?? 0);
    let left = whole;
    for (let entry = first + 2; entry < end; entry += 2) {
      const site = entries[entry] ?? 0;
      const share = (before.get(site) ?? 0) + from.signed();
      left -= share;
      from.check(share >= 0 && left >= 0, 'do not sum to 1');
      shares.set(site, share);
      entries[entry + 1] = share / whole;
    }
    if (first < end) {
      shares.set(entries[first] ?? 0, left);
      entries[first + 1] = left / whole;
    }
    before = shares;
  }
  return { rows, entries };
}
