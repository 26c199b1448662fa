import { describe, expect, it } from 'vitest';
import { edgeWindow } from './edge_cost';
import type { Luminance } from './luminance';
import { distanceToLine, edgesOf } from './polyline';
import { areaOf } from './ring';
import { edgeNear, edgePath, finePath, MOST_NODES } from './scissors';
import { distance, lerp, type Vec } from './vec';

/** A picture with noise, the same in every run. @param level how light a place is, in image pixels. */
function noisy(width: number, height: number, level: (at: Vec) => number, step = 1): Luminance {
  let seed = 1;
  const noise = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return (seed / 0x7fffffff - 0.5) * 50;
  };
  const values = new Uint8Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      values[y * width + x] = level([(x + 0.5) * step, (y + 0.5) * step]) + noise();
    }
  return { width, height, values, step, coarser: null };
}

/** A light disc on a dark ground. */
const disc = (width: number, height: number, centre: Vec, radius: number, step = 1): Luminance =>
  noisy(width, height, (at) => (distance(at, centre) < radius ? 170 : 80), step);

const on = (centre: Vec, radius: number, degrees: number): Vec => {
  const turn = (degrees * Math.PI) / 180;
  return [centre[0] + radius * Math.cos(turn), centre[1] + radius * Math.sin(turn)];
};
const CENTRE: Vec = [150, 120];
const RADIUS = 70;
const picture = disc(300, 240, CENTRE, RADIUS);
const offEdge = (places: readonly Vec[], centre = CENTRE, radius = RADIUS) =>
  Math.max(...places.map((place) => Math.abs(distance(place, centre) - radius)));

describe('a path along edges', () => {
  it('follows a noisy disc within two pixels, in few corners', () => {
    for (const [from, to] of [
      [0, 90],
      [100, 200],
      [350, 260],
    ] as const) {
      const path = finePath(picture, [on(CENTRE, RADIUS, from)], on(CENTRE, RADIUS, to));
      expect(offEdge(path), `from ${from}`).toBeLessThan(2);
      expect(path.length).toBeLessThan(40);
    }
  });
  it('ends at the requested point, and is straight without edges', () => {
    const flat = { width: 100, height: 100, values: new Uint8Array(1e4).fill(99), step: 1, coarser: null };
    for (const to of [
      [90, 35],
      [12, 80],
      [10, 10],
    ] as const)
      expect(edgePath(flat, [[10, 10]], to)).toEqual([to]);
  });
  it('searches few nodes of a picture of any size', () => {
    const large = disc(2000, 1500, [2000, 1500], 1100, 2);
    const window = edgeWindow(large, [0, 0], [4000, 3000], MOST_NODES);
    expect(window.width * window.height).toBeLessThanOrEqual(MOST_NODES);
    const [from, to] = [10, 80].map((degrees) => on([2000, 1500], 1100, degrees)) as [Vec, Vec];
    expect(offEdge(edgePath(large, [from], to), [2000, 1500], 1100)).toBeLessThan(window.pitch);
    // A path that is set is as precise as the luminance, of a pixel in two.
    const fine = finePath(large, [from], to);
    expect(offEdge(fine, [2000, 1500], 1100)).toBeLessThan(4);
    expect(fine.at(-1)).toEqual(to);
  });
});

describe('the edge near a place', () => {
  it('is the clearest one within reach', () => {
    expect(offEdge([edgeNear(picture, on(CENTRE, RADIUS + 6, 30), 10)])).toBeLessThan(2);
  });
  it('is the place itself where nothing is clear', () => {
    expect(edgeNear(picture, [20, 20], 10)).toEqual([20, 20]);
    expect(edgeNear(picture, [-50, -50], 10)).toEqual([-50, -50]);
  });
});

describe('a path that continues an outline', () => {
  const TOP = 60;
  /** A light rocket of a width and a height, whose tip is a fifth of that. The ground to its right may be lighter. */
  const rocket = (wide: number, tall: number, right: number): Luminance =>
    noisy(240, tall + 2 * TOP, ([x, y]) => {
      const half = Math.min(wide / 2, (wide / 2) * ((y - TOP) / (tall / 5)));
      if (y > TOP && y < TOP + tall && Math.abs(x - 120) < half) return 200;
      return x < 120 ? 60 : right;
    });
  /** The outline by clicks down its left side and up its right side, and how far each path keeps from the others. */
  function outlined(luminance: Luminance, clicks: readonly Vec[]) {
    let line: readonly Vec[] = [];
    const [first] = clicks;
    let least = Number.POSITIVE_INFINITY;
    const extend = (to: Vec) => {
      const way = line.length > 0 ? finePath(luminance, line, to) : [to];
      const [start = to] = line.slice(-1);
      for (const [from, end] of edgesOf([start, ...way], false))
        for (let part = 0; part <= 1; part += 0.1) {
          const at = lerp(from, end, part);
          const isBetween = distance(at, start) > 8 && distance(at, to) > 8;
          if (isBetween && line.length > 1) least = Math.min(least, distanceToLine(line, false, at));
        }
      line = [...line, ...way];
    };
    for (const click of clicks) extend(click);
    if (first) extend(first);
    return { ring: line.slice(0, -1), least };
  }

  it.each([
    ['thin', 6, 260, 60],
    ['some pixels wide', 12, 260, 60],
    ['with a faint side', 24, 260, 150],
    ['wide', 24, 260, 60],
    ['long', 24, 1200, 110],
  ] as const)(
    'goes up the other side of a rocket that is %s, and along no edge twice',
    (_, wide, tall, right) => {
      const luminance = rocket(wide, tall, right);
      const [left, far, low, shoulder] = [120 - wide / 2, 120 + wide / 2, TOP + tall, TOP + tall / 5];
      const tip: Vec = [120, TOP];
      const ways: readonly (readonly Vec[])[] = [
        [tip, [left, low], [far, low]],
        [[left, shoulder], [left, low], [far, low], [far, shoulder], tip],
        [[left, low - tall / 2], [left, low], [far, low], [far, shoulder], tip, [left, shoulder]],
      ];
      for (const clicks of ways) {
        const { ring, least } = outlined(luminance, clicks);
        for (const click of clicks) expect(ring).toContain(click);
        expect(least).toBeGreaterThan(1);
        const whole = wide * tall * 0.9;
        expect(areaOf(ring)).toBeGreaterThan(0.8 * whole);
        expect(areaOf(ring)).toBeLessThan(1.2 * whole + 4 * tall);
      }
    },
  );

  it('is straight where no other way is left', () => {
    const around = [0, 90, 180, 270, 350, 359].map((degrees) => on(CENTRE, RADIUS, degrees));
    const box: Vec[] = [
      [100, 70],
      [200, 70],
      [200, 170],
      [100, 170],
      [100, 70.5],
      [99, 40],
    ];
    expect(finePath(picture, box, [150, 120])).toEqual([[150, 120]]);
    expect(finePath(picture, around, around[0] as Vec)).toEqual([around[0]]);
  });

  it('may end beside the outline, and at another edge than that of the outline', () => {
    const line = Array.from({ length: 19 }, (_, k) => on(CENTRE, RADIUS, 180 + 5 * k));
    const beside = on(CENTRE, RADIUS, 226);
    expect(finePath(picture, line, beside).at(-1)).toEqual(beside);
    expect(edgeNear(picture, beside, 3)).not.toEqual(beside);
    expect(edgeNear(picture, beside, 3, line)).toEqual(beside);
  });
});
