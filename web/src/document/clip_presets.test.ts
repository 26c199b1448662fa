import { describe, expect, it } from 'vitest';
import { CLIP_PRESETS, presetClip } from './clip_presets';
import { newProject } from './document';
import { straightBar } from './fixtures';
import type { Handle, PointHandle } from './project';

const point = (id: string, x: number, y: number): PointHandle => ({
  id,
  kind: 'point',
  rest: [x, y],
  posed: [x, y],
  rotation: 'auto',
});
const figure = [
  point('head', 50, 10),
  point('left-hand', 10, 40),
  point('right-hand', 90, 40),
  point('left-foot', 40, 95),
  point('right-foot', 60, 95),
];
const projectOf = (handles: readonly Handle[]) => ({
  ...newProject({ src: 'a.png', width: 100, height: 100 }, null),
  handles,
});

describe('a preset', () => {
  const project = projectOf(figure);
  const tracks = (preset: (typeof CLIP_PRESETS)[number], selection: readonly string[] = []) =>
    presetClip(project, preset, selection).tracks.map(({ handle }) => handle);

  it('moves the free part, and keeps its base in place', () => {
    expect(tracks('sway')).toEqual(['head', 'left-hand', 'right-hand']);
    expect(tracks('breathe')).toEqual(['head', 'left-hand', 'right-hand']);
  });

  it('waves the selected handles, or else the highest and outermost one', () => {
    expect(tracks('wave', ['right-hand'])).toEqual(['right-hand']);
    expect(tracks('wave')).toEqual(['left-hand']);
  });

  it.each(CLIP_PRESETS)('is a clip of any handles, that ends where it begins: %s', (preset) => {
    for (const handles of [
      figure,
      figure.slice(0, 1),
      [straightBar(50)],
      [figure[0] as Handle, straightBar(9)],
    ]) {
      const clip = presetClip(projectOf(handles), preset, []);
      expect(clip.tracks.length).toBeGreaterThan(0);
      for (const { handle, keys } of clip.tracks) {
        const own = handles.find(({ id }) => id === handle);
        expect(keys[0]).toMatchObject({ time: 0, posed: own?.posed });
        expect(keys.every(({ time }, k) => time < clip.duration && time > (keys[k - 1]?.time ?? -1))).toBe(
          true,
        );
      }
    }
  });

  it('gets a name that is free', () => {
    const first = presetClip(project, 'wave', []);
    expect(presetClip({ ...project, clips: [first] }, 'wave', []).name).toBe('wave 2');
  });
});
