/**
 * The rigid blend on the page: where dual complex numbers take a vertex. The maths, its guarantees and its limits are
 * told in `wasm/core/src/pose/dual.rs`, and `render/warp.vert.glsl` is the third to do the same.
 *
 * Complex numbers are vectors here, turns by an angle θ among them: exp(iθ).
 */
import { MOTION_STRIDE, type Skin } from './skin';
import { add, scaled, subtract, type Vec } from './vec';

/** |P|² from which the blend is rigid. */
const RIGID = 0.25;

/** Where the sites of a vertex that has some take it. */
export function rigidlyBlended(skin: Skin, motions: Float32Array, vertex: number): Vec {
  const p = vec(skin.positions, 2 * vertex);
  // The sums of the blend, all relative to p.
  let posed: Vec = [0, 0];
  let stretched: Vec = [0, 0];
  let turn: Vec = [0, 0];
  let half: Vec = [0, 0];
  let moved: Vec = [0, 0];
  for (let entry = skin.offsets[vertex] ?? 0; entry < (skin.offsets[vertex + 1] ?? 0); entry++) {
    const weight = skin.weights[entry] ?? 0;
    const at = MOTION_STRIDE * (skin.sites[entry] ?? 0);
    const arm = subtract(p, vec(motions, at + 4));
    const ownHalf = vec(motions, at + 10);
    const ownTurn = product(ownHalf, ownHalf);
    const [x, y] = [vec(motions, at), vec(motions, at + 2)];
    const linear: Vec = [x[0] * arm[0] + y[0] * arm[1], x[1] * arm[0] + y[1] * arm[1]];
    const ownPosed = add(subtract(vec(motions, at + 6), p), product(ownTurn, arm));
    posed = add(posed, scaled(ownPosed, weight));
    stretched = add(stretched, scaled(subtract(product(conjugate(ownTurn), linear), arm), weight));
    turn = add(turn, scaled(ownTurn, weight));
    half = add(half, scaled(ownHalf, weight));
    moved = add(moved, scaled(product(conjugate(ownHalf), ownPosed), weight));
  }
  const linear = add(posed, product(turn, stretched));
  const apart = subtract(add(moved, product(half, stretched)), product(conjugate(half), linear));
  const u = (half[0] ** 2 + half[1] ** 2) / RIGID;
  const back = scaled(half, (u >= 1 ? 1 / u : 3 - 3 * u + u * u) / RIGID);
  return add(p, add(linear, product(apart, back)));
}

const vec = (array: Float32Array, at: number): Vec => [array[at] ?? 0, array[at + 1] ?? 0];
const product = (a: Vec, b: Vec): Vec => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
const conjugate = (a: Vec): Vec => [a[0], -a[1]];
