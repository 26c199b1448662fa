import { describe, expect, it } from 'vitest';
import { withMode } from './bending';
import { type Document, newProject, openDocument } from './document';
import {
  addCorner,
  addHandle,
  changeHandles,
  freeId,
  holdBoundary,
  moveHandles,
  putCorner,
  putHandles,
  raiseHandles,
  removeCorner,
  removeHandles,
  resetHandles,
  selectHandles,
  turnHandles,
} from './edits';
import { straightBar } from './fixtures';
import { depthOf, isAtRest, nameOf, rotationOf, scaledTo } from './handle';
import type { BarHandle, PointHandle } from './project';
import { followedHandles, solveKey } from './solved';

const handle = (id: string, x = 0): PointHandle => ({ id, kind: 'point', rest: [x, 0], posed: [x, 0] });
const image = { src: 'a.png', width: 8, height: 8 };
const empty = openDocument(newProject(image, 0.5));
const two: Document = addHandle(addHandle(empty, handle('left-hand')), handle('b', 5));

describe('edits', () => {
  it('replaces handles with the same ids and adds none', () => {
    const put = putHandles(two, [handle('b', 7), handle('c')]);
    expect(put.project.handles).toEqual([handle('left-hand'), handle('b', 7)]);
    expect(put.selection).toEqual(two.selection);
  });

  it('write no defaults that the file leaves out', () => {
    const raised = raiseHandles(two, ['b'], 2);
    expect(raised.project.handles[1]).toEqual({ ...handle('b', 5), depth: 2 });
    expect(raiseHandles(raised, ['b'], -2).project.handles[1]).toHaveProperty('depth', 0);
    const same = putHandles(two, [
      { ...handle('b', 5), depth: 0, rotation: 0, scale: 1, stiffness: 0 } as PointHandle,
    ]);
    expect(JSON.stringify(same)).toBe(JSON.stringify(two));
    expect(resetHandles(two, ['b']).project.handles[1]).toEqual({ ...handle('b', 5), rotation: 'auto' });
  });

  it('moves, turns and resets handles', () => {
    const moved = moveHandles(two, ['b'], [1.004, 2]);
    expect(moved.project.handles[1]?.posed).toEqual([6, 2]);
    expect(moved.project.handles[0]).toBe(two.project.handles[0]);
    const turned = turnHandles(moved, ['b'], () => 200);
    expect(turned.project.handles.map((h) => rotationOf(h))).toEqual([0, 200]);
    expect(resetHandles(turned, ['b']).project.handles.every(isAtRest)).toBe(true);
  });

  it('resets points to automatic rotation in rigid mode, to 0 in harmonic mode', () => {
    const rotation = (document: Document) => resetHandles(document, ['b']).project.handles[1]?.rotation;
    const turned = turnHandles(two, ['b'], () => 20);
    expect(rotation(turned)).toBe('auto');
    expect(rotation({ ...turned, project: withMode(turned.project, 'harmonic') })).toBe(0);
  });

  it('selects added handles and deselects removed ones', () => {
    expect(two.selection).toEqual(['b']);
    expect(removeHandles(two, ['b']).selection).toEqual([]);
    expect(selectHandles(two, ['b', 'b', 'gone']).selection).toEqual(['b']);
  });

  it('returns free ids, and names for ids', () => {
    expect(freeId(two.project)).toBe('handle-1');
    expect(freeId(addHandle(empty, handle('handle-2')).project)).toBe('handle-3');
    expect(nameOf(handle('left-hand'))).toBe('left hand');
  });
});

