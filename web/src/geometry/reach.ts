/**
 * How far a move of some handles reaches: how much of it each place of the posed picture follows.
 *
 * That is the size of the derivative of the posed place by the move: the root of half the sum of its four squared entries. 1 goes
 * along whole, straight or turned; 0 stays; what a move swings around goes farther than 1. Whole poses are compared, so that it is
 * the same question in either pose mode and for either blend. Cost: that of blending four times.
 */
import { type Blend, posedPositions } from './blend';
import type { Skin } from './skin';

/**
 * How far to move to either side, as a share of the picture's diagonal. The rigid mode stops relaxing where that gains little, a turn
 * earlier or later, and what is drawn jumps by a fraction of a pixel. Along a drag of the sample, compared over a pixel, such jumps change
 * the reach by 0.12, and over ten by 0.014. In the harmonic mode, where nothing jumps, any step gives the same.
 */
export const REACH_STEP = 0.005;

/** Motions of all sites, see `MOTION_STRIDE`, with the handles moved by a step along x, against x, along y, against y. */
export type MovedMotions = readonly [
  right: Float32Array,
  left: Float32Array,
  down: Float32Array,
  up: Float32Array,
];

/** Vertices: the reach there. @param step Image pixels. */
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

/** A colour in sRGB, 0 to 255, and how opaque it is. */
export type RampColour = readonly [red: number, green: number, blue: number, alpha: number];

/**
 * What shows a reach of 0, 0.2, … 1 over the picture: from nothing through blue to yellow. Lightness rises by equal steps, from 0.42 to 0.93 in
 * OKLab, so that it reads without the hues; blue to yellow is what nearly all people tell apart.
 */
export const REACH_RAMP: readonly RampColour[] = [
  [85, 40, 169, 0],
  [59, 98, 196, 0.55],
  [18, 149, 187, 0.65],
  [54, 191, 166, 0.7],
  [142, 223, 124, 0.74],
  [244, 240, 78, 0.78],
];
