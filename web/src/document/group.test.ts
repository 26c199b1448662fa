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

describe('several handles as one', () => {
  it('turn about the centre of their places, which stays', () => {
    const after = selectedHandles(transformGroup(before, 90));
    // A quarter clockwise takes (x, y) from the centre to (−y, x).
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

  it('add the turn to rotations that are set, whole turns too, and leave those that are not', () => {
    const after = selectedHandles(transformGroup(transformGroup(before, 200), 200));
    // Rounded corners tell the angle, to some hundredths of a degree.
    const turned = expect.closeTo(400, 1);
    expect(after.map(({ rotation }) => rotation)).toEqual([570, 'auto', turned, turned]);
    expect(after.map(scaleOf)).toEqual([1, 1, 1, 1]);
  });

  it('grow about that centre, each handle’s scale with its place, and are not turned', () => {
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

  it('grow no further than the scale of each of them may', () => {
    const large = changeHandles(before, ['free'], (handle) => ({ ...handle, scale: 50 }));
    expect(selectedHandles(transformGroup(large, 0, 9)).map(scaleOf)).toEqual([2, 100, 2, 2]);
    expect(selectedHandles(transformGroup(large, 0, -3)).map(scaleOf)).toEqual([0.01, 0.5, 0.01, 0.01]);
    // What a page has made larger than a person may stays as it is.
    const huge = changeHandles(before, ['free'], (handle) => ({ ...handle, scale: 1000 }));
    expect(transformGroup(huge, 0, 2).project).toEqual(huge.project);
  });

  it('lose no small step of a small scale to rounding', () => {
    let small = transformGroup(before, 0, 0.1);
    for (let step = 0; step < 10; step++) small = transformGroup(small, 0, 1.01);
    expect(selectedHandles(small).map(scaleOf)).toEqual(
      handles.map(() => expect.closeTo(0.1 * 1.01 ** 10, 3)),
    );
  });

  it('are as one turned by what their places tell, whatever each is turned', () => {
    const own = changeHandles(before, all, (handle) => turnedTo(handle, 30));
    expect(groupTurn(selectedHandles(own))).toBeCloseTo(0);
    const apart = changeHandles(transformGroup(own, 40), ['free'], withAutoRotation);
    expect(groupTurn(selectedHandles(apart))).toBeCloseTo(40, 1);
  });

  it('are turned as their corners are where their places are one, or as the first of them', () => {
    const [middle, other] = [point('middle', [40, 20]), point('other', [40, 20], 25)];
    const turned = (...handles: readonly Handle[]) =>
      groupTurn(handles.map((handle) => turnedAbout(handle, [40, 20], 45, 1)));
    expect(turned(polygon, middle)).toBeCloseTo(45, 1);
    expect(turned(middle, other)).toBe(45);
  });
});
