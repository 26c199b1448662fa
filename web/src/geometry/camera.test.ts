import { describe, expect, it } from 'vitest';
import {
  type Camera,
  deviceView,
  fitted,
  keptInView,
  pinched,
  SCALE_LIMITS,
  scaledAt,
  toImage,
  toStage,
} from './camera';

const camera: Camera = { scale: 2, x: 30, y: -10 };

describe('camera', () => {
  it('maps to the stage and back', () => {
    expect(toImage(camera, toStage(camera, [12, 7]))).toEqual([12, 7]);
  });

  it('keeps the point under the pointer when it zooms', () => {
    const anchor = [100, 60] as const;
    const under = toImage(camera, anchor);
    const [x, y] = toImage(scaledAt(camera, 5, anchor), anchor);
    expect(x).toBeCloseTo(under[0]);
    expect(y).toBeCloseTo(under[1]);
  });

  it('keeps half of a small box in view, and half of the view on a large one', () => {
    const stage = { width: 400, height: 300 };
    const insets = { top: 0, right: 100, bottom: 0, left: 0 };
    const box = { min: [0, 0], max: [100, 400] } as const;
    const at = (x: number, y: number) => keptInView({ scale: 1, x, y }, box, stage, insets);
    expect(at(20, -30)).toMatchObject({ x: 20, y: -30 });
    expect(at(1e4, 1e4)).toMatchObject({ x: 250, y: 150 });
    expect(at(-1e4, -1e4)).toMatchObject({ x: -50, y: -250 });
    expect(keptInView({ scale: 1, x: 5, y: 5 }, box, { width: 0, height: 0 }, insets).scale).toBe(1);
  });

  it('clamps the scale', () => {
    expect(scaledAt(camera, 1e9, [0, 0]).scale).toBe(SCALE_LIMITS[1]);
    expect(scaledAt(camera, 0, [0, 0]).scale).toBe(SCALE_LIMITS[0]);
  });

  it('fits the image between the insets, centred, and enlarges small ones', () => {
    const insets = { top: 50, right: 0, bottom: 0, left: 100 };
    const image = { min: [0, 0], max: [1000, 500] } as const;
    expect(fitted(image, { width: 600, height: 1050 }, insets)).toEqual({ scale: 0.5, x: 100, y: 425 });
    const small = { min: [0, 0], max: [16, 11] } as const;
    expect(fitted(small, { width: 900, height: 600 }, insets).scale).toBe(50);
    const least = { min: [0, 0], max: [2, 2] } as const;
    expect(fitted(least, { width: 900, height: 600 }, insets).scale).toBe(SCALE_LIMITS[1]);
  });

  it('fits boxes that extend beyond the image', () => {
    const box = { min: [-100, -300], max: [900, 200] } as const;
    const insets = { top: 50, right: 0, bottom: 0, left: 100 };
    const camera = fitted(box, { width: 600, height: 1050 }, insets);
    expect(toStage(camera, box.min)).toEqual([100, 425]);
    expect(toStage(camera, box.max)).toEqual([600, 675]);
  });

  it('keeps the image points under two fingers that spread', () => {
    const before = [
      [100, 100],
      [200, 100],
    ] as const;
    const after = [
      [90, 120],
      [290, 120],
    ] as const;
    const next = pinched(camera, before, after);
    expect(next.scale).toBe(4);
    for (const finger of [0, 1] as const) {
      const [x, y] = toStage(next, toImage(camera, before[finger]));
      expect(x).toBeCloseTo(after[finger][0]);
      expect(y).toBeCloseTo(after[finger][1]);
    }
  });

  it('converts to a view in device pixels', () => {
    expect(deviceView(camera, { width: 301, height: 200 }, 1.5)).toEqual({
      scale: 3,
      x: 45,
      y: -15,
      width: 452,
      height: 300,
      pixelRatio: 1.5,
    });
  });
});