describe('bars and polygons', () => {
  const bar = straightBar(10);
  const held = addHandle(empty, bar);
  const arm = (document: Document) => document.project.handles[0] as BarHandle;

  it('get a corner at the same fraction at rest and posed, and lose it', () => {
    const pulled = putCorner(held, 'arm', 1, [0, 40]);
    const divided = addCorner(pulled, 'arm', { edge: 0, fraction: 0.25 });
    expect(arm(divided)).toMatchObject({
      rest: [
        [0, 0],
        [2.5, 0],
        [10, 0],
      ],
      posed: [
        [0, 0],
        [0, 10],
        [0, 40],
      ],
    });
    expect(rotationOf(arm(divided))).toBeCloseTo(90);
    expect(removeCorner(divided, 'arm', 1)).toEqual(pulled);
  });

  it('are scaled about their middle in length too', () => {
    const twice = changeHandles(held, ['arm'], (handle) => scaledTo(handle, 2));
    expect(arm(twice)).toMatchObject({
      scale: 2,
      posed: [
        [-5, 0],
        [15, 0],
      ],
    });
    expect(changeHandles(twice, ['arm'], (handle) => scaledTo(handle, 1)).project.handles[0]?.posed).toEqual(
      bar.posed,
    );
  });

  it('return exactly from a scale that was rounded', () => {
    const scaled = (document: Document, by: number) =>
      changeHandles(document, ['arm'], (handle) => scaledTo(handle, by));
    expect(arm(scaled(scaled(held, 1.504), 1)).posed).toEqual(bar.posed);
    expect(arm(scaled(held, 1.504))).toMatchObject({
      scale: 1.5,
      posed: [
        [-2.5, 0],
        [12.5, 0],
      ],
    });
  });

  it('can get a corner on the closing edge', () => {
    const around = [
      [0, 0],
      [8, 0],
      [0, 8],
    ] as const;
    const ring = addHandle(empty, { id: 'ring', kind: 'polygon', rest: around, posed: around });
    const [divided] = addCorner(ring, 'ring', { edge: 2, fraction: 0.5 }).project.handles;
    expect(divided?.posed).toEqual([...around, [0, 4]]);
  });

  it('turn about their middle by several turns, and reset to rest', () => {
    const turned = turnHandles(held, ['arm'], () => 450);
    expect(arm(turned)).toMatchObject({ rotation: 450 });
    expect(arm(turned).posed).toEqual([
      [5, -5],
      [5, 5],
    ]);
    expect(rotationOf(arm(turnHandles(turned, ['arm'], () => 460)))).toBeCloseTo(460, 0);
    expect(arm(resetHandles(turned, ['arm']))).toEqual(bar);
  });

  it('turn with their corners, past half a turn', () => {
    const half = putCorner(held, 'arm', 1, [-10, 0.01]);
    expect(arm(half).rotation).toBe('auto');
    const more = putCorner(half, 'arm', 1, [-10, -5], rotationOf(arm(half)));
    expect(arm(more).rotation).toBeCloseTo(206.57, 1);
    expect(withMode(held.project, 'harmonic').handles[0]?.rotation).toBe('auto');
  });

  it('get ids of their kind', () => {
    expect(freeId(held.project, 'polygon')).toBe('polygon-1');
  });
});

describe('depth and boundary', () => {
  it('are settings of a handle and of the project', () => {
    const raised = raiseHandles(raiseHandles(two, ['b'], 9), ['b'], 4);
    expect(raised.project.handles.map(depthOf)).toEqual([0, 10]);
    expect(depthOf(raiseHandles(raised, ['b'], -40).project.handles[1] as PointHandle)).toBe(-10);
    expect(holdBoundary(two, true).project.fix_boundary).toBe(true);
  });

  it('depth needs no new solution, a fixed boundary does', () => {
    const key = solveKey(two.project);
    expect(solveKey(raiseHandles(two, ['b'], 1).project)).toBe(key);
    expect(solveKey(holdBoundary(two, true).project)).not.toBe(key);
  });
});

describe('a solution', () => {
  it('depends on rest positions and settings, not on the pose', () => {
    const key = solveKey(two.project);
    expect(solveKey(moveHandles(two, ['b'], [1, 1]).project)).toBe(key);
    expect(solveKey(removeHandles(two, ['b']).project)).not.toBe(key);
    expect(solveKey({ ...two.project, samples: 99 })).not.toBe(key);
    expect(solveKey({ ...two.project, pose: { ...two.project.pose, blend: 'rigid' } })).toBe(key);
    expect(solveKey({ ...two.project, pose: { ...two.project.pose, density: 7 } })).not.toBe(key);
  });

  it('of an older project follows the handles that it has', () => {
    const newer = addHandle(moveHandles(removeHandles(two, ['left-hand']), ['b'], [0, 3]), handle('c', 7));
    const followed = followedHandles(two.project, newer.project);
    expect(followed.map((h) => [h.id, h.posed])).toEqual([
      ['left-hand', [0, 0]],
      ['b', [5, 3]],
    ]);
  });
});
