import { describe, expect, it } from 'vitest';
import { beginStroke, ledStroke, type Stroke, withStroke } from './brush_stroke';
import { newProject } from './document';
import type { Handle, Project } from './project';
import { cellsForStrokes, isStiff, softCells, stiffened, stiffnessOf, withCells } from './stiffness';

const soft = newProject({ src: 'a.png', width: 640, height: 320 }, null);
const brush = { radius: 60, strength: 1, erases: false };
/** The stiffness at a place, 0 to 255. */
const at = (project: Project, x: number, y: number): number => {
  const { width, height, values } = cellsForStrokes(project);
  return values[Math.floor((y * height) / 320) * width + Math.floor((x * width) / 640)] ?? -1;
};
const dab = (project: Project, x: number, y: number, change = {}) =>
  withStroke(ledStroke(beginStroke(project, { ...brush, ...change }), [x, y], [x, y]));

describe('the cells of a mask', () => {
  it('are square, 128 along the longer side, and at least one across', () => {
    expect(softCells(soft.image)).toMatchObject({ width: 128, height: 64 });
    expect(softCells({ src: '', width: 2, height: 900 })).toMatchObject({ width: 1, height: 128 });
  });

  it('are written as base64, and not at all where nothing is stiff', () => {
    expect('stiffness' in withCells(soft, softCells(soft.image))).toBe(false);
    const painted = dab(soft, 100, 100);
    expect(painted.stiffness).toMatchObject({ width: 128, height: 64 });
    // From text, as a file has it.
    const read = JSON.parse(JSON.stringify(painted)) as Project;
    expect(cellsForStrokes(read)).toEqual(cellsForStrokes(painted));
    expect([isStiff(soft), isStiff(painted)]).toEqual([false, true]);
  });

  it('of a coarser mask are interpolated before a stroke', () => {
    const coarse: Project = { ...soft, stiffness: { width: 2, height: 1, values: 'AP8=' } };
    expect([at(coarse, 100, 9), at(coarse, 600, 300)]).toEqual([0, 255]);
    expect(at(coarse, 320, 160)).toBeCloseTo(128, -1);
  });
});

describe('a stroke', () => {
  it('is full in its core, and soft towards its rim', () => {
    const painted = dab(soft, 300, 160);
    const values = [300, 315, 340, 350, 365].map((x) => at(painted, x, 160));
    expect(values[0]).toBe(255);
    expect(values[1]).toBe(255);
    expect(values[2]).toBeLessThan(240);
    expect(values[3]).toBeLessThan(values[2] ?? 0);
    expect(values[4]).toBe(0);
  });

  it('does not depend on how often the pointer reports', () => {
    const led = (stroke: Stroke, ...xs: readonly number[]) =>
      xs.slice(1).reduce((next, x, k) => ledStroke(next, [xs[k] ?? 0, 90], [x, 90]), stroke);
    const begun = beginStroke(soft, { ...brush, strength: 0.3 });
    const few = withStroke(led(begun, 100, 500));
    expect(withStroke(led(begun, 100, 180, 300, 240, 500))).toEqual(few);
    expect(at(few, 250, 90)).toBe(Math.round(0.3 * 255));
  });

  it('adds to strokes before, up to stiff, and erases back to a project without a mask', () => {
    let project: Project = soft;
    const seen = [1, 2, 3].map(() => {
      project = dab(project, 200, 160, { strength: 0.5 });
      return at(project, 200, 160);
    });
    expect(seen).toEqual([128, 192, 224]);
    for (let k = 0; k < 60; k++)
      project = dab(project, 200, 160, { strength: 0.5, erases: true, radius: 200 });
    expect(project).toEqual(soft);
  });

  it('that ends beside the picture covers its border alone', () => {
    const painted = dab(soft, -10, 160);
    expect([at(painted, 1, 160), at(painted, 639, 160)]).toEqual([255, 0]);
    expect(dab(soft, -900, 160)).toEqual(soft);
  });
});

describe('the stiffness of a handle', () => {
  const ring = [
    [0, 0],
    [9, 0],
    [9, 9],
  ] as const;
  const polygon: Handle = { id: 'a', kind: 'polygon', rest: ring, posed: ring };

  it('belongs to polygons, from 0 to 1, and is left out at 0', () => {
    expect([0.25, 3, 0.004].map((value) => stiffnessOf(stiffened(polygon, value)))).toEqual([0.25, 1, 0]);
    expect(stiffened(stiffened(polygon, 1), 0)).toEqual(polygon);
    const bar: Handle = { ...polygon, kind: 'bar' };
    expect(stiffened(bar, 1)).toBe(bar);
  });
});
