import { describe, expect, it } from 'vitest';
import type { Vec } from '../geometry/vec';
import { newProject, openDocument, selectedHandles } from './document';
import { addHandle, changeHandles, selectHandles } from './edits';
import { straightBar } from './fixtures';
import { groupCentre, groupSpan, groupTurn, transformGroup } from './group';
import { anchor, scaleOf, turnedAbout, turnedTo, withAutoRotation } from './handle';
import type { Handle, Rotation } from './project';

const point = (id: string, at: Vec, rotation: Rotation = 0): Handle => ({
  id,
  kind: 'point',
  rest: at,
  posed: at,
  rotation,
});
const square: readonly Vec[] = [
  [30, 10],
  [50, 10],
  [50, 30],
  [30, 30],
];
const polygon: Handle = { id: 'belly', kind: 'polygon', rest: square, posed: square };
const handles = [point('set', [-10, 0], 170), point('free', [10, 20], 'auto'), straightBar(20), polygon];
const all = handles.map(({ id }) => id);
/** Their anchors are (−10, 0), (10, 20), (10, 0) and (40, 20). */
const before = selectHandles(
  handles.reduce(addHandle, openDocument(newProject({ src: '', width: 64, height: 64 }, null))),
  all,
);
const pivot: Vec = [12.5, 10];

describe('the group transform', () => {
  it('turns handles about their centre, which stays', () => {
    const after = selectedHandles(transformGroup(before, 90));
    // A quarter turn clockwise maps (x, y), relative to the centre, to (−y, x).
    expect(after.map((handle) => anchor(handle))).toEqual([
      [22.5, -12.5],
      [2.5, 7.5],
      [22.5, 7.5],
      [2.5, 37.5],
    ]);
    expect(groupCentre(after)).toEqual(pivot);
    expect(groupTurn(after)).toBeCloseTo(90);
    expect(groupSpan(after)).toBeCloseTo(groupSpan(handles));
  });

  it('adds the turn to numeric rotations and keeps automatic ones', () => {
    const after = selectedHandles(transformGroup(transformGroup(before, 200), 200));
    // Corners are rounded, so their angle is exact to some hundredths of a degree.
    const turned = expect.closeTo(400, 1);
    expect(after.map(({ rotation }) => rotation)).toEqual([570, 'auto', turned, turned]);
    expect(after.map(scaleOf)).toEqual([1, 1, 1, 1]);
  });

  it('scales positions and handles about the centre, without a turn', () => {
    const larger = changeHandles(before, ['set'], (handle) => ({ ...handle, scale: 0.5 }));
    const after = selectedHandles(transformGroup(larger, 0, 2));
    expect(after.map((handle) => anchor(handle))).toEqual([
      [-32.5, -10],
      [7.5, 30],
      [7.5, -10],
      [67.5, 30],
    ]);
    expect(after.map(scaleOf)).toEqual([1, 2, 2, 2]);
    expect(after.map(({ rotation }) => rotation)).toEqual([170, 'auto', 'auto', undefined]);
    expect(groupCentre(after)).toEqual(pivot);
  });

  it('keeps the scales of all handles in range', () => {
    const large = changeHandles(before, ['free'], (handle) => ({ ...handle, scale: 50 }));
    expect(selectedHandles(transformGroup(large, 0, 9)).map(scaleOf)).toEqual([2, 100, 2, 2]);
    expect(selectedHandles(transformGroup(large, 0, -3)).map(scaleOf)).toEqual([0.01, 0.5, 0.01, 0.01]);
    // A scale beyond the range, which a page can set, stays.
    const huge = changeHandles(before, ['free'], (handle) => ({ ...handle, scale: 1000 }));
    expect(transformGroup(huge, 0, 2).project).toEqual(huge.project);
  });

  it('keeps small steps of a small scale in spite of rounding', () => {
    let small = transformGroup(before, 0, 0.1);
    for (let step = 0; step < 10; step++) small = transformGroup(small, 0, 1.01);
    expect(selectedHandles(small).map(scaleOf)).toEqual(
      handles.map(() => expect.closeTo(0.1 * 1.01 ** 10, 3)),
    );
  });

  it('has the turn of the anchors, not of the handles', () => {
    const own = changeHandles(before, all, (handle) => turnedTo(handle, 30));
    expect(groupTurn(selectedHandles(own))).toBeCloseTo(0);
    const apart = changeHandles(transformGroup(own, 40), ['free'], withAutoRotation);
    expect(groupTurn(selectedHandles(apart))).toBeCloseTo(40, 1);
  });

  it('has the turn of the corners, or of the first handle, if anchors coincide', () => {
    const [middle, other] = [point('middle', [40, 20]), point('other', [40, 20], 25)];
    const turned = (...handles: readonly Handle[]) =>
      groupTurn(handles.map((handle) => turnedAbout(handle, [40, 20], 45, 1)));
    expect(turned(polygon, middle)).toBeCloseTo(45, 1);
    expect(turned(middle, other)).toBe(45);
  });
});
