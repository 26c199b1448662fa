import { describe, expect, it } from 'vitest';
import { areaOf, clipped, isSimple, isWithin, type Ring, ringsMeet, withoutCurls } from './ring';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];
/** From (0, 5) around, and over the first edge to its other side. */
const OVERSHOT: Ring = [
  [0, 5],
  [20, 5],
  [20, 30],
  [5, 30],
  [5, 0],
  [2, 0],
];
const box = { min: [0, 0], max: [100, 50] } as const;

describe('clipping to a box', () => {
  it('keeps rings inside the box', () => {
    expect(clipped(square(10, 10, 20), box)).toHaveLength(4);
    expect(areaOf(clipped(square(10, 10, 20), box))).toBe(400);
  });
  it('cuts exactly at the sides of the box', () => {
    const ring = clipped(square(-10, -10, 40), box);
    expect(areaOf(ring)).toBe(900);
    expect(Math.min(...ring.flat())).toBe(0);
  });
  it('returns the box for rings around it, and nothing for rings beside it', () => {
    expect(areaOf(clipped(square(-200, -200, 600), box))).toBe(5000);
    expect(clipped(square(120, 0, 10), box)).toEqual([]);
  });
});

describe('a line without its curls', () => {
  const turned: Ring = [
    [0, 0],
    [100, 0],
    // A small loop on the outside of the corner, and one on the inside.
    [104, 0],
    [104, -4],
    [100, -4],
    [100, 100],
    [100, 103],
    [97, 103],
    [97, 100],
    [103, 100],
    [0, 100],
  ];
  it('keeps its way beside them', () => {
    const ring = withoutCurls(turned, 20);
    expect(isSimple(ring)).toBe(true);
    expect(areaOf(ring)).toBeGreaterThan(9980);
    expect(Math.min(...ring.map(([, y]) => y))).toBe(0);
  });
  it('keeps longer loops, and ends that overshoot the start lose no more than that', () => {
    expect(withoutCurls(turned, 5)).toBe(turned);
    const ring = withoutCurls(OVERSHOT, 20);
    expect(isSimple(ring)).toBe(true);
    expect(areaOf(ring)).toBeCloseTo(15 * 25, 9);
  });
});

it('rings meet if they cross or one contains the other', () => {
  const [around, inner, beside, over] = [
    square(0, 0, 40),
    square(10, 10, 10),
    square(60, 0, 10),
    square(30, 10, 40),
  ];
  expect(isWithin(inner, around)).toBe(true);
  expect([ringsMeet(around, inner), ringsMeet(inner, around), ringsMeet(around, over)]).toEqual([
    true,
    true,
    true,
  ]);
  expect([ringsMeet(around, beside), ringsMeet(inner, beside)]).toEqual([false, false]);
});
