/**
 * Equation 1 on the page: where a mesh's vertices go under the sites' motions, p′ = Σ w T(p).
 *
 * The GPU does the same for every frame; this copy serves questions that are asked once per click (what lies under the
 * pointer?). Cost: linear in the number of stored weights.
 */
import type { Vec } from './vec';

/** A mesh with sparse weights, as the solver hands it out. */
export interface Skin {
  /** Vertices × 2, rest positions in image pixels. */
  readonly positions: Float32Array;
  /** Triangles × 3, drawn in order: the later covers the earlier. */
  readonly triangles: Uint32Array;
  /** Vertices + 1: rows of `sites` and `weights`. An empty row stays at rest. */
  readonly offsets: Uint32Array;
  readonly sites: Uint32Array;
  readonly weights: Float32Array;
}

/** Numbers per site in a motions array: a, b, c, d, rest x, rest y, posed x, posed y, depth, angle, and two unused. */
export const MOTION_STRIDE = 12;

/** Where a site is posed. */
export const sitePlace = (motions: Float32Array, site: number): Vec => [
  motions[MOTION_STRIDE * site + 6] ?? 0,
  motions[MOTION_STRIDE * site + 7] ?? 0,
];

/** How far a site is turned, degrees. */
export const siteTurn = (motions: Float32Array, site: number): number =>
  ((motions[MOTION_STRIDE * site + 9] ?? 0) * 180) / Math.PI;

/** Vertices × 2: the posed positions. T(p) = posed + [a c; b d] (p − rest). Without motions, the rest positions. */
export function posedPositions(skin: Skin, motions: Float32Array | null): Float32Array {
  const posed = Float32Array.from(skin.positions);
  if (!motions) return posed;
  const vertices = skin.offsets.length - 1;
  for (let vertex = 0; vertex < vertices; vertex++) {
    const from = skin.offsets[vertex] ?? 0;
    const to = skin.offsets[vertex + 1] ?? 0;
    if (from === to) continue;
    const px = skin.positions[2 * vertex] ?? 0;
    const py = skin.positions[2 * vertex + 1] ?? 0;
    let x = 0;
    let y = 0;
    for (let entry = from; entry < to; entry++) {
      const weight = skin.weights[entry] ?? 0;
      const at = MOTION_STRIDE * (skin.sites[entry] ?? 0);
      const dx = px - (motions[at + 4] ?? 0);
      const dy = py - (motions[at + 5] ?? 0);
      x += weight * ((motions[at + 6] ?? 0) + (motions[at] ?? 1) * dx + (motions[at + 2] ?? 0) * dy);
      y += weight * ((motions[at + 7] ?? 0) + (motions[at + 1] ?? 0) * dx + (motions[at + 3] ?? 1) * dy);
    }
    posed[2 * vertex] = x;
    posed[2 * vertex + 1] = y;
  }
  return posed;
}
