import { describe, expect, it } from 'vitest';
import { keyCorners, trackOf } from './clip_keys';
import { addClip, newClip } from './clips';
import { type Document, fileProject, newProject, openDocument } from './document';
import { addHandle, changeHandles, removeHandles } from './edits';
import { corners, depthOf, moved, scaleOf, turnedTo } from './handle';
import { absorbed, atMoment, type PosesAt, unposed } from './moment';
import { renameHandle } from './names';
import type { Handle, PointHandle } from './project';

/** The pose of the last key. */
const lastKey: PosesAt = (clip, handles, time) =>
  handles.map((handle) => {
    const key = trackOf(clip, handle.id)?.keys.findLast((key) => key.time <= time);
    const rotation = key?.rotation ?? handle.rotation ?? 0;
    return {
      posed: key?.posed ? keyCorners(key.posed) : corners(handle),
      rotation: rotation === 'auto' ? Number.NaN : rotation,
      scale: key?.scale ?? scaleOf(handle),
      depth: key?.depth ?? depthOf(handle),
    };
  });

const point = (id: string, x: number): PointHandle => ({ id, kind: 'point', rest: [x, 0], posed: [x, 0] });
const resting = [point('a', 1), point('b', 2)].reduce(
  addHandle,
  openDocument(newProject({ src: 'a.png', width: 9, height: 9 }, null)),
);
const withClip: Document = { ...resting, project: addClip(resting.project, newClip('wave')) };
const at = (document: Document, time: number) => atMoment(document, 'wave', time, lastKey);
const drag = (document: Document, id: string, by: number) =>
  absorbed(
    document,
    changeHandles(document, [id], (handle) => moved(handle, [by, 0])),
  );
const x = (document: Document, id: string) =>
  (document.project.handles.find((handle) => handle.id === id) as Handle).posed[0];
const keysOf = (document: Document, id: string) => {
  const clip = fileProject(document).clips?.[0];
  return clip && trackOf(clip, id)?.keys;
};

describe('a document at a moment', () => {
  const begun = at(withClip, 0.5);
  const dragged = drag(begun, 'a', 3);

  it('creates a key of a pose, and one at the start if the handle had none', () => {
    expect(keysOf(dragged, 'a')).toEqual([
      { time: 0, posed: [1, 0], ease: 'smooth' },
      { time: 0.5, posed: [4, 0], ease: 'smooth' },
    ]);
    expect(keysOf(dragged, 'b')).toBeUndefined();
    expect(x(dragged, 'a')).toBe(4);
    expect(keysOf(drag(at(withClip, 0), 'a', 3), 'a')).toEqual([{ time: 0, posed: [4, 0], ease: 'smooth' }]);
  });

  it('leaves the poses of the file as they are', () => {
    expect(fileProject(dragged).handles).toEqual(resting.project.handles);
    expect(unposed(dragged).project.handles).toEqual(resting.project.handles);
    expect(x(at(dragged, 0.2), 'a')).toBe(1);
    expect(x(at(dragged, 0.7), 'a')).toBe(4);
  });

  it('keeps to the clip that it has, and is unposed without it', () => {
    expect(atMoment(dragged, 'gone', 0, lastKey).moment).toBeUndefined();
    expect(fileProject(at(dragged, 0.1))).toBe(fileProject(dragged));
  });

  it('keys turns, scales and depths once they differ, also at the start', () => {
    const turned = absorbed(
      dragged,
      changeHandles(dragged, ['a'], (handle) => ({ ...turnedTo(handle, 30), depth: 1 })),
    );
    expect(keysOf(turned, 'a')).toEqual([
      { time: 0, posed: [1, 0], rotation: 0, depth: 0, ease: 'smooth' },
      { time: 0.5, posed: [4, 0], rotation: 30, depth: 1, ease: 'smooth' },
    ]);
  });

  it('writes no depth that a drag has not changed, and keeps one that a key has', () => {
    const between: PosesAt = (clip, handles, time) =>
      lastKey(clip, handles, time).map((pose, k) => (k === 0 ? { ...pose, depth: 0.74 } : pose));
    const shown = atMoment(dragged, 'wave', 0.25, between);
    expect(keysOf(drag(shown, 'a', 1), 'a')?.map(({ depth }) => depth)).toEqual([
      undefined,
      undefined,
      undefined,
    ]);
    const raised = absorbed(
      dragged,
      changeHandles(dragged, ['a'], (handle) => ({ ...handle, depth: 2 })),
    );
    expect(keysOf(drag(at(raised, 0.5), 'a', 1), 'a')?.map(({ depth }) => depth)).toEqual([0, 2]);
  });

  it('gives the key before a risen depth where the handle is free, at any frame', () => {
    const third = drag(at(dragged, 2 / 3), 'a', 1);
    const raise = (depth: number, free: number) =>
      absorbed(
        third,
        changeHandles(third, ['a'], (handle) => ({ ...handle, depth })),
        (_, time) => time === free,
      );
    const depths = (document: Document) => keysOf(document, 'a')?.map(({ depth }) => depth);
    expect(depths(raise(1, 0.5))).toEqual([0, 1, 1]);
    expect(depths(raise(1, 0))).toEqual([0, undefined, 1]);
    expect(depths(raise(-1, 0.5))).toEqual([0, undefined, -1]);
  });

  it('adds, renames and removes handles in the file too', () => {
    const added = absorbed(dragged, addHandle(dragged, point('c', 5)));
    expect(fileProject(added).handles.map(({ id }) => id)).toEqual(['a', 'b', 'c']);
    const renamed = absorbed(added, renameHandle(added, 'a', 'paw'));
    expect(fileProject(renamed).handles[0]).toEqual({ ...point('paw', 1) });
    expect(keysOf(renamed, 'paw')).toHaveLength(2);
    const removed = absorbed(renamed, removeHandles(renamed, ['paw']));
    expect(keysOf(removed, 'paw')).toBeUndefined();
    expect(fileProject(removed).handles.map(({ id }) => id)).toEqual(['b', 'c']);
  });

  it('keeps the pose of a held handle while time passes', () => {
    const held = changeHandles(begun, ['a'], (handle) => moved(handle, [2, 0]));
    expect(x(atMoment(held, 'wave', 0.6, lastKey, ['a']), 'a')).toBe(3);
    expect(x(atMoment(held, 'wave', 0.6, lastKey), 'a')).toBe(1);
  });
});
