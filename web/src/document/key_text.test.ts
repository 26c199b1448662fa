import { describe, expect, it } from 'vitest';
import type { PlacedKey } from './clip_keys';
import { isKeys, keysText, parseKeys } from './key_text';
import { parsePose, poseText } from './pose_text';

const keys: readonly PlacedKey[] = [
  { handle: 'head', key: { time: 0, posed: [1, 2], rotation: 'auto', ease: 'smooth' } },
  {
    handle: 'leg',
    key: {
      time: 0.5,
      posed: [
        [1, 2],
        [3, 4],
      ],
      depth: 1,
      ease: 'hold',
    },
  },
];
const text = (key: object) => JSON.stringify({ format: 'c2warp-keys/1', keys: [key] });

describe('the text of keys', () => {
  it('round-trips, with a line for each key', () => {
    expect(keysText(keys)).toMatch(
      /^\{\n {2}"format": "c2warp-keys\/1",\n {2}"keys": \[\n {4}\{"handle": "head", /,
    );
    expect(parseKeys(keysText(keys))).toEqual(keys);
    expect(parseKeys(text({ handle: 'head', time: 1 }))).toEqual([
      { handle: 'head', key: { time: 1, ease: 'smooth' } },
    ]);
  });

  it('is no pose, and a pose is no text of keys', () => {
    const pose = poseText([{ id: 'a', kind: 'point', rest: [1, 2], posed: [1, 2] }]);
    expect([isKeys(pose), parseKeys(pose), parsePose(keysText(keys))]).toEqual([false, null, null]);
    for (const other of ['', '12', 'https://example.org/c2warp-keys/1']) expect(parseKeys(other)).toBeNull();
  });

  it.each([
    [{ handle: '', time: 0 }, 'handle: expected a name'],
    [{ handle: 'a', time: -1 }, 'key of "a", time: expected seconds'],
    [{ handle: 'a', time: '1' }, 'time: expected seconds'],
    [{ handle: 'a', time: 0, ease: 'fast' }, 'ease: expected one of smooth, linear, hold'],
    [
      { handle: 'a', time: 0, rest: [0, 0] },
      'rest: unknown key; expected one of posed, rotation, scale, depth',
    ],
  ])('%j is refused: %s', (key, reason) => expect(() => parseKeys(text(key))).toThrow(reason));

  it('of another version, or cut off, is refused', () => {
    expect(() => parseKeys('{"format": "c2warp-keys/2", "keys": [1]}')).toThrow('format: expected');
    expect(() => parseKeys('{"format": "c2warp-keys/1", "keys": []}')).toThrow('keys: expected a list');
    expect(() => parseKeys(keysText(keys).slice(0, -9))).toThrow('its text is incomplete');
  });
});
