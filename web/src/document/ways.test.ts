import { describe, expect, it } from 'vitest';
import { newProject } from './document';
import { straightBar } from './fixtures';
import { turnedTo } from './handle';
import { handlePoses, readPoses } from './handle_poses';
import type { Handle, Project } from './project';
import { groupWay, handleWay } from './ways';

const point = (id: string, x: number, more: Partial<Handle> = {}): Handle =>
  ({ id, kind: 'point', rest: [id.charCodeAt(0), 0], posed: [x, 0], ...more }) as Handle;
const holding = (...handles: readonly Handle[]): Project => ({
  ...newProject({ src: '', width: 8, height: 8 }, null),
  handles,
});

describe('the array of poses', () => {
  it('has the corners, rotation, scale and depth of each handle', () => {
    const bar = { ...straightBar(10), scale: 2, depth: 1 };
    expect([...handlePoses([point('a', 3, { rotation: 'auto' }), bar])]).toEqual([
      ...[1, Number.NaN, 1, 0, 3, 0],
      ...[2, Number.NaN, 2, 1, 0, 0, 10, 0],
    ]);
    expect(readPoses(handlePoses([bar]))).toEqual([
      { posed: bar.posed, rotation: Number.NaN, scale: 2, depth: 1 },
    ]);
  });
});

describe('the path of handles', () => {
  const solved = holding(point('a', 0), point('b', 0));

  it('has the solved handles first, then those that are not solved yet', () => {
    const to = holding(point('new', 7), point('b', 5));
    const way = handleWay(solved, holding(point('b', 1), point('new', 2)), to, new Map());
    const x = (poses: Float64Array) => readPoses(poses).map(({ posed }) => posed[0]?.[0]);
    expect(x(way.from)).toEqual([0, 1, 2]);
    expect(x(way.to)).toEqual([0, 5, 7]);
  });

  it('has the turns of bars by their corners, and of automatic points as given', () => {
    const bar = straightBar(10);
    const from = holding(bar, point('a', 0, { rotation: 'auto' }));
    const to = holding(turnedTo(bar, 90), point('a', 0, { rotation: 40 }));
    const { turns } = handleWay(from, from, to, new Map([['a', 20]]));
    expect([...turns].map(Math.round)).toEqual([0, 90, 1, 20, 40, 1]);
  });

  it('writes poses back, and keeps handles that did not move', () => {
    const to = holding(point('new', 7), point('b', 5));
    const way = handleWay(solved, to, to, new Map());
    expect(way.apply(way.to)).toEqual(to);
    expect(way.apply(way.to).handles[0]).toBe(to.handles[0]);
    const poses = way.to.slice();
    // The x of `b`, the second of three points.
    poses[6 + 4] = 3;
    expect(way.apply(poses).handles).toEqual([point('new', 7), point('b', 3)]);
  });
});

describe('the path of a group', () => {
  it('has the members before the transform, and the range of the scale', () => {
    const origin = holding(point('a', 0, { scale: 50 }), point('b', 10), point('c', 99));
    const to = holding(point('a', 10), point('b', 0), point('c', 98));
    const way = groupWay(origin, origin, ['a', 'b'], to);
    expect([...way.members]).toEqual([0, 1]);
    expect(readPoses(way.origins).map(({ posed }) => posed[0]?.[0])).toEqual([0, 10]);
    expect(way.pivot).toEqual([5, 0]);
    expect(way.scales).toEqual([0.01, 2]);
    const [a, , c] = way.apply(way.to).handles;
    expect(a).toEqual(point('a', 10, { scale: 1 }));
    expect(c).toBe(to.handles[2]);
  });
});
