import { describe, expect, it } from 'vitest';
import { simpleRing } from '../geometry/enclosed';
import { areaOf, isInsideOf, type Ring } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import { newProject } from './document';
import { ringsOf } from './domain';
import { withPlaceAdded } from './lasso_growth';
import type { Project } from './project';

const square = (left: number, top: number, side: number): Ring => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];
const lassoed = (...rings: readonly Ring[]): Project => ({
  ...newProject({ src: 'a.jpg', width: 400, height: 300 }, null),
  domain: { kind: 'polygon', rings },
});
function grown(project: Project, at: Vec): readonly Ring[] {
  const after = withPlaceAdded(project, at);
  if (!after) throw new Error('nothing was added');
  return ringsOf(after);
}

describe('a lasso that grows', () => {
  it('includes the place with room around it, and all that it had', () => {
    const rings = grown(lassoed(square(50, 50, 100)), [220, 90]);
    expect(rings).toHaveLength(1);
    for (const at of [
      [220, 90],
      [236, 90],
      [180, 95],
      [60, 60],
      [140, 140],
    ] as const)
      expect(isInsideOf(rings, at), String(at)).toBe(true);
    expect(isInsideOf(rings, [220, 160])).toBe(false);
    expect(rings.map(simpleRing)).toEqual(rings);
  });
  it('stays inside the picture', () => {
    const corners = grown(lassoed(square(50, 50, 100)), [2, 2]).flat();
    expect(Math.min(...corners.flat())).toBe(0);
  });
  it('joins the islands on its way', () => {
    const rings = grown(lassoed(square(50, 50, 60), square(150, 50, 60)), [130, 80]);
    expect(rings).toHaveLength(1);
    expect(isInsideOf(rings, [200, 100])).toBe(true);
  });
  it('fills a hole, and keeps the others', () => {
    const project = lassoed(
      square(20, 20, 250),
      square(40, 40, 60),
      square(150, 40, 60),
      square(160, 50, 10),
    );
    const rings = grown(project, [190, 80]);
    expect(rings.map(areaOf)).toEqual([62500, 3600]);
  });
  it('refuses places that bend, places beside the picture, and work without a lasso', () => {
    expect(withPlaceAdded(lassoed(square(50, 50, 100)), [60, 60])).toBeNull();
    expect(withPlaceAdded(lassoed(square(50, 50, 100)), [-5, 60])).toBeNull();
    expect(withPlaceAdded(newProject({ src: '', width: 9, height: 9 }, null), [5, 5])).toBeNull();
  });
});
