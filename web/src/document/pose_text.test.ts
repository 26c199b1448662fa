import { describe, expect, it } from 'vitest';
import { newProject, openDocument } from './document';
import { pastePose, selectHandles } from './edits';
import { straightBar } from './fixtures';
import { parsePose, poseText } from './pose_text';
import type { Handle, PointHandle } from './project';
import { projectText } from './project_text';

const point = (id: string, x: number, pose: Partial<PointHandle> = {}): PointHandle => ({
  id,
  kind: 'point',
  rest: [x, 0],
  posed: [x, 0],
  ...pose,
});
const head = point('head', 5, { posed: [7, 9], rotation: 'auto', scale: 2, depth: -1 });
const image = { src: '', width: 100, height: 100 };

describe('the text of a pose', () => {
  it('round-trips, with one line per handle', () => {
    const text = poseText([head, straightBar(10)]);
    expect(text).toMatch(
      /^\{\n {2}"format": "c2warp-pose\/1",\n {2}"handles": \[\n {4}\{"id": "head", .*\},\n/,
    );
    expect(parsePose(text)).toEqual([head, straightBar(10)]);
    expect(parsePose(JSON.stringify(JSON.parse(text)))).toEqual([head, straightBar(10)]);
  });

  it('can omit the pose of handles at rest', () => {
    const text = '{"handles": [{"id": "a", "kind": "point", "rest": [1, 2]}], "format": "c2warp-pose/1"}';
    expect(parsePose(text)).toEqual([{ id: 'a', kind: 'point', rest: [1, 2], posed: [1, 2] }]);
  });

  it.each([
    '',
    'c2warp-pose/1',
    '{"format": "other"}',
    'see {"format": "c2warp-pose/1"}',
    projectText(newProject(image, null)),
  ])('differs from other texts: %s', (text) => {
    expect(parsePose(text)).toBeNull();
  });

  it.each([
    [poseText([head]).slice(0, -9), 'its text is incomplete'],
    ['{"format": "c2warp-pose/2", "handles": []}', 'format: expected "c2warp-pose/1"'],
    ['{"format": "c2warp-pose/1"}', 'handles: expected a list'],
    ['{"format": "c2warp-pose/1", "handles": []}', 'handles: expected a list'],
    ['{"format": "c2warp-pose/1", "handles": [null]}', 'id: expected a name'],
    [poseText([head]).replace('point', 'circle'), 'handle "head", kind: expected'],
    [poseText([head]).replace('[7, 9]', '[7]'), 'handle "head", posed: expected'],
  ])('is rejected with the reason: %s', (text, message) => {
    expect(() => parsePose(text)).toThrow(RangeError);
    expect(() => parsePose(text)).toThrow(message);
  });
});

describe('pasting a pose', () => {
  const pasted = (handles: readonly Handle[], selection: readonly string[], copied: readonly Handle[]) => {
    const document = openDocument({ ...newProject(image, null), handles });
    const { document: after, unmatched } = pastePose(selectHandles(document, selection), copied);
    expect(after.selection).toEqual(selection);
    return { handles: after.project.handles, left: unmatched.map(({ id }) => id) };
  };

  it('moves the handle of the same id by the same vector from rest', () => {
    const { handles, left } = pasted([point('head', 6), point('hand', 50)], [], [head]);
    expect(handles).toEqual([{ ...head, rest: [6, 0], posed: [8, 9] }, point('hand', 50)]);
    expect(left).toEqual([]);
  });

  it('returns copied handles without a handle of the same id and kind', () => {
    const before = [{ ...straightBar(10), id: 'head' }, point('hand', 50)];
    const { handles, left } = pasted(
      before,
      ['hand'],
      [head, point('hand', 50, { posed: [51, 1] }), point('x', 1)],
    );
    expect(handles).toEqual([before[0], { ...point('hand', 50), posed: [51, 1] }]);
    expect(left).toEqual(['head', 'x']);
  });

  it('of one handle poses the selected handles of its kind', () => {
    const before = [point('head', 5), point('hand', 50), straightBar(10)];
    const { handles } = pasted(before, ['hand', 'arm'], [head]);
    expect(handles).toEqual([before[0], { ...head, id: 'hand', rest: [50, 0], posed: [52, 9] }, before[2]]);
    expect(pasted(before, ['arm'], [head]).handles).toEqual([head, ...before.slice(1)]);
  });

  it('throws if the result is out of range', () => {
    const far = point('head', -9e11, { posed: [9e11, 0] });
    for (const selection of [[], ['head']])
      expect(() => pasted([point('head', 5)], selection, [far])).toThrow(
        'handle "head", posed: expected a point',
      );
  });

  it('bends a bar with more corners than the copied one', () => {
    const bent = straightBar(10);
    const copied = {
      ...bent,
      posed: [
        [0, 0],
        [0, 10],
      ] as const,
      scale: 1,
    };
    const line = [
      [0, 0],
      [5, 0],
      [10, 0],
    ] as const;
    const { handles } = pasted([{ ...bent, rest: line, posed: line }], [], [copied]);
    expect(handles[0]?.posed).toEqual([
      [0, 0],
      [0, 5],
      [0, 10],
    ]);
  });
});
