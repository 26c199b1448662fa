/**
 * The reach of a move of some handles: how much of the move each place of the posed picture follows.
 *
 * Reach is the size of the derivative of the posed place by the move: the root of half the sum of its four squared
 * entries. A place of reach 1 moves as far as the handles, straight or turned; at 0 it stays; above 1 it swings farther
 * than they do. Whole poses are compared, which works alike in both pose modes and for both blends. Cost: four blends.
 */
import { type Blend, posedPositions } from './blend';
import type { Skin } from './skin';

/**
 * Step of the central difference, as a share of the picture's diagonal. The rigid mode stops relaxing once an iteration
 * gains little; one iteration more or less makes the pose jump by a fraction of a pixel. Along a drag of the sample,
 * such jumps change the reach by 0.12 over a pixel, and by 0.014 over ten. The harmonic mode has no jumps: there any
 * step gives the same result.
 */
export const REACH_STEP = 0.005;

/** Motions of all sites, see `MOTION_STRIDE`, with the handles moved one step along +x, −x, +y and −y. */
export type MovedMotions = readonly [
  right: Float32Array,
  left: Float32Array,
  down: Float32Array,
  up: Float32Array,
];

/** Vertices: the reach at each. @param step Image pixels. */
export function reachOf(skin: Skin, moved: MovedMotions, step: number, blend: Blend): Float32Array {
  const reach = new Float32Array(skin.positions.length / 2);
  const [right, left, down, up] = moved;
  for (const [there, back] of [
    [right, left],
    [down, up],
  ] as const) {
    const [ahead, behind] = [posedPositions(skin, there, blend), posedPositions(skin, back, blend)];
    for (let at = 0; at < ahead.length; at++) {
      reach[at >> 1] = (reach[at >> 1] ?? 0) + ((ahead[at] ?? 0) - (behind[at] ?? 0)) ** 2;
    }
  }
  return reach.map((sum) => Math.sqrt(sum / 2) / (2 * step));
}
