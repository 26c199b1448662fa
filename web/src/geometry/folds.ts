/**
 * Where a pose folds the picture: triangles that have turned over. What surrounds the rim does not count, as for the solver:
 * its slivers turn over where the outline merely bends.
 *
 * Cost: linear in the triangles, a fraction of a millisecond for 20,000.
 */
import type { Skin } from './blend';

export interface FoldingMesh extends Pick<Skin, 'positions' | 'triangles'> {
  /** The first so many vertices lie in the domain; the others surround it. */
  readonly samples: number;
}

/** Twice the signed area of the triangle whose corners stand at `at` in `triangles`. */
function area(points: Float32Array, triangles: Uint32Array, at: number): number {
  const [a, b, c] = [2 * (triangles[at] ?? 0), 2 * (triangles[at + 1] ?? 0), 2 * (triangles[at + 2] ?? 0)];
  const [x, y] = [points[a] ?? 0, points[a + 1] ?? 0];
  return (
    ((points[b] ?? 0) - x) * ((points[c + 1] ?? 0) - y) - ((points[b + 1] ?? 0) - y) * ((points[c] ?? 0) - x)
  );
}

/** How many triangles have turned over. */
export function foldCount(mesh: FoldingMesh, posed: Float32Array): number {
  let count = 0;
  for (let at = 0; at + 2 < mesh.triangles.length; at += 3) if (isFolded(mesh, posed, at)) count++;
  return count;
}

/** Triangles × 3: those that have turned over. */
export function foldedTriangles(mesh: FoldingMesh, posed: Float32Array): Uint32Array {
  const folded: number[] = [];
  for (let at = 0; at + 2 < mesh.triangles.length; at += 3) {
    if (isFolded(mesh, posed, at)) folded.push(...mesh.triangles.subarray(at, at + 3));
  }
  return Uint32Array.from(folded);
}

const isFolded = ({ positions, triangles, samples }: FoldingMesh, posed: Float32Array, at: number): boolean =>
  area(positions, triangles, at) * area(posed, triangles, at) < 0 &&
  (triangles[at] ?? 0) < samples &&
  (triangles[at + 1] ?? 0) < samples &&
  (triangles[at + 2] ?? 0) < samples;
