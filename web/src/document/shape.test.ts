import { describe, expect, it } from 'vitest';
import { newProject, openDocument } from './document';
import { addHandle, changeHandles, removeHandles } from './edits';
import { moved } from './handle';
import type { Handle, Project } from './project';
import { shapeNumbers, shapeOf, withoutStaleShape, withShape } from './shape';
import { solveKey } from './solved';

const SHAPE = [
  [1, 2, 3, 4, 1, 0, 0, 1],
  [5, 6, 7, 8, 0, 1, -1, 0],
];

const point = (id: string, x: number): Handle => ({ id, kind: 'point', rest: [10, 20], posed: [x, 20] });

const project = (x: number): Project => ({
  ...newProject({ src: 'a.png', width: 64, height: 32 }, null),
  handles: [point('tail', x)],
});

describe('the shape of a project', () => {
  it('is the same after it was numbers', () => {
    expect(shapeOf(shapeNumbers(SHAPE))).toEqual(SHAPE);
    expect(shapeOf(shapeNumbers(undefined))).toBeUndefined();
  });

  it('is dropped while all handles are at rest', () => {
    expect(withShape(project(30), SHAPE).shape).toBe(SHAPE);
    expect('shape' in withShape(project(10), SHAPE)).toBe(false);
    expect('shape' in withShape({ ...project(30), shape: SHAPE }, undefined)).toBe(false);
  });

  it('needs no solve', () => {
    expect(solveKey({ ...project(30), shape: SHAPE })).toBe(solveKey(project(30)));
  });

  it('outlives handles that are added or removed, and ends with another pose', () => {
    const before = openDocument({ ...project(30), shape: SHAPE });
    const added = addHandle(before, { ...point('head', 40), rest: [40, 20] } as Handle);
    expect(withoutStaleShape(before, added)).toBe(added);
    const removed = removeHandles(added, ['head']);
    expect(withoutStaleShape(added, removed)).toBe(removed);
    const pasted = changeHandles(before, ['tail'], (handle) => moved(handle, [1, 0]));
    expect('shape' in withoutStaleShape(before, pasted).project).toBe(false);
    const opened = openDocument({ ...project(31), shape: [...SHAPE] });
    expect(withoutStaleShape(before, opened)).toBe(opened);
  });
});
