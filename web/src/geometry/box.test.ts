import { describe, expect, it } from 'vitest';
import { boxBetween, fractionsInside } from './box';
import { lerp, type Vec } from './vec';

const box = boxBetween([100, 50], [0, 0]);

describe('fractionsInside', () => {
  it('returns where the segment enters and leaves', () => {
    expect(fractionsInside(box, [-50, 25], [150, 25])).toEqual([0.25, 0.75]);
    expect(fractionsInside(box, [50, 150], [50, -50])).toEqual([0.5, 0.75]);
    expect(fractionsInside(box, [10, 10], [20, 20])).toEqual([0, 1]);
  });

  it('accepts segments that end on the edge', () => {
    expect(fractionsInside(box, [-50, 0], [0, 0])).toEqual([1, 1]);
    expect(fractionsInside(box, [100, 50], [100, 50])).toEqual([0, 1]);
  });

  it('returns null for segments beside the box', () => {
    expect(fractionsInside(box, [-10, 25], [-1, 25])).toBeNull();
    expect(fractionsInside(box, [-10, 60], [110, 60])).toBeNull();
    expect(fractionsInside(box, [-40, 20], [20, 80])).toBeNull();
  });

  it('agrees with a point test for any direction', () => {
    for (let k = 0; k < 60; k += 1) {
      const at = (turn: number): Vec => [50 + 300 * Math.cos(turn), 25 + 300 * Math.sin(turn)];
      const [a, b] = [at(k), at(2.4 * k + 1)];
      const fractions = fractionsInside(box, a, b);
      const inside = ([x, y]: Vec) => x >= 0 && x <= 100 && y >= 0 && y <= 50;
      for (let step = 0; step <= 200; step += 1) {
        const fraction = step / 200;
        const within = fractions !== null && fraction > fractions[0] && fraction < fractions[1];
        expect(inside(lerp(a, b, fraction))).toBe(within);
      }
    }
  });
});
