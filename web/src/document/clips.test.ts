import { describe, expect, it } from 'vitest';
import {
  addClip,
  clipsOf,
  freeClipName,
  lastTime,
  newClip,
  removeClip,
  timePlayed,
  withDuration,
} from './clips';
import { newProject } from './document';
import type { Clip } from './project';

const project = newProject({ src: 'a.png', width: 9, height: 9 }, null);

describe('clips', () => {
  it('get names that are free', () => {
    const one = addClip(project, newClip('clip'));
    expect([freeClipName(project, 'clip'), freeClipName(one, 'clip')]).toEqual(['clip', 'clip 2']);
    expect(freeClipName(addClip(one, newClip('clip 2')), 'clip')).toBe('clip 3');
    expect(clipsOf(removeClip(one, 'clip'))).toEqual([]);
  });

  it('restore the project without them', () => {
    const one = addClip(project, newClip('clip'));
    expect(removeClip(one, 'clip')).toEqual(project);
    expect(Object.keys(removeClip(one, 'clip'))).not.toContain('clips');
  });

  it('last at least until the last key, and an hour at most', () => {
    const clip: Clip = { ...newClip('a'), tracks: [{ handle: 'x', keys: [{ time: 0 }, { time: 1.5 }] }] };
    expect([0.2, 1.7, 1e6].map((seconds) => withDuration(clip, seconds).duration)).toEqual([1.5, 1.7, 3600]);
    expect(withDuration(newClip('b'), 0).duration).toBe(0.01);
  });

  it('end a frame before their beginning where they repeat', () => {
    const clip = { ...newClip('a'), duration: 1 };
    expect(lastTime(clip, 10)).toBeCloseTo(0.9, 12);
    expect(lastTime({ ...clip, loop: 'none' }, 10)).toBe(1);
    expect(lastTime({ ...clip, loop: 'alternate' }, 10)).toBe(1);
  });

  it('play on, back, or to their end', () => {
    const at = (loop: Clip['loop']) =>
      [0.5, 1.5, 2.5].map((seconds) =>
        timePlayed({ ...newClip('a'), duration: 1, ...(loop ? { loop } : {}) }, seconds),
      );
    expect(at('repeat')).toEqual([0.5, 0.5, 0.5]);
    expect(at('alternate')).toEqual([0.5, 0.5, 0.5]);
    expect(at('none')).toEqual([0.5, null, null]);
    expect(timePlayed({ ...newClip('a'), duration: 1, loop: 'alternate' }, 1.25)).toBe(0.75);
  });
});
