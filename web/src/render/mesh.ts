import type { Skin } from '../geometry/skin';

/** A skin, the sites that move it, and the static background behind it. */
export interface WarpMesh extends Skin {
  /** Sites × 2; only the length matters here. */
  readonly siteRest: ArrayLike<number>;
  /** Vertices × 2 and triangles × 3 of the static background, drawn behind the skin. */
  readonly backgroundPositions?: Float32Array;
  readonly backgroundTriangles?: Uint32Array;
  /** Vertices × 2 of the feather, the vertex of the skin that moves each, their levels, and triangles × 3. */
  readonly featherPositions?: Float32Array;
  readonly featherOwners?: Uint32Array;
  readonly featherLevels?: Float32Array;
  readonly featherTriangles?: Uint32Array;
}

/** Returns a mesh without weights: it always stays at rest. */
export const staticMesh = (positions: Float32Array, triangles: Uint32Array): WarpMesh => ({
  positions,
  triangles,
  offsets: new Uint32Array(positions.length / 2 + 1),
  sites: new Uint32Array(),
  weights: new Float32Array(),
  siteRest: [],
});

/** Returns the whole picture as two triangles, for pictures without a solution. */
export const unwarpedMesh = (width: number, height: number): WarpMesh =>
  staticMesh(
    new Float32Array([0, 0, width, 0, 0, height, width, height]),
    new Uint32Array([0, 1, 2, 2, 1, 3]),
  );

/** Returns vertices × 2: the first weight entry and the number of entries, from the offsets of a mesh. */
export function weightRows(offsets: Uint32Array): Uint32Array {
  const rows = new Uint32Array(Math.max(0, offsets.length - 1) * 2);
  for (let vertex = 0; vertex * 2 < rows.length; vertex++) {
    const first = offsets[vertex] ?? 0;
    rows[vertex * 2] = first;
    rows[vertex * 2 + 1] = (offsets[vertex + 1] ?? first) - first;
  }
  return rows;
}

/** Returns the rows of the vertices that move others. Owners × 2. */
export function ownedRows(rows: Uint32Array, owners: Uint32Array): Uint32Array {
  const owned = new Uint32Array(owners.length * 2);
  owners.forEach((owner, vertex) => {
    owned.set(rows.subarray(2 * owner, 2 * owner + 2), 2 * vertex);
  });
  return owned;
}

/** The mean length of edges, rest positions. Edges × 2, positions × 2. */
export function meanEdge(edges: Uint32Array, positions: Float32Array): number {
  let sum = 0;
  for (let at = 0; at < edges.length; at += 2) {
    const [a, b] = [2 * (edges[at] ?? 0), 2 * (edges[at + 1] ?? 0)];
    sum += Math.hypot(
      (positions[a] ?? 0) - (positions[b] ?? 0),
      (positions[a + 1] ?? 0) - (positions[b + 1] ?? 0),
    );
  }
  return (2 * sum) / Math.max(1, edges.length);
}

/** From this length on, lines are drawn whole. CSS pixels. */
const WHOLE_EDGE = 10;

/**
 * The opacity of the lines of a mesh, from 0 to 1. Shorter edges are fainter in proportion, so that the lines cover the
 * picture equally at every zoom.
 *
 * @param edge the mean length of the edges on the screen, CSS pixels.
 */
export const lineOpacity = (edge: number): number => Math.min(1, edge / WHOLE_EDGE);

/** Returns edges × 2: every edge of the triangles once. Cost: O(n log n) in the triangles. */
export function meshEdges(triangles: Uint32Array): Uint32Array {
  const keys = new Float64Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const a = triangles[corner] ?? 0;
    const b = triangles[next] ?? 0;
    // Two vertex indices in one number. This is exact for fewer than 2^26 vertices.
    keys[corner] = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
  }
  keys.sort();
  const edges: number[] = [];
  for (let index = 0; index < keys.length; index++) {
    const key = keys[index] ?? 0;
    if (index > 0 && key === keys[index - 1]) continue;
    edges.push(Math.floor(key / 2 ** 26), key % 2 ** 26);
  }
  return new Uint32Array(edges);
}
