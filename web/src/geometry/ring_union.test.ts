import { describe, expect, it } from 'vitest';
import { isInside } from './polyline';
import { areaOf, type Ring, simpleRing } from './ring';
import { capsule, unionOf } from './ring_union';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];

describe('the union of two rings', () => {
  it('has the area of both, once', () => {
    expect(areaOf(unionOf(square(0, 0, 10), square(5, 5, 10)))).toBeCloseTo(175);
    expect(areaOf(unionOf(square(5, 5, 10), square(0, 0, 10).toReversed()))).toBeCloseTo(175);
  });
  it('is the outer ring where one contains the other', () => {
    expect(areaOf(unionOf(square(0, 0, 10), square(2, 3, 4)))).toBe(100);
  });
  it('fills the enclosed area', () => {
    const horseshoe: Ring = [
      [0, 0],
      [10, 0],
      [10, 30],
      [20, 30],
      [20, 0],
      [30, 0],
      [30, 40],
      [0, 40],
    ];
    const lid: Ring = [
      [-1, 5],
      [31, 5],
      [31, 8],
      [-1, 8],
    ];
    const union = unionOf(horseshoe, lid);
    expect(simpleRing(union)).toHaveLength(union.length);
    expect(isInside(union, [15, 20])).toBe(true);
    expect(isInside(union, [15, 3])).toBe(false);
  });
});

describe('a capsule', () => {
  it('surrounds its line at the radius', () => {
    const ring = capsule([10, 10], [30, 10], 5);
    expect(areaOf(ring)).toBeGreaterThan(0.97 * (200 + 25 * Math.PI));
    expect(areaOf(capsule([10, 10], [10, 10], 5))).toBeGreaterThan(0.95 * 25 * Math.PI);
    expect(isInside(ring, [33, 12])).toBe(true);
  });
});
