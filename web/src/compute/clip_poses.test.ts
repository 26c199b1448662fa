import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { handlePoses, readPoses } from '../document/handle_poses';
import type { Clip, Handle } from '../document/project';
import { createClipPoses } from './clip_poses';
import { initSync } from './generated/c2warp';

const arm: Handle = {
  id: 'arm',
  kind: 'bar',
  rest: [
    [0, 0],
    [9, 0],
  ],
  posed: [
    [0, 0],
    [9, 0],
  ],
  depth: 2,
};
const hand: Handle = { id: 'hand', kind: 'point', rest: [9, 9], posed: [9, 8], rotation: 'auto' };
const wave: Clip = {
  name: 'wave',
  duration: 2,
  loop: 'alternate',
  tracks: [
    {
      handle: 'hand',
      keys: [
        { time: 0, posed: [9, 9], scale: 1, ease: 'linear' },
        { time: 2, posed: [5, 9], scale: 3 },
      ],
    },
  ],
};

describe('poses along a clip', () => {
  beforeAll(() => {
    initSync({ module: readFileSync(new URL('./generated/c2warp_bg.wasm', import.meta.url)) });
  });

  it('have the layout of handle poses, in the order of the handles', () => {
    const poses = createClipPoses(wave, [arm, hand]);
    const moved: Handle = { ...hand, posed: [8, 9], scale: 1.5 };
    expect(poses.at(0.5)).toEqual(handlePoses([arm, moved]));
    expect(poses.at(3.5)).toEqual(poses.at(0.5));
    expect(readPoses(poses.at(9))[1]).toMatchObject({ posed: [[7, 9]], scale: 2 });
    poses.free();
  });

  it('names the key of a clip that does not fit the handles', () => {
    expect(() => createClipPoses(wave, [arm])).toThrow('tracks[0].handle: there is no handle "hand"');
    expect(() => createClipPoses({ ...wave, duration: 1 }, [hand])).toThrow('tracks[0].keys[1].time');
  });
});
