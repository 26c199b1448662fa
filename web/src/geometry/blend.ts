/**
 * Blending on the page: the positions of a mesh's vertices under the sites' motions. The linear blend is equation 1,
 * p′ = Σ w T(p).
 *
 * The GPU does the same for every frame; this copy serves rarer queries, such as what lies under the pointer of a
 * click, and single vertices. Cost: linear in the number of stored weights.
 */
import { rigidlyBlended } from './dual';
import { MOTION_STRIDE, type Skin } from './skin';
import type { Vec } from './vec';

/** How the motions that reach a vertex are blended. */
export type Blend = 'linear' | 'rigid';

/** Vertices × 2: the posed positions; the rest positions where `motions` is null. */
export function posedPositions(
  skin: Skin,
  motions: Float32Array | null,
  blend: Blend = 'linear',
): Float32Array {
  const posed = Float32Array.from(skin.positions);
  if (!motions) return posed;
  for (let vertex = 0; vertex + 1 < skin.offsets.length; vertex++) {
    const [x, y] = posedVertex(skin, motions, blend, vertex);
    posed[2 * vertex] = x;
    posed[2 * vertex + 1] = y;
  }
  return posed;
}

/** The posed position of one vertex; its rest position where nothing moves it, or `motions` is null. */
export function posedVertex(skin: Skin, motions: Float32Array | null, blend: Blend, vertex: number): Vec {
  if (!motions || skin.offsets[vertex] === skin.offsets[vertex + 1]) {
    return [skin.positions[2 * vertex] ?? 0, skin.positions[2 * vertex + 1] ?? 0];
  }
  return blend === 'rigid' ? rigidlyBlended(skin, motions, vertex) : linearlyBlended(skin, motions, vertex);
}

/** Σ w T(p), where T(p) = posed + [a c; b d] (p − rest). */
function linearlyBlended(skin: Skin, motions: Float32Array, vertex: number): Vec {
  const px = skin.positions[2 * vertex] ?? 0;
  const py = skin.positions[2 * vertex + 1] ?? 0;
  let x = 0;
  let y = 0;
  for (let entry = skin.offsets[vertex] ?? 0; entry < (skin.offsets[vertex + 1] ?? 0); entry++) {
    const weight = skin.weights[entry] ?? 0;
    const at = MOTION_STRIDE * (skin.sites[entry] ?? 0);
    const dx = px - (motions[at + 4] ?? 0);
    const dy = py - (motions[at + 5] ?? 0);
    x += weight * ((motions[at + 6] ?? 0) + (motions[at] ?? 1) * dx + (motions[at + 2] ?? 0) * dy);
    y += weight * ((motions[at + 7] ?? 0) + (motions[at + 1] ?? 0) * dx + (motions[at + 3] ?? 1) * dy);
  }
  return [x, y];
}
