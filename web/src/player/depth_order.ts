/** The drawing order of triangles by the depths of handles: wasm/core/src/deform/drawing_order.rs without crossings. */
import type { Rig } from './rig';

const STEPS = 1024;
/** Depths that differ by less than this fraction of the greatest are equal. */
const SAME = 1e-6;

/** Indices of triangles, the farthest first; null for the order of the mesh. @param depths One per site. */
export function depthOrder({ rows, entries, triangles }: Rig, depths: Float64Array): Uint32Array | null {
  const vertices = Float64Array.from({ length: rows.length / 2 }, (_, vertex) => {
    const first = rows[2 * vertex] ?? 0;
    let depth = 0;
    for (let entry = first; entry < first + (rows[2 * vertex + 1] ?? 0); entry++)
      depth += (depths[entries[2 * entry] ?? 0] ?? 0) * (entries[2 * entry + 1] ?? 0);
    return depth;
  });
  // Vertices without weights have depth 0.
  const still = rows.some((count, at) => at % 2 === 1 && count === 0) ? [0] : [];
  const [low, high] = [Math.min(...depths, ...still), Math.max(...depths, ...still)];
  if (high - low <= SAME * Math.max(Math.abs(high), Math.abs(low))) return null;
  const step = (triangle: number) => {
    const corners = triangles.subarray(3 * triangle, 3 * triangle + 3);
    const sum = corners.reduce((sum, corner) => sum + (vertices[corner] ?? 0) - low, 0);
    return Math.round((sum / (3 * (high - low))) * STEPS);
  };
  const steps = Uint32Array.from({ length: triangles.length / 3 }, (_, triangle) => step(triangle));
  return steps.map((_, triangle) => triangle).sort((a, b) => (steps[a] ?? 0) - (steps[b] ?? 0) || a - b);
}
