import { describe, expect, it } from 'vitest';
import { DrawingOrder } from './drawing_order';
import { locate } from './locate';
import { MOTION_STRIDE, type Skin } from './skin';

/** Two triangles of a site each and one that nothing moves, all in the same place. */
const skin: Skin = {
  positions: Float32Array.of(0, 0, 1, 0, 0, 1, 10, 0, 11, 0, 10, 1, 20, 0, 21, 0, 20, 1),
  triangles: Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 7, 8),
  offsets: Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 6, 6, 6),
  sites: Uint32Array.of(0, 0, 0, 1, 1, 1),
  weights: new Float32Array(6).fill(1),
};

const depths = (...values: readonly number[]): Float32Array => {
  const motions = new Float32Array(values.length * MOTION_STRIDE);
  values.forEach((depth, site) => {
    motions[MOTION_STRIDE * site + 8] = depth;
  });
  return motions;
};

describe('DrawingOrder', () => {
  const drawn = (...values: readonly number[]) => [
    ...new DrawingOrder(skin).triangles(depths(...values)).filter((_, i) => i % 3 === 0),
  ];

  it('draws the nearer later, and what no site moves at depth 0', () => {
    expect(drawn(1, -1)).toEqual([3, 6, 0]);
    expect(drawn(-2, -1)).toEqual([0, 3, 6]);
    expect(drawn(3, 2)).toEqual([6, 3, 0]);
  });

  it('keeps the order of the mesh among the equally deep', () => {
    expect(drawn(0, 0)).toEqual([0, 3, 6]);
    expect(drawn(5, 5)).toEqual([6, 0, 3]);
    expect(drawn(1e-9, 1e-9 * (1 + 1e-7))).toEqual([6, 0, 3]);
  });

  it('gives the same array until a depth changes', () => {
    const order = new DrawingOrder(skin);
    const first = order.triangles(depths(1, 0));
    expect(order.triangles(depths(1, 0))).toBe(first);
    expect(order.triangles(depths(0, 1))).not.toBe(first);
  });

  it('decides what lies under a pointer', () => {
    const posed = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);
    const found = (...values: readonly number[]) => {
      const triangles = new DrawingOrder(skin).triangles(depths(...values));
      return locate({ ...skin, triangles }, posed, [0.2, 0.2])?.rest[0];
    };
    expect(found(2, 1)).toBeCloseTo(0.2);
    expect(found(1, 2)).toBeCloseTo(10.2);
  });
});
