import { describe, expect, it } from 'vitest';
import { PixelMap } from './pixel_map';

describe('PixelMap', () => {
  it('takes values between the points, and NaN outside the shape', () => {
    // The upper left half of a square of 2 × 2 pixels of the picture, drawn twice as large.
    const points = Float64Array.of(0, 0, 2, 0, 0, 2);
    const map = new PixelMap(points, Uint32Array.of(0, 1, 2), 4, 4, 2);
    const values = map.values(Float64Array.from([0, 10, 20]));
    const at = (x: number, y: number) => values[y * 4 + x];
    // The middle of the pixel (0, 0) is at (0.25, 0.25) of the picture.
    expect(at(0, 0)).toBeCloseTo(0.125 * 10 + 0.125 * 20, 5);
    expect(at(2, 1)).toBeCloseTo(0.625 * 10 + 0.375 * 20, 5);
    expect(at(3, 3)).toBeNaN();
  });
});
