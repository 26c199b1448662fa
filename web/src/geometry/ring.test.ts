import { describe, expect, it } from 'vitest';
import { areaOf, clipped, crosses, isWithin, meet, type Ring, withoutLoops } from './ring';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];
const box = { min: [0, 0], max: [100, 50] } as const;

describe('clipping to a box', () => {
  it('leaves alone what is within', () => {
    expect(clipped(square(10, 10, 20), box)).toHaveLength(4);
    expect(areaOf(clipped(square(10, 10, 20), box))).toBe(400);
  });
  it('cuts at the box, on the side exactly', () => {
    const ring = clipped(square(-10, -10, 40), box);
    expect(areaOf(ring)).toBe(900);
    expect(Math.min(...ring.flat())).toBe(0);
  });
  it('leaves the box of what is all around it, and nothing of what is beside', () => {
    expect(areaOf(clipped(square(-200, -200, 600), box))).toBe(5000);
    expect(clipped(square(120, 0, 10), box)).toEqual([]);
  });
});

describe('loops', () => {
  it('are none in a ring that does not cross itself', () => {
    const ring = square(0, 0, 10);
    expect(withoutLoops(ring)).toBe(ring);
  });
  it('go where a hand drew beyond the start', () => {
    // From (0, 5) around, and over the first edge to its other side.
    const ring: Ring = [
      [0, 5],
      [20, 5],
      [20, 30],
      [5, 30],
      [5, 0],
      [2, 0],
    ];
    const left = withoutLoops(ring);
    expect(crosses(left, true, left)).toBe(false);
    expect(areaOf(left)).toBeCloseTo(15 * 25, 9);
  });
  it('go however many there are', () => {
    const star: Ring = Array.from({ length: 7 }, (_, k) => {
      const turn = (2 * Math.PI * 3 * k) / 7;
      return [50 * Math.cos(turn), 50 * Math.sin(turn)];
    });
    const left = withoutLoops(star);
    expect(crosses(left, true, left)).toBe(false);
    expect(areaOf(left)).toBeGreaterThan(100);
  });
});

it('rings meet where they cross and where one holds the other', () => {
  const [around, inner, beside, over] = [
    square(0, 0, 40),
    square(10, 10, 10),
    square(60, 0, 10),
    square(30, 10, 40),
  ];
  expect(isWithin(inner, around)).toBe(true);
  expect([meet(around, inner), meet(inner, around), meet(around, over)]).toEqual([true, true, true]);
  expect([meet(around, beside), meet(inner, beside)]).toEqual([false, false]);
});
