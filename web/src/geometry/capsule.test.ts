import { describe, expect, it } from 'vitest';
import { capsule } from './capsule';
import { isInside } from './polyline';
import { areaOf } from './ring';

describe('a capsule', () => {
  it('surrounds its line at the radius', () => {
    const ring = capsule([10, 10], [30, 10], 5);
    expect(areaOf(ring)).toBeGreaterThan(0.97 * (200 + 25 * Math.PI));
    expect(areaOf(capsule([10, 10], [10, 10], 5))).toBeGreaterThan(0.95 * 25 * Math.PI);
    expect(isInside(ring, [33, 12])).toBe(true);
  });
});
