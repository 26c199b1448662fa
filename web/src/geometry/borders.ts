/** The borders between cells, as they are posed. */

/** Straight pieces of borders, each within one triangle of the mesh. */
export interface Borders {
  /** Pieces × 3: vertices of the triangle. */
  readonly corners: Uint32Array;
  /** Pieces × 2 ends × 3: shares of these vertices, which sum to 1. */
  readonly shares: Float32Array;
}

/** Pieces × 2 ends × 2: where the ends of each piece are. @param posed Vertices × 2. */
export function posedBorders({ corners, shares }: Borders, posed: Float32Array): Float32Array {
  const ends = new Float32Array((shares.length / 3) * 2);
  for (let at = 0; at < shares.length; at++) {
    const vertex = corners[3 * Math.floor(at / 6) + (at % 3)] ?? 0;
    const [share, end] = [shares[at] ?? 0, 2 * Math.floor(at / 3)];
    ends[end] = (ends[end] ?? 0) + share * (posed[2 * vertex] ?? 0);
    ends[end + 1] = (ends[end + 1] ?? 0) + share * (posed[2 * vertex + 1] ?? 0);
  }
  return ends;
}
