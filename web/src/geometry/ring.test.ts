import { describe, expect, it } from 'vitest';
import { areaOf, clipped, isWithin, type Ring, ringsMeet, simpleRing } from './ring';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
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

/** Whether only neighbouring edges touch. */
const isSimple = (ring: Ring): boolean => simpleRing(ring) === ring;

describe('simpleRing', () => {
  it('returns a simple ring unchanged', () => {
    const ring = square(0, 0, 10);
    expect(simpleRing(ring)).toBe(ring);
  });
  it('removes the end that overshoots the start', () => {
    // From (0, 5) around, and over the first edge to its other side.
    const ring: Ring = [
      [0, 5],
      [20, 5],
      [20, 30],
      [5, 30],
      [5, 0],
      [2, 0],
    ];
    const result = simpleRing(ring);
    expect(isSimple(result)).toBe(true);
    expect(areaOf(result)).toBeCloseTo(15 * 25, 9);
  });
  it('removes touching, overlapping and returning lines', () => {
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
      const result = simpleRing(ring);
      expect(isSimple(result)).toBe(true);
      expect(areaOf(result)).toBeCloseTo(area, 0);
    }
    expect(simpleRing([...square(0, 0, 1)].slice(0, 2))).toEqual([]);
  });
  it('removes all loops of a star', () => {
    const star: Ring = Array.from({ length: 7 }, (_, k) => {
      const turn = (2 * Math.PI * 3 * k) / 7;
      return [50 * Math.cos(turn), 50 * Math.sin(turn)];
    });
    const result = simpleRing(star);
    expect(isSimple(result)).toBe(true);
    expect(areaOf(result)).toBeGreaterThan(100);
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
