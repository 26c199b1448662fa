/**
 * The rigid blend on the page: positions of vertices by dual complex numbers. `wasm/core/src/pose/dual.rs` documents
 * the maths, its guarantees and its limits; `render/warp.vert.glsl` is the third implementation.
 *
 * Complex numbers are pairs of local variables, real part x and imaginary part y: arrays would be allocated by the
 * million. Cost: 10,000 vertices take about three milliseconds.
 */
import { MOTION_STRIDE, type Skin } from './skin';
import type { Vec } from './vec';

/** |P|² from which the blend is rigid. */
const RIGID = 0.25;

/** The blended position of a vertex that at least one site moves. */
export function rigidlyBlended(skin: Skin, motions: Float32Array, vertex: number): Vec {
  const px = skin.positions[2 * vertex] ?? 0;
  const py = skin.positions[2 * vertex + 1] ?? 0;
  const end = skin.offsets[vertex + 1] ?? 0;
  // The sums of the blend, all relative to p.
  let [posedX, posedY, halfX, halfY, movedX, movedY] = [0, 0, 0, 0, 0, 0];
  for (let entry = skin.offsets[vertex] ?? 0; entry < end; entry++) {
    const weight = skin.weights[entry] ?? 0;
    const at = MOTION_STRIDE * (skin.sites[entry] ?? 0);
    const armX = px - (motions[at + 4] ?? 0);
    const armY = py - (motions[at + 5] ?? 0);
    const hx = motions[at + 10] ?? 1;
    const hy = motions[at + 11] ?? 0;
    const goneX = (motions[at + 6] ?? 0) - px + (motions[at] ?? 1) * armX + (motions[at + 2] ?? 0) * armY;
    const goneY = (motions[at + 7] ?? 0) - py + (motions[at + 1] ?? 0) * armX + (motions[at + 3] ?? 1) * armY;
    posedX += weight * goneX;
    posedY += weight * goneY;
    halfX += weight * hx;
    halfY += weight * hy;
    movedX += weight * (hx * goneX + hy * goneY);
    movedY += weight * (hx * goneY - hy * goneX);
  }
  // The rigid blend minus the linear one, times P̄.
  const apartX = movedX - halfX * posedX - halfY * posedY;
  const apartY = movedY - halfX * posedY + halfY * posedX;
  const u = (halfX * halfX + halfY * halfY) / RIGID;
  const reciprocal = (u >= 1 ? 1 / u : 3 - 3 * u + u * u) / RIGID;
  return [
    px + posedX + reciprocal * (apartX * halfX - apartY * halfY),
    py + posedY + reciprocal * (apartX * halfY + apartY * halfX),
  ];
}
