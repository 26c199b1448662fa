import { describe, expect, it } from 'vitest';
import { isPixelArt } from './pixel_art';

const drawn = (width: number, height: number, pixel: (at: number) => readonly number[]) => ({
  width,
  height,
  rgba: Uint8Array.from(Array.from({ length: width * height }, (_, at) => pixel(at)).flat()),
});

describe('isPixelArt', () => {
  it('accepts few colours with hard edges, and ignores transparent colours', () => {
    expect(
      isPixelArt(drawn(48, 32, (at) => (at % 3 ? [at % 64, 0, 9, 255] : [at % 251, at % 7, 0, 0]))),
    ).toBe(true);
  });

  it('rejects many colours, soft edges and large pictures', () => {
    expect(isPixelArt(drawn(48, 32, (at) => [at % 65, 0, 0, 255]))).toBe(false);
    expect(isPixelArt(drawn(48, 32, (at) => [0, 0, 0, at === 7 ? 254 : 255]))).toBe(false);
    expect(isPixelArt(drawn(257, 4, () => [0, 0, 0, 255]))).toBe(false);
  });
});
