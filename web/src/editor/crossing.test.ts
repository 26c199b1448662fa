import { describe, expect, it } from 'vitest';
import { newProject, openDocument } from '../document/document';
import { moveHandles, selectHandles } from '../document/edits';
import { anchor, depthOf } from '../document/handle';
import type { PointHandle, Project } from '../document/project';
import { beginCrossing, crossed, frontDepths, withDepths, withNeededDepths } from './crossing';

const point = (id: string, x: number, depth = 0): PointHandle => ({
  id,
  kind: 'point',
  rest: [x, 0],
  posed: [x, 0],
  depth,
});

const projectOf = (...handles: readonly PointHandle[]): Project => ({
  ...newProject({ src: 'cat.png', width: 100, height: 100 }, null),
  handles,
});

/** The hand left of 0 crosses the belly. */
const leader = {
  lead({ handles }: Project): number {
    const [hand, belly] = handles;
    if (!hand || !belly || anchor(hand)[0] >= 0) return 1;
    return depthOf(hand) - depthOf(belly);
  },
};

describe('a drag that crosses another part', () => {
  const start = selectHandles(openDocument(projectOf(point('hand', 20), point('belly', 50, 2))), ['hand']);
  const behind = moveHandles(start, ['hand'], [-30, 0]);

  it('brings its handles to the front', () => {
    const crossing = crossed(beginCrossing(leader, start), leader, start, behind);
    expect(withDepths(behind, crossing).project.handles.map(depthOf)).toEqual([3, 2]);
  });

  it('decides once', () => {
    const begun = beginCrossing(leader, start);
    const free = crossed(begun, leader, start, moveHandles(start, ['hand'], [10, 0]));
    expect(free).toBe(begun);
    const decided = crossed(free, leader, start, behind);
    expect(crossed(decided, leader, start, start)).toBe(decided);
    expect(crossed(decided, leader, start, behind)).toBe(decided);
  });

  it('keeps the depth only where it ends in a crossing', () => {
    const decided = crossed(beginCrossing(leader, start), leader, start, behind);
    const [across, free] = [behind, start].map((document) => withDepths(document, decided));
    if (!across || !free) throw new Error('two documents');
    expect(withNeededDepths(across, decided, leader, start)).toBe(across);
    expect(withNeededDepths(free, decided, leader, start)).toEqual(start);
  });

  it('raises what crosses at an equal depth', () => {
    const level = { ...start, project: projectOf(point('hand', -10), point('belly', 50)) };
    const crossing = crossed(beginCrossing(leader, level), leader, level, level);
    expect(withDepths(level, crossing).project.handles.map(depthOf)).toEqual([1, 0]);
  });

  it('leaves a handle behind that was there before', () => {
    const crossing = crossed(beginCrossing(leader, behind), leader, behind, start);
    expect(withDepths(behind, crossing)).toBe(behind);
    expect(crossed(crossing, leader, behind, behind).depths.size).toBe(0);
  });

  it('leaves a handle that is being placed', () => {
    const before = { ...start, project: projectOf(point('belly', 50)) };
    expect(crossed(beginCrossing(leader, before), leader, before, behind).depths.size).toBe(0);
  });
});

describe('depths in front', () => {
  const depths = (project: Project, ...selection: readonly string[]) =>
    Object.fromEntries(frontDepths(project, selection));

  it('lie above those of all others, in the order that the selected have', () => {
    const project = projectOf(point('a', 0, 1), point('b', 0), point('c', 0, 4), point('d', 0, -2));
    expect(depths(project, 'a', 'b')).toEqual({ a: 6, b: 5 });
    expect(depths(project, 'c')).toEqual({ c: 4 });
  });

  it('are whole where others have fractions', () => {
    const project = projectOf(point('a', 0, 0.74), point('b', 0, 0.296), point('c', 0, 2.22));
    expect(depths(project, 'a')).toEqual({ a: 3 });
    expect(depths(project, 'a', 'b')).toEqual({ a: 4, b: 3 });
    expect(depths(project, 'c')).toEqual({ c: 2.22 });
  });

  it('move the others back where the front is taken', () => {
    const project = projectOf(point('a', 0, -3), point('b', 0, 10), point('c', 0, 4), point('d', 0, 10));
    expect(depths(project, 'a')).toEqual({ a: 10, b: 9, c: 8, d: 9 });
  });
});
