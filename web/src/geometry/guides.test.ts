import { describe, expect, it } from 'vitest';
import { gridStep, snappedTo } from './guides';

describe('snapping to guides', () => {
  const lines = [
    { axis: 0, at: 50 },
    { axis: 0, at: 56 },
    { axis: 1, at: 80 },
  ] as const;
  const guides = { lines, grid: 1000 };

  it('takes the nearest line along each axis', () => {
    expect(snappedTo([54, 83], guides, 5)).toEqual({ at: [56, 80], guides: [lines[1], lines[2]] });
    expect(snappedTo([48, 100], guides, 5)).toEqual({ at: [50, 100], guides: [lines[0]] });
  });

  it('does not change a point out of reach', () => {
    expect(snappedTo([70, 100], guides, 5)).toEqual({ at: [70, 100], guides: [] });
  });

  it('takes the grid where no line is within reach', () => {
    const both = { lines, grid: 10 };
    expect(snappedTo([52, 97], both, 4)).toEqual({ at: [50, 100], guides: [lines[0], { axis: 1, at: 100 }] });
    expect(snappedTo([63, 85], both, 2)).toEqual({ at: [63, 85], guides: [] });
  });
});

describe('the grid', () => {
  it('has lines at least 64 CSS px apart, at round numbers', () => {
    expect(gridStep(1)).toBe(100);
    expect(gridStep(0.4)).toBe(200);
    expect(gridStep(2)).toBe(50);
    expect(gridStep(64)).toBe(1);
    expect(gridStep(0.01)).toBe(10_000);
  });
});
