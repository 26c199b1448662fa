import { describe, expect, it } from 'vitest';
import { alphaThreshold } from './alpha';

/** Returns a picture with the given alpha at each pixel. */
function picture(width: number, height: number, alpha: (x: number, y: number) => number) {
  const rgba = new Uint8Array(width * height * 4);
  for (let pixel = 0; pixel < width * height; pixel++)
    rgba[pixel * 4 + 3] = alpha(pixel % width, Math.floor(pixel / width));
  return { width, height, rgba };
}

/** Returns a disc that fades out over `fading` pixels. */
const disc = (fading: number) =>
  picture(80, 80, (x, y) => 255 * Math.min(1, Math.max(0, (30 - Math.hypot(x - 40, y - 40)) / fading)));

describe('alphaThreshold', () => {
  it('returns null for opaque pictures', () => {
    expect(alphaThreshold(picture(9, 7, () => 255))).toBeNull();
    expect(alphaThreshold(picture(9, 7, (x) => (x === 8 ? 254 : 255)))).toBe(0.5);
  });

  it('returns one half if the skirt covers the soft edges', () => {
    expect(alphaThreshold(disc(0.01))).toBe(0.5);
    expect(alphaThreshold(disc(5))).toBe(0.5);
  });

  it('returns a low threshold for soft shadows and veils', () => {
    expect(alphaThreshold(disc(20))).toBeLessThan(0.03);
    expect(alphaThreshold(picture(80, 80, () => 120))).toBeLessThan(0.03);
  });

  it('ignores dust and invisible pixels', () => {
    expect(alphaThreshold(picture(80, 80, (x, y) => (x < 20 ? 255 : x === 60 && y < 40 ? 90 : 0)))).toBe(0.5);
    expect(alphaThreshold(picture(80, 80, (x) => (x < 20 ? 255 : 3)))).toBe(0.5);
  });

  it('falls to the alpha at which the pieces of a strand are connected', () => {
    // A strand of alternating alpha between two blocks.
    const strand = (low: number) =>
      picture(80, 80, (x, y) => {
        if (x < 20 || x >= 60) return 255;
        return y !== 40 ? 0 : Math.floor(x / 4) % 2 === 0 ? low : 200;
      });
    expect(alphaThreshold(strand(70))).toBe(63.5 / 255);
    expect(alphaThreshold(strand(190))).toBe(0.5);
    // The rims of two edges touch. They are no strand.
    expect(alphaThreshold(strand(20))).toBe(0.5);
  });

  it('connects diagonal pixels as an outline does', () => {
    const diagonal = (alpha: number) =>
      picture(80, 80, (x, y) => {
        if (x < 20 || x >= 60) return 255;
        return x === y ? (x % 6 < 3 ? 255 : alpha) : 0;
      });
    // The mean of two such pixels and two transparent ones is half as high.
    expect(alphaThreshold(diagonal(255))).toBe(111.5 / 255);
    expect(alphaThreshold(diagonal(120))).toBe(47.5 / 255);
  });

  it('finds the strands of a large picture', () => {
    const large = picture(3000, 1500, (x, y) =>
      x < 1000 || x >= 2000 ? 255 : Math.abs(y - 700) < 3 ? (x % 40 < 6 ? 90 : 255) : 0,
    );
    expect(alphaThreshold(large)).toBe(79.5 / 255);
  });
});
