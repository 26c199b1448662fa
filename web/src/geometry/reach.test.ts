import { describe, expect, it } from 'vitest';
import type { Blend } from './blend';
import { type MovedMotions, reachOf } from './reach';
import { MOTION_STRIDE, type Skin } from './skin';
import { scaled, type Vec } from './vec';

const STEP = 2;

/** A row of vertices from (0, 0) to (10, 0), whose weights go over from a site at its beginning to one at its end. */
const row: Skin = {
  positions: Float32Array.from({ length: 22 }, (_, at) => (at % 2 === 0 ? at / 2 : 0)),
  triangles: new Uint32Array(),
  offsets: Uint32Array.from({ length: 12 }, (_, vertex) => 2 * vertex),
  sites: Uint32Array.from({ length: 22 }, (_, entry) => entry % 2),
  weights: Float32Array.from({ length: 22 }, (_, entry) => {
    const vertex = Math.floor(entry / 2);
    return (entry % 2 === 0 ? 10 - vertex : vertex) / 10;
  }),
};

/** The motion of a site that rests at `rest`, turned, and moved by so much. */
function motion(rest: Vec, by: Vec, angle = 0): number[] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const linear = [cos, sin, -sin, cos];
  return [
    ...linear,
    ...rest,
    rest[0] + by[0],
    rest[1] + by[1],
    0,
    angle,
    Math.cos(angle / 2),
    Math.sin(angle / 2),
  ];
}

/** Both sites as they follow a move. */
const moved = (sites: (by: Vec) => readonly [number[], number[]]): MovedMotions => {
  const along = (by: Vec) => Float32Array.from(sites(scaled(by, STEP)).flat());
  return [along([1, 0]), along([-1, 0]), along([0, 1]), along([0, -1])];
};

describe.each(['linear', 'rigid'] as const satisfies Blend[])('the reach, by the %s blend', (blend) => {
  it('is 1 everywhere where all goes along, however it is posed', () => {
    const all = moved((by) => [motion([0, 0], by, 0.7), motion([10, 0], by, 0.7)]);
    expect(all[0]).toHaveLength(2 * MOTION_STRIDE);
    for (const reach of reachOf(row, all, STEP, blend)) expect(reach).toBeCloseTo(1, 4);
  });

  it('is 1 at what is moved and 0 at what is not, and falls from one to the other', () => {
    const reach = reachOf(
      row,
      moved((by) => [motion([0, 0], by), motion([10, 0], [0, 0])]),
      STEP,
      blend,
    );
    reach.forEach((value, vertex) => {
      expect(value).toBeCloseTo(1 - vertex / 10, 4);
    });
  });

  it('is the same for moves in turned directions, and half as much for half a move', () => {
    const turned = (by: Vec): Vec => [-by[1], by[0]];
    const reach = (first: (by: Vec) => Vec) =>
      reachOf(
        row,
        moved((by) => [motion([0, 0], first(by), 0.3), motion([10, 0], [0, 0], -0.4)]),
        STEP,
        blend,
      );
    const straight = reach((by) => by);
    reach(turned).forEach((value, vertex) => {
      expect(value).toBeCloseTo(straight[vertex] ?? 0, 4);
    });
    reach((by) => scaled(by, 0.5)).forEach((value, vertex) => {
      expect(value).toBeCloseTo((straight[vertex] ?? 0) / 2, 4);
    });
  });
});

it('is 0 at a vertex without sites', () => {
  const alone: Skin = { ...row, positions: Float32Array.of(3, 4), offsets: Uint32Array.of(0, 0) };
  const all = moved((by) => [motion([0, 0], by), motion([10, 0], by)]);
  expect([...reachOf(alone, all, STEP, 'linear')]).toEqual([0]);
});
