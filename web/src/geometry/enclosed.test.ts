import { describe, expect, it } from 'vitest';
import { enclosedBy, simpleRing, unionOf } from './enclosed';
import { distanceToLine, edgesOf, isInside } from './polyline';
import { areaOf, isInsideOf, isSimple, type Ring } from './ring';
import type { Vec } from './vec';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];

/** How often a line goes around a place, clockwise. */
function windings(line: Ring, [x, y]: Vec): number {
  const turns = line.map((at, k) => {
    const next = line[(k + 1) % line.length] ?? at;
    const [from, to] = [at, next].map((p) => Math.atan2(p[1] - y, p[0] - x)) as [number, number];
    const turn = to - from;
    return turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  });
  return Math.round(turns.reduce((sum, turn) => sum + turn, 0) / (2 * Math.PI));
}

/** Whether edges of two rings cross. */
const cross = (one: Ring, other: Ring): boolean => {
  const side = (a: Vec, b: Vec, p: Vec) =>
    Math.sign((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
  return edgesOf(one, true).some(([a, b]) =>
    edgesOf(other, true).some(([c, d]) => side(a, b, c) !== side(a, b, d) && side(c, d, a) !== side(c, d, b)),
  );
};

/** Fails unless the rings are simple and disjoint, and have all that the line goes around inside. */
function expectAllOf(line: Ring, rings: readonly Ring[]): void {
  rings.forEach((ring, k) => {
    expect(isSimple(ring)).toBe(true);
    for (const other of rings.slice(k + 1)) expect(cross(ring, other)).toBe(false);
  });
  const [xs, ys] = [line.map(([x]) => x), line.map(([, y]) => y)];
  const at = (values: number[], k: number) => {
    const low = Math.min(...values) - 1;
    return low + ((Math.max(...values) + 1 - low) * (k + 0.37)) / 40;
  };
  const wrong: Vec[] = [];
  for (let i = 0; i < 40; i++)
    for (let j = 0; j < 40; j++) {
      const place: Vec = [at(xs, i), at(ys, j)];
      // Shared corners are moved apart.
      const isClear = distanceToLine(line, true, place) > 0.2;
      if (isClear && isInsideOf(rings, place) !== (windings(line, place) !== 0)) wrong.push(place);
    }
  expect(wrong).toEqual([]);
}

describe('the rings that a line encloses', () => {
  const eight = (count: number, lobes = 2): Ring =>
    Array.from({ length: count }, (_, k) => {
      const turn = (2 * Math.PI * (k + 0.4)) / count;
      return [200 + 150 * Math.cos(turn), 150 + 90 * Math.sin(lobes * turn)];
    });

  it('are one for each lobe of a figure eight', () => {
    for (const count of [7, 16, 41]) {
      const rings = enclosedBy([eight(count)]);
      expect(rings).toHaveLength(2);
      expectAllOf(eight(count), rings);
    }
    expect(enclosedBy([eight(61, 3)])).toHaveLength(3);
    expectAllOf(eight(61, 3), enclosedBy([eight(61, 3)]));
    // Corners on the crossing itself.
    const square8: Ring = [...square(0, 0, 20), [0, 0], [-20, 0], [-20, -20], [0, -20]];
    expect(enclosedBy([square8]).map(areaOf).map(Math.round)).toEqual([398, 398]);
  });
  it('have all of a line that goes around twice, or has loops at its turns', () => {
    const twice: Ring = Array.from({ length: 60 }, (_, k) => {
      const [turn, radius] = [(2 * Math.PI * k) / 30.5, 80 + k / 3];
      return [100 + radius * Math.cos(turn), 100 + radius * Math.sin(turn)];
    });
    expectAllOf(twice, enclosedBy([twice]));
    expect(enclosedBy([twice], 16)).toHaveLength(1);
    const looped: Ring = [
      [0, 0],
      [110, 0],
      [110, 10],
      [100, 10],
      [100, -10],
      [120, -10],
      [120, 100],
      [0, 100],
    ];
    expectAllOf(looped, enclosedBy([looped]));
  });
  it('have a hole where a line leaves out its middle', () => {
    // A band, nearly closed, whose ends overlap.
    const band: Ring = [
      ...square(0, 0, 100),
      [0, -5],
      [20, -5],
      [20, 80],
      [80, 80],
      [80, 20],
      [-5, 20],
      [-5, 0],
    ];
    const rings = enclosedBy([band]);
    expectAllOf(band, rings);
    expect(isInsideOf(rings, [50, 50])).toBe(false);
  });
  it('are whole for lines that cross themselves many times', () => {
    let seed = 7;
    const random = () => {
      seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
      return seed / 0x7fffffff;
    };
    for (const [count, step] of [
      [5, 1e-3],
      [9, 1e-3],
      [16, 1e-3],
      // On a coarse grid, edges overlap and corners meet.
      [12, 20],
      [30, 25],
    ] as const)
      for (let round = 0; round < 12; round++) {
        const line = Array.from({ length: count }, (): Vec => {
          const place = () => Math.round((random() * 200) / step) * step;
          return [place(), place()];
        });
        expectAllOf(line, enclosedBy([line]));
      }
  });
  it('are of a least size, apart from the largest one', () => {
    expect(enclosedBy([eight(41)], 1e9)).toHaveLength(1);
    const small: Ring = [...square(0, 0, 50), [0, 0], [-3, 0], [-3, -3], [0, -3]];
    expect(enclosedBy([small], 16).map(areaOf)).toEqual([2500]);
    expect(enclosedBy([square(0, 0, 10).slice(0, 2)])).toEqual([]);
    expect(enclosedBy([])).toEqual([]);
  });
});

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

describe('the union of two rings', () => {
  it('has the area of both, once', () => {
    expect(areaOf(unionOf(square(0, 0, 10), square(5, 5, 10)))).toBeCloseTo(175);
    expect(areaOf(unionOf(square(5, 5, 10), square(0, 0, 10).toReversed()))).toBeCloseTo(175);
  });
  it('is the outer ring where one contains the other', () => {
    expect(areaOf(unionOf(square(0, 0, 10), square(2, 3, 4)))).toBe(100);
  });
  it('fills what they enclose', () => {
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
