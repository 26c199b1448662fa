import { describe, expect, it } from 'vitest';
import { simplified, withoutWhiskers } from './polyline_simplified';
import type { Vec } from './vec';

describe('a simplified line', () => {
  it('keeps its ends and bends, and drops the rest', () => {
    const line: Vec[] = [
      [0, 0],
      [10, 0.4],
      [20, 0],
      [20.3, 10],
      [20, 20],
    ];
    expect(simplified(line, 0.5)).toEqual([
      [0, 0],
      [20, 0],
      [20, 20],
    ]);
    expect(simplified(line, 0.1)).toEqual(line);
  });
  it('stays within the tolerance of a curve', () => {
    const arc = Array.from({ length: 200 }, (_, k): Vec => [100 * Math.cos(k / 40), 100 * Math.sin(k / 40)]);
    expect(simplified(arc, 1).length).toBeLessThan(40);
    expect(simplified([], 1)).toEqual([]);
    expect(simplified([[1, 2]], 1)).toEqual([[1, 2]]);
  });
});

describe('a ring without whiskers', () => {
  it('loses short ways there and back, and keeps long ones', () => {
    const square: Vec[] = [
      [0, 0],
      [100, 0],
      [100, 100],
      [0, 100],
    ];
    const whisker: Vec[] = [
      [50, 0],
      [52, -6],
      [53, 0.2],
    ];
    const left = withoutWhiskers([...square.slice(0, 1), ...whisker, ...square.slice(1)], 10);
    expect(left).not.toContainEqual([52, -6]);
    expect(left).toEqual(expect.arrayContaining(square));
    const spear: Vec[] = [
      [0, 0],
      [100, 10],
      [0, 20],
    ];
    expect(withoutWhiskers(spear, 10)).toEqual(spear);
  });
});
