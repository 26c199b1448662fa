import { describe, expect, it } from 'vitest';
import type { Ring } from '../geometry/ring';
import { newProject } from './document';
import { ringsOf } from './domain';
import { withRingCornerAdded, withRingCornerMoved, withRingCornerRemoved } from './lasso_corners';
import type { Project } from './project';

const outer: Ring = [
  [50, 50],
  [250, 50],
  [250, 250],
  [50, 250],
];
const hole: Ring = [
  [100, 100],
  [150, 100],
  [150, 150],
  [100, 150],
];
const project: Project = {
  ...newProject({ src: 'a.jpg', width: 400, height: 300 }, null),
  domain: { kind: 'polygon', rings: [outer, hole] },
  handles: [
    { id: 'near', kind: 'point', rest: [60, 60], posed: [60, 60] },
    { id: 'far', kind: 'point', rest: [200, 200], posed: [200, 200] },
  ],
};
const first = { ring: 0, index: 0 };

describe('a corner of a lasso', () => {
  it('moves within the picture, and handles left outside go', () => {
    const moved = withRingCornerMoved(project, first, [-20, 30.123]);
    expect(moved && ringsOf(moved)[0]?.[0]).toEqual([0, 30.12]);
    const cut = withRingCornerMoved(project, first, [90, 90]);
    expect(cut?.handles.map(({ id }) => id)).toEqual(['far']);
  });
  it('stays where the outline would cross itself or a hole', () => {
    expect(withRingCornerMoved(project, first, [300, 100])).toBeNull();
    expect(withRingCornerMoved(project, first, [120, 120])).toBeNull();
    expect(withRingCornerMoved(project, { ring: 1, index: 0 }, [20, 100])).toBeNull();
  });
  it('is added on an edge, and removed', () => {
    const more = withRingCornerAdded(project, 0, { edge: 3, fraction: 0.25 });
    expect(ringsOf(more)[0]?.[4]).toEqual([50, 200]);
    const again = withRingCornerRemoved(more, { ring: 0, index: 4 });
    expect(again?.domain).toEqual(project.domain);
  });
  it('stays if too few were left, or a hole outside', () => {
    const triangle: Project = { ...project, domain: { kind: 'polygon', rings: [outer.slice(0, 3)] } };
    expect(withRingCornerRemoved(triangle, first)).toBeNull();
    expect(withRingCornerRemoved(project, { ring: 0, index: 3 })).toBeNull();
  });
});
