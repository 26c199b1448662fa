import { describe, expect, it } from 'vitest';
import { posedPositions } from './blend';
import { MOTION_STRIDE, type Skin } from './skin';
import { distance, type Vec } from './vec';

/** A vertex that two sites share. */
const between = (p: Vec, weights: readonly [number, number]): Skin => ({
  positions: Float32Array.from(p),
  triangles: new Uint32Array(),
  offsets: Uint32Array.of(0, 2),
  sites: Uint32Array.of(0, 1),
  weights: Float32Array.from(weights),
});

/** A turn by an angle about a pivot, after a stretch along x, as the motion of a site at `rest`. */
function motion(angle: number, pivot: Vec, rest: Vec, stretch = 1): number[] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [x, y] = [rest[0] - pivot[0], rest[1] - pivot[1]];
  const posed = [pivot[0] + cos * x - sin * y, pivot[1] + sin * x + cos * y];
  const linear = [cos * stretch, sin * stretch, -sin, cos];
  return [...linear, ...rest, ...posed, 0, angle, Math.cos(angle / 2), Math.sin(angle / 2)];
}

const blended = (skin: Skin, first: readonly number[], second: readonly number[]): Vec => {
  const motions = new Float32Array(2 * MOTION_STRIDE);
  motions.set(first);
  motions.set(second, MOTION_STRIDE);
  const [x = 0, y = 0] = posedPositions(skin, motions, 'rigid');
  return [x, y];
};

describe('the rigid blend', () => {
  it('turns about the pivot that two motions share', () => {
    const pivot: Vec = [3, 4];
    for (const weight of [0, 0.25, 0.5, 1]) {
      const skin = between([13, 4], [weight, 1 - weight]);
      const posed = blended(skin, motion(-1.9, pivot, [0, 0]), motion(2.2, pivot, [20, 5]));
      expect(distance(posed, pivot)).toBeCloseTo(10, 4);
    }
    const half = blended(between([13, 4], [0.5, 0.5]), motion(0, pivot, [0, 0]), motion(1, pivot, [20, 5]));
    expect(half[0]).toBeCloseTo(3 + 10 * Math.cos(0.5), 4);
    expect(half[1]).toBeCloseTo(4 + 10 * Math.sin(0.5), 4);
  });

  it('is the motion of sites that move alike, with its stretch', () => {
    const pivot: Vec = [0, 0];
    const posed = blended(
      between([5, 1], [0.5, 0.5]),
      motion(Math.PI / 2, pivot, pivot, 3),
      motion(Math.PI / 2 + 8 * Math.PI, pivot, pivot, 3),
    );
    expect(posed[0]).toBeCloseTo(-1, 4);
    expect(posed[1]).toBeCloseTo(15, 4);
  });

  it('does not jump where two half turns cancel', () => {
    const at = (angle: number) =>
      blended(between([0, 5], [0.5, 0.5]), motion(angle, [0, 0], [0, 0]), motion(-angle, [2, 0], [9, 0]));
    for (let angle = 0; angle < 20; angle += 0.001) {
      expect(distance(at(angle), at(angle + 0.001))).toBeLessThan(0.05);
    }
  });
});
