import { describe, expect, it } from 'vitest';
import { buffersOf, luminanceOf } from './luminance';

const pixels = (...levels: readonly (readonly [number, number, number, number])[]) =>
  new Uint8Array(levels.flat());

describe('the luminance of a picture', () => {
  it('weighs colours as eyes do, and takes transparent pixels for black', () => {
    const { values } = luminanceOf(
      pixels([255, 255, 255, 255], [255, 0, 0, 255], [0, 255, 0, 255], [255, 255, 255, 0]),
      4,
      1,
    );
    expect([...values]).toEqual([255, 54, 182, 0]);
  });
  it('has few numbers for a large picture, each a mean', () => {
    const rgba = new Uint8Array(40 * 30 * 4).map((_, k) => (k % 4 === 3 || (k >> 2) % 2 === 0 ? 255 : 155));
    const { width, height, step, values } = luminanceOf(rgba, 40, 30, 300);
    expect([width, height, step]).toEqual([20, 15, 2]);
    expect(new Set(values)).toEqual(new Set([205]));
  });
  it('brings coarser ones, down to few numbers', () => {
    const fine = luminanceOf(new Uint8Array(500 * 300 * 4).fill(255), 500, 300);
    expect([fine.coarser?.width, fine.coarser?.height, fine.coarser?.step]).toEqual([250, 150, 2]);
    expect(fine.coarser?.coarser).toBeNull();
    expect(new Set(fine.coarser?.values)).toEqual(new Set([255]));
    expect(buffersOf(fine)).toHaveLength(2);
  });
});
