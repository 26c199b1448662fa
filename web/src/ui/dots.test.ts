import { describe, expect, it } from 'vitest';
import { distance, type Vec } from '../geometry/vec';
import { onStage } from './dots';

const stage = { width: 1200, height: 800 };

/** The lines of a path, as pairs of ends. */
const linesOf = (path: string): readonly (readonly [Vec, Vec])[] =>
  [...path.matchAll(/M([^L]+)L([^M]+)/g)].map(([, from, to]) => {
    const vec = (text: string | undefined) => (text ?? '').split(',').map(Number) as unknown as Vec;
    return [vec(from), vec(to)] as const;
  });

describe('a dotted line', () => {
  const corners: readonly Vec[] = [
    [100, 100],
    [300, 100],
    [300, 400],
  ];

  it('is drawn whole where all of it can be seen', () => {
    expect(onStage(corners, false, stage)).toBe('M100,100L300,100M300,100L300,400');
    expect(linesOf(onStage(corners, true, stage))).toHaveLength(3);
  });

  it('is at most as long as the stage, at any zoom', () => {
    for (const scale of [1, 8, 64, 1e4]) {
      const near = corners.map(([x, y]): Vec => [600 + (x - 250) * scale, 400 + (y - 100) * scale]);
      const length = linesOf(onStage(near, true, stage)).reduce((sum, [a, b]) => sum + distance(a, b), 0);
      expect(length).toBeGreaterThan(0);
      expect(length).toBeLessThan(3 * Math.hypot(stage.width + 20, stage.height + 20));
    }
  });

  it('has its dots in the same places when its corner is out of sight', () => {
    const from: Vec = [-1000, 300];
    const [[start]] = linesOf(onStage([from, [2000, 300]], false, stage)) as [readonly [Vec, Vec]];
    const dots = distance(from, start) / 6.5;
    expect(dots).toBeCloseTo(Math.round(dots), 9);
    expect(start[0]).toBeGreaterThan(-20);
    expect(start[0]).toBeLessThanOrEqual(0);
  });

  it('is nothing where it cannot be seen', () => {
    expect(
      onStage(
        [
          [-50, -50],
          [-20, 900],
        ],
        false,
        stage,
      ),
    ).toBe('');
    expect(
      onStage(
        [
          [5, 5],
          [5, 5],
        ],
        false,
        stage,
      ),
    ).toBe('M5,5L5,5');
  });
});
