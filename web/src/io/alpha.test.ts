import { describe, expect, it } from 'vitest';
import { alphaThreshold } from './alpha';

/** A picture by the alpha of its pixels. */
function picture(width: number, height: number, alpha: (x: number, y: number) => number) {
  const rgba = new Uint8Array(width * height * 4);
  for (let pixel = 0; pixel < width * height; pixel++)
    rgba[pixel * 4 + 3] = alpha(pixel % width, Math.floor(pixel / width));
  return { width, height, rgba };
}

/** A disc that fades out over so many pixels. */
const disc = (fading: number) =>
  picture(80, 80, (x, y) => 255 * Math.min(1, Math.max(0, (30 - Math.hypot(x - 40, y - 40)) / fading)));

describe('the alpha from which a picture is warped', () => {
  it('is none where all is opaque', () => {
    expect(alphaThreshold(picture(9, 7, () => 255))).toBeNull();
    expect(alphaThreshold(picture(9, 7, (x) => (x === 8 ? 254 : 255)))).toBe(0.5);
  });

  it('is half way up edges that the rim covers', () => {
    expect(alphaThreshold(disc(0.01))).toBe(0.5);
    expect(alphaThreshold(disc(5))).toBe(0.5);
  });

  it('is next to nothing where a shadow or a veil would be cut off', () => {
    expect(alphaThreshold(disc(20))).toBeLessThan(0.03);
    expect(alphaThreshold(picture(80, 80, () => 120))).toBeLessThan(0.03);
  });

  it('takes no notice of dust, nor of what cannot be seen', () => {
    expect(alphaThreshold(picture(80, 80, (x, y) => (x < 20 ? 255 : x === 60 && y < 40 ? 90 : 0)))).toBe(0.5);
    expect(alphaThreshold(picture(80, 80, (x) => (x < 20 ? 255 : 3)))).toBe(0.5);
  });
});
