import { describe, expect, it } from 'vitest';
import { newProject } from './document';
import type { PointHandle } from './project';
import { VARIANTS, variantOf } from './variants';

const hand: PointHandle = { id: 'hand', kind: 'point', rest: [2, 2], posed: [4, 2], rotation: 'auto' };
const project = { ...newProject({ src: 'a.png', width: 8, height: 8 }, 0.5), handles: [hand] };

describe('the variants of a project', () => {
  it('have the same handles in the same places', () => {
    for (const variant of VARIANTS) {
      const [handle] = variantOf(project, variant).handles;
      expect(handle).toMatchObject({ id: 'hand', rest: [2, 2], posed: [4, 2] });
    }
  });

  it('differ in mode and in distance', () => {
    expect(variantOf(project, 'rigid')).toBe(project);
    expect(variantOf(project, 'paper')).toMatchObject({ pose: { mode: 'harmonic' }, domain: project.domain });
    expect(variantOf(project, 'plain')).toMatchObject({
      pose: { mode: 'harmonic' },
      domain: { kind: 'image' },
    });
  });
});
