import { describe, expect, it } from 'vitest';
import { newProject } from './document';
import { RANGES } from './generated/settings';
import type { Project } from './project';
import { type Setting, settingsOf, withPreset, withSetting } from './settings';

const fresh = newProject({ src: 'a.png', width: 8, height: 8 }, 0.5);
const bare: Project = { format: 'c2warp/1', image: fresh.image, handles: [] };

const CHANGES: readonly Setting[] = [
  { name: 'samples', value: 500 },
  { name: 'shape_factor', value: 0.3 },
  { name: 'degree', value: 9 },
  { name: 'filling', value: 'half' },
  { name: 'support', value: 'paper' },
  { name: 'continuity', value: 'c2' },
  { name: 'density', value: 7 },
  { name: 'blend', value: 'rigid' },
  { name: 'threshold', value: 0.1 },
  { name: 'loose_parts', value: 'follow' },
];

describe('the settings of a project', () => {
  it.each(CHANGES)('change one by one: $name', (setting) => {
    const changed = withSetting(fresh, setting);
    expect(settingsOf(changed)).toEqual({ ...settingsOf(fresh), [setting.name]: setting.value });
    expect(changed.pose?.mode).toBe('rigid');
  });

  it('that a file leaves out are those of the paper', () => {
    const { threshold, ...settings } = settingsOf(bare);
    expect(threshold).toBeNull();
    expect(settings).toEqual({
      samples: 10000,
      shape_factor: 1,
      degree: 5,
      filling: 'line',
      support: 'paper',
      continuity: 'exact',
      density: 0,
      blend: 'linear',
      loose_parts: 'stay',
    });
  });

  it('leave the default continuity out of the file', () => {
    const c2 = withSetting(fresh, { name: 'continuity', value: 'c2' });
    expect(c2.weighting).toEqual({ ...fresh.weighting, continuity: 'c2' });
    expect(withSetting(c2, { name: 'continuity', value: 'exact' })).toEqual(fresh);
  });

  it('have ranges with the defaults in them', () => {
    const settings = settingsOf(fresh);
    for (const name of Object.keys(RANGES) as (keyof typeof RANGES)[]) {
      const [least, most] = RANGES[name];
      expect(settings[name]).toBeGreaterThanOrEqual(least);
      expect(settings[name]).toBeLessThanOrEqual(most);
    }
  });

  it('are set together, apart from the domain', () => {
    const changed = CHANGES.reduce(withSetting, fresh);
    const paper = withPreset(changed, 'paper');
    expect(settingsOf(paper)).toEqual({ ...settingsOf(bare), threshold: 0.1, loose_parts: 'follow' });
    expect(paper.pose?.mode).toBe('harmonic');
    const kept = { threshold: 0.1, loose_parts: 'follow' } as const;
    expect(settingsOf(withPreset(paper, 'editor'))).toEqual({ ...settingsOf(fresh), ...kept });
  });
});
