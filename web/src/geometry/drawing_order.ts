/**
 * The drawing order of triangles where a posed picture covers itself: from the farthest to the nearest; triangles of
 * equal depth keep the order of the mesh. `wasm/core/src/drawing_order.rs` defines the rule.
 *
 * Cost: one comparison per site; after a change of depth, linear in stored weights and triangles.
 */
import { MOTION_STRIDE, type Skin } from './skin';

/** Depth steps from the farthest site to the nearest. */
const DEPTH_STEPS = 1024;
/** Depths that differ by less than this share of the greatest count as equal. */
const SAME_DEPTH = 1e-6;

/** The drawing order of one skin, cached until a depth changes. */
export class DrawingOrder {
  readonly #skin: Skin;
  #depths = new Float32Array();
  #triangles: Uint32Array;

  constructor(skin: Skin) {
    this.#skin = skin;
    this.#triangles = skin.triangles;
  }

  /** Triangles × 3, in drawing order. Returns the same array until a depth changes. */
  triangles(motions: Float32Array): Uint32Array {
    const depths = new Float32Array(motions.length / MOTION_STRIDE);
    for (let site = 0; site < depths.length; site++) depths[site] = motions[MOTION_STRIDE * site + 8] ?? 0;
    if (depths.length !== this.#depths.length || depths.some((depth, site) => depth !== this.#depths[site])) {
      this.#depths = depths;
      this.#triangles = sorted(this.#skin, depths);
    }
    return this.#triangles;
  }
}

function sorted(skin: Skin, depths: Float32Array): Uint32Array {
  const { triangles, offsets, sites, weights } = skin;
  let [low, high] = [Infinity, -Infinity];
  const include = (depth: number) => {
    low = Math.min(low, depth);
    high = Math.max(high, depth);
  };
  depths.forEach(include);
  for (let vertex = 0; vertex + 1 < offsets.length; vertex++) {
    if (offsets[vertex] === offsets[vertex + 1]) include(0);
  }
  const range = high - low;
  if (!(range > SAME_DEPTH * Math.max(Math.abs(low), Math.abs(high)))) return triangles;

  const deep = new Float64Array(offsets.length - 1).map((_, vertex) => {
    const [from, to] = [offsets[vertex] ?? 0, offsets[vertex + 1] ?? 0];
    let sum = from === to ? -low : 0;
    for (let entry = from; entry < to; entry++) {
      sum += (weights[entry] ?? 0) * ((depths[sites[entry] ?? 0] ?? 0) - low);
    }
    return sum;
  });
  const depth = (corner: number) => deep[triangles[corner] ?? 0] ?? 0;
  const steps = new Int32Array(triangles.length / 3).map((_, triangle) => {
    const sum = depth(3 * triangle) + depth(3 * triangle + 1) + depth(3 * triangle + 2);
    return Math.round((sum / (3 * range)) * DEPTH_STEPS);
  });
  return countingSort(triangles, steps);
}

/** Triangles sorted by step; the sort is stable. */
function countingSort(triangles: Uint32Array, steps: Int32Array): Uint32Array {
  const start = new Uint32Array(DEPTH_STEPS + 2);
  for (const step of steps) start[step + 1] = (start[step + 1] ?? 0) + 1;
  for (let step = 0; step <= DEPTH_STEPS; step++)
    start[step + 1] = (start[step + 1] ?? 0) + (start[step] ?? 0);
  const result = new Uint32Array(triangles.length);
  steps.forEach((step, triangle) => {
    const at = start[step] ?? 0;
    result.set(triangles.subarray(3 * triangle, 3 * triangle + 3), 3 * at);
    start[step] = at + 1;
  });
  return result;
}
