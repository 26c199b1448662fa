import { describe, expect, it } from 'vitest';
import { keyCorners, trackOf } from './clip_keys';
import { corners } from './handle';
import type { PosesAt } from './moment';
import type { PointHandle } from './project';
import { thinned } from './thinning';

/** Linear between keys. */
const linear: PosesAt = (clip, handles, time) =>
  handles.map((handle) => {
    const keys = trackOf(clip, handle.id)?.keys ?? [];
    const before = keys.findLast((key) => key.time <= time) ?? keys[0];
    const after = keys.find((key) => key.time > time) ?? before;
    const places = [before, after].map((key) => (key?.posed ? keyCorners(key.posed)[0] : corners(handle)[0]));
    const [[x0, y0], [x1, y1]] = places as [[number, number], [number, number]];
    const t = before && after && after !== before ? (time - before.time) / (after.time - before.time) : 0;
    return { posed: [[x0 + t * (x1 - x0), y0 + t * (y1 - y0)]], rotation: Number.NaN, scale: 1, depth: 0 };
  });

const sample = (time: number, x: number, y = 0) => {
  const handle: PointHandle = { id: 'a', kind: 'point', rest: [0, 0], posed: [x, y], rotation: 'auto' };
  return { time, handle };
};
const timesOf = (samples: ReturnType<typeof sample>[]) => thinned(samples, linear).map(({ time }) => time);

describe('thinned', () => {
  it('keeps two keys of a straight way', () => {
    const way = Array.from({ length: 60 }, (_, k) => sample(k / 30, 3 * k));
    expect(timesOf(way)).toEqual([0, 1.96667]);
  });

  it('keeps the corners of a way', () => {
    const way = Array.from({ length: 61 }, (_, k) => sample(k / 30, k < 30 ? 5 * k : 300 - 5 * k));
    expect(timesOf(way)).toEqual([0, 1, 2]);
  });

  it('stays within a pixel of a shaky way', () => {
    const way = Array.from({ length: 90 }, (_, k) =>
      sample(k / 30, 80 * Math.sin(k / 9), 20 * Math.cos(k / 5)),
    );
    const keys = thinned(way, linear);
    const clip = { name: 'a', duration: 3, tracks: [{ handle: 'a', keys }] };
    for (const { time, handle } of way) {
      const [pose] = linear(clip, [handle], Math.round(time * 1e5) / 1e5);
      const [x = 0, y = 0] = pose?.posed[0] ?? [];
      expect(Math.hypot(x - handle.posed[0], y - handle.posed[1])).toBeLessThanOrEqual(1);
    }
    expect(keys.length).toBeLessThan(60);
  });

  it('keeps one or two samples as they are', () => {
    expect(timesOf([])).toEqual([]);
    expect(timesOf([sample(0, 1), sample(0.1, 1)])).toEqual([0, 0.1]);
  });
});
