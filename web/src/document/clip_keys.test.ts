import { describe, expect, it } from 'vitest';
import type { Vec } from '../geometry/vec';
import { allowedMove, easeKeys, keyBeside, keyOf, keysAt, moveKeys, putKeys, removeKeys } from './clip_keys';
import { straightBar } from './fixtures';
import type { Clip, Key, PointHandle } from './project';

const key = (time: number, x = 0): Key => ({ time, posed: [x, 0] });
const clip: Clip = {
  name: 'wave',
  duration: 2,
  tracks: [
    { handle: 'a', keys: [key(0), key(1, 5), key(1.5, 2)] },
    { handle: 'b', keys: [key(0.5)] },
  ],
};
const times = ({ tracks }: Clip) =>
  Object.fromEntries(tracks.map(({ handle, keys }) => [handle, keys.map(({ time }) => time)]));

describe('keys', () => {
  it('are put in their order, in the place of those at the same time', () => {
    const placed = putKeys(clip, [
      { handle: 'a', key: key(0.5, 1) },
      { handle: 'a', key: key(1 + 1e-9, 9) },
      { handle: 'c', key: key(0) },
    ]);
    expect(times(placed)).toEqual({ a: [0, 0.5, 1 + 1e-9, 1.5], b: [0.5], c: [0] });
    expect(placed.tracks[0]?.keys[2]?.posed).toEqual([9, 0]);
  });

  it('are removed, and tracks without keys with them', () => {
    const removed = removeKeys(clip, [
      { handle: 'a', time: 1 },
      { handle: 'b', time: 0.5 },
    ]);
    expect(times(removed)).toEqual({ a: [0, 1.5] });
  });

  it('are moved together, as far as all of them stay within the clip', () => {
    const refs = [
      { handle: 'a', time: 1.5 },
      { handle: 'b', time: 0.5 },
    ];
    expect(times(moveKeys(clip, refs, 0.25).clip)).toEqual({ a: [0, 1, 1.75], b: [0.75] });
    expect(allowedMove(clip, refs, 9)).toBe(0.5);
    expect(allowedMove(clip, refs, -9)).toBe(-0.5);
    const moved = moveKeys(clip, refs, -9);
    // The key at 1 is replaced by the one that came from 1.5.
    expect(times(moved.clip)).toEqual({ a: [0, 1], b: [0] });
    expect(moved.refs.map(({ time }) => time)).toEqual([1, 0]);
    expect(moveKeys(clip, [], 1).clip).toBe(clip);
  });

  it('keep the order of their choice when they move', () => {
    const refs = [
      { handle: 'b', time: 0.5 },
      { handle: 'a', time: 1 },
    ];
    expect(moveKeys(clip, refs, 0.1).refs).toEqual([
      { handle: 'b', time: 0.6 },
      { handle: 'a', time: 1.1 },
    ]);
  });

  it('lie beside one another in time, and in the rows above and below that have keys', () => {
    const rows = ['a', 'empty', 'b'];
    const from = (handle: string, time: number, by: Vec) => keyBeside(clip, rows, { handle, time }, by);
    expect(from('a', 1, [1, 0])).toEqual({ handle: 'a', time: 1.5 });
    expect(from('a', 1, [-1, 0])).toEqual({ handle: 'a', time: 0 });
    expect(from('a', 1.5, [1, 0])).toBeNull();
    expect(from('a', 1.5, [0, 1])).toEqual({ handle: 'b', time: 0.5 });
    expect(from('b', 0.5, [0, 1])).toBeNull();
    expect(from('b', 0.7, [0, -1])).toEqual({ handle: 'a', time: 1 });
    expect(from('a', 0, [0, -1])).toBeNull();
  });

  it('take an ease for the stretch that follows', () => {
    const eased = easeKeys(clip, [{ handle: 'a', time: 1 }], 'hold');
    expect(keysAt(eased, [{ handle: 'a', time: 1 }])).toEqual([
      { handle: 'a', key: { ...key(1, 5), ease: 'hold' } },
    ]);
  });

  it('hold the corners of a handle, and the requested values', () => {
    const point: PointHandle = { id: 'a', kind: 'point', rest: [1, 2], posed: [3, 4], scale: 2 };
    expect(keyOf(point, 1 / 3, [])).toEqual({ time: 0.33333, posed: [3, 4], ease: 'smooth' });
    expect(keyOf(point, 0, ['rotation', 'scale', 'depth'])).toEqual({
      time: 0,
      posed: [3, 4],
      rotation: 0,
      scale: 2,
      depth: 0,
      ease: 'smooth',
    });
    expect(keyOf(straightBar(4), 0, ['rotation'])).toMatchObject({
      posed: straightBar(4).posed,
      rotation: 'auto',
    });
  });
});
