import { describe, expect, it } from 'vitest';
import { edgeWindow } from './edge_cost';
import type { Luminance } from './luminance';
import { edgeNear, edgePath, finePath, MOST_NODES } from './scissors';
import { distance, type Vec } from './vec';

/** A light disc on a dark ground, both with noise, the same in every run. */
function disc(width: number, height: number, centre: Vec, radius: number, step = 1): Luminance {
  let seed = 1;
  const noise = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return (seed / 0x7fffffff - 0.5) * 50;
  };
  const values = new Uint8Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const inside = distance([(x + 0.5) * step, (y + 0.5) * step], centre) < radius;
      values[y * width + x] = (inside ? 170 : 80) + noise();
    }
  return { width, height, values, step, coarser: null };
}

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
      const path = finePath(picture, on(CENTRE, RADIUS, from), on(CENTRE, RADIUS, to));
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
      expect(edgePath(flat, [10, 10], to)).toEqual([to]);
  });
  it('searches few nodes of a picture of any size', () => {
    const large = disc(2000, 1500, [2000, 1500], 1100, 2);
    const window = edgeWindow(large, [0, 0], [4000, 3000], MOST_NODES);
    expect(window.width * window.height).toBeLessThanOrEqual(MOST_NODES);
    const [from, to] = [10, 80].map((degrees) => on([2000, 1500], 1100, degrees)) as [Vec, Vec];
    expect(offEdge(edgePath(large, from, to), [2000, 1500], 1100)).toBeLessThan(window.pitch);
    // A path that is set is as precise as the luminance, of a pixel in two.
    const fine = finePath(large, from, to);
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
