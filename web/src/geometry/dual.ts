/**
 * The rigid blend on the page: where dual complex numbers take a vertex. The maths, its guarantees and its limits are
 * told in `wasm/core/src/pose/dual.rs`, and `render/warp.vert.glsl` is the third to do the same.
 *
 * Complex numbers stand as pairs of numbers here, real and imaginary part named x and y: vectors would be thrown away by
 * the million. Cost: 10,000 vertices take some three milliseconds.
 */
import { MOTION_STRIDE, type Skin } from './skin';
import type { Vec } from './vec';

/** |P|² from which the blend is rigid. */
const RIGID = 0.25;

/** Where the sites of a vertex that has some take it. */
export function rigidlyBlended(skin: Skin, motions: Float32Array, vertex: number): Vec {
  const px = skin.positions[2 * vertex] ?? 0;
  const py = skin.positions[2 * vertex + 1] ?? 0;
  const end = skin.offsets[vertex + 1] ?? 0;
  // The sums of the blend, all relative to p.
  let [posedX, posedY, stretchedX, stretchedY, turnX, turnY] = [0, 0, 0, 0, 0, 0];
  let [halfX, halfY, movedX, movedY] = [0, 0, 0, 0];
  for (let entry = skin.offsets[vertex] ?? 0; entry < end; entry++) {
    const weight = skin.weights[entry] ?? 0;
    const at = MOTION_STRIDE * (skin.sites[entry] ?? 0);
    const armX = px - (motions[at + 4] ?? 0);
    const armY = py - (motions[at + 5] ?? 0);
    const hx = motions[at + 10] ?? 1;
    const hy = motions[at + 11] ?? 0;
    const tx = hx * hx - hy * hy;
    const ty = 2 * hx * hy;
    const linearX = (motions[at] ?? 1) * armX + (motions[at + 2] ?? 0) * armY;
    const linearY = (motions[at + 1] ?? 0) * armX + (motions[at + 3] ?? 1) * armY;
    const goneX = (motions[at + 6] ?? 0) - px + tx * armX - ty * armY;
    const goneY = (motions[at + 7] ?? 0) - py + tx * armY + ty * armX;
    posedX += weight * goneX;
    posedY += weight * goneY;
    stretchedX += weight * (tx * linearX + ty * linearY - armX);
    stretchedY += weight * (tx * linearY - ty * linearX - armY);
    turnX += weight * tx;
    turnY += weight * ty;
    halfX += weight * hx;
    halfY += weight * hy;
    movedX += weight * (hx * goneX + hy * goneY);
    movedY += weight * (hx * goneY - hy * goneX);
  }
  const x = posedX + turnX * stretchedX - turnY * stretchedY;
  const y = posedY + turnX * stretchedY + turnY * stretchedX;
  const apartX = movedX + halfX * (stretchedX - x) - halfY * (stretchedY + y);
  const apartY = movedY + halfX * (stretchedY - y) + halfY * (stretchedX + x);
  const u = (halfX * halfX + halfY * halfY) / RIGID;
  const reciprocal = (u >= 1 ? 1 / u : 3 - 3 * u + u * u) / RIGID;
  return [
    px + x + reciprocal * (apartX * halfX - apartY * halfY),
    py + y + reciprocal * (apartX * halfY + apartY * halfX),
  ];
}
