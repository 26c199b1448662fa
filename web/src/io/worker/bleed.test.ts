import { expect, it } from 'vitest';
import { bleed } from './bleed';

it('transparent pixels get the nearest colour of their row or column', () => {
  const [width, height] = [5, 4];
  const rgba = new Uint8Array(4 * width * height);
  rgba.set([10, 20, 30, 255], 4 * (1 * width + 1));
  rgba.set([40, 50, 60, 128], 4 * (1 * width + 4));
  bleed(rgba, width, height);
  const pixel = (x: number, y: number) =>
    Array.from(rgba.subarray(4 * (y * width + x), 4 * (y * width + x) + 4));
  expect(pixel(0, 1)).toEqual([10, 20, 30, 0]);
  expect(pixel(1, 3)).toEqual([10, 20, 30, 0]);
  expect(pixel(4, 0)).toEqual([40, 50, 60, 0]);
  // Existing pixels do not change.
  expect(pixel(1, 1)).toEqual([10, 20, 30, 255]);
  expect(pixel(4, 1)).toEqual([40, 50, 60, 128]);
});
