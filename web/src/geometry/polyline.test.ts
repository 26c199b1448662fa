import { describe, expect, it } from 'vitest';
import {
  bestTurn,
  centre,
  constrained,
  distanceToLine,
  edgesOf,
  isInside,
  lineCentroid,
  nearestPlace,
  nearestTurn,
} from './polyline';
import type { Vec } from './vec';

const square: readonly Vec[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

describe('a polyline', () => {
  it('has one more edge if it is closed', () => {
    expect(edgesOf(square, false)).toHaveLength(3);
    expect(edgesOf(square, true)).toHaveLength(4);
    expect(centre(square)).toEqual([2, 2]);
  });

  it('keeps its centroid when a corner on it is added', () => {
    const [from, to] = [[0, 0] as const, [4, 0] as const];
    expect(lineCentroid([from, to], false)).toEqual([2, 0]);
    expect(lineCentroid([from, [1, 0], to], false)).toEqual([2, 0]);
    expect(lineCentroid([from, to, [4, 4], [1, 4], [0, 4]], true)).toEqual([2, 2]);
    const at = [3, 1] as const;
    expect(lineCentroid([at], true)).toEqual(at);
    expect(lineCentroid([at, at], false)).toEqual(at);
  });

  it('returns the distance to the nearest point', () => {
    expect(distanceToLine(square, false, [-1, 2])).toBeCloseTo(Math.hypot(1, 2));
    expect(distanceToLine(square, true, [-1, 2])).toBe(1);
    expect(distanceToLine([[3, 3]], false, [0, 0])).toBe(Number.POSITIVE_INFINITY);
  });

  it('returns the nearest edge; the closing edge is the last', () => {
    expect(nearestPlace(square, true, [5, 1])).toEqual({ edge: 1, fraction: 0.25, distance: 1 });
    expect(nearestPlace(square, true, [-1, 1])).toEqual({ edge: 3, fraction: 0.75, distance: 1 });
    expect(nearestPlace(square, false, [-1, 3])).toMatchObject({ edge: 2, fraction: 1 });
  });

  it('contains the points inside', () => {
    expect(isInside(square, [1, 3])).toBe(true);
    expect(isInside(square, [5, 3])).toBe(false);
    expect(isInside(square, [-1, 0])).toBe(false);
  });
});

describe('turns', () => {
  it('are fitted to the corners, independent of translation', () => {
    const turned = square.map(([x, y]): Vec => [20 - y, 7 + x]);
    expect(bestTurn(square, turned)).toBeCloseTo(90);
    expect(bestTurn([[1, 1]], [[2, 2]])).toBeNull();
  });

  it('continue past half a turn', () => {
    expect(nearestTurn(-170, 185)).toBe(190);
    expect(nearestTurn(10, -350)).toBe(-350);
  });
});

describe('constrained', () => {
  it('projects onto the nearest direction of the step', () => {
    const [x, y] = constrained([1, 1], [11, 3], 45);
    expect(x).toBeCloseTo(11);
    expect(y).toBeCloseTo(1);
    expect(constrained([1, 1], [11, 9], 45)[1]).toBeCloseTo(10);
  });
});
