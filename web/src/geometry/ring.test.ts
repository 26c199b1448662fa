import { describe, expect, it } from 'vitest';
import { areaOf, clipped, isWithin, meet, type Ring, simple } from './ring';

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

/** Whether no two edges but neighbours touch. */
const isSimple = (ring: Ring): boolean => simple(ring) === ring;

describe('loops', () => {
  it('are none in a ring that does not cross itself', () => {
    const ring = square(0, 0, 10);
    expect(simple(ring)).toBe(ring);
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
    const left = simple(ring);
    expect(isSimple(left)).toBe(true);
    expect(areaOf(left)).toBeCloseTo(15 * 25, 9);
  });
  it('go where lines touch, run along one another or back', () => {
    const along: Ring = [
      [0, 0],
      [20, 0],
      [20, 20],
      [12, 20],
      [12, 0],
      [10, 0],
      [10, 20],
      [0, 20],
    ];
    const pinched: Ring = [...square(0, 0, 20), [0, 0.01], [-5, 9], [-5, 0]];
    const spiked: Ring = [
      [0, 0],
      [20, 0],
      [20, 20],
      [20, 50],
      [20, 20.01],
      [0, 20],
    ];
    for (const [ring, area] of [
      [along, 200],
      [pinched, 400],
      [spiked, 400],
    ] as const) {
      const left = simple(ring);
      expect(isSimple(left)).toBe(true);
      expect(areaOf(left)).toBeCloseTo(area, 0);
    }
    expect(simple([...square(0, 0, 1)].slice(0, 2))).toEqual([]);
  });
  it('go however many there are', () => {
    const star: Ring = Array.from({ length: 7 }, (_, k) => {
      const turn = (2 * Math.PI * 3 * k) / 7;
      return [50 * Math.cos(turn), 50 * Math.sin(turn)];
    });
    const left = simple(star);
    expect(isSimple(left)).toBe(true);
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
