import { describe, expect, it } from 'vitest';
import { areaOf } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import { newProject } from './document';
import { isFilled, ringsOf, withFill, withLasso } from './domain';
import type { Handle, Project } from './project';

const square = (left: number, top: number, side: number): readonly Vec[] => [
  [left, top],
  [left + side, top],
  [left + side, top + side],
  [left, top + side],
];
const point = (id: string, x: number, y: number): Handle => ({
  id,
  kind: 'point',
  rest: [x, y],
  posed: [0, 0],
});
const project = (...handles: readonly Handle[]): Project => ({
  ...newProject({ src: 'a.jpg', width: 400, height: 300 }, null),
  handles,
});
const drawn = (from: Project, ring: readonly Vec[], hole = false): Project => {
  const after = withLasso(from, ring, hole);
  if (!after) throw new Error('the ring is empty');
  return after.project;
};
const ids = ({ handles }: Project) => handles.map(({ id }) => id);

describe('a lasso', () => {
  it('replaces the domain by the inside of its ring', () => {
    const after = drawn(project(point('in', 60, 60), point('out', 5, 5)), square(50, 50, 100));
    expect(after.domain).toEqual({ kind: 'polygon', rings: [square(50, 50, 100)] });
    expect(ids(after)).toEqual(['in']);
    expect(ringsOf(project())).toEqual([]);
  });
  it('has a filled background or none', () => {
    const lassoed = drawn(project(), square(50, 50, 100));
    expect(isFilled(lassoed)).toBe(false);
    const filled = withFill(lassoed, true);
    expect(filled.fill).toEqual({ method: 'patches', seed: 0 });
    expect(isFilled(filled)).toBe(true);
    expect(isFilled(withFill(project(), true))).toBe(false);
    expect(withFill(filled, false)).toEqual(lassoed);
    const other = { ...filled, fill: { seed: 7 } };
    expect(withFill(other, true)).toEqual(other);
  });
  it('is clipped to the picture and rounded to hundredths of a pixel', () => {
    const [ring] = ringsOf(drawn(project(), square(-50, -50, 100.1234)));
    expect(ring).toHaveLength(4);
    expect(ring).toEqual(
      expect.arrayContaining([
        [0, 0],
        [50.12, 50.12],
      ]),
    );
  });
  it('is rejected outside the picture and if it is too small', () => {
    expect(withLasso(project(), square(500, 0, 90), false)).toBeNull();
    expect(withLasso(project(), square(50, 50, 3), false)).toBeNull();
    expect(withLasso(project(), [[10, 10]], false)).toBeNull();
  });
  it('drops repeated corners', () => {
    const [ring] = ringsOf(drawn(project(), [[50, 50], [50, 50.02], ...square(50, 50, 90), [50, 50.04]]));
    expect(ring).toHaveLength(4);
  });
  it('has a ring for each part of a line that crosses itself', () => {
    const eight: readonly Vec[] = [...square(50, 50, 100), [50, 50], [20, 50], [20, 20], [50, 20]];
    const after = drawn(project(point('a', 60, 70), point('b', 30, 40), point('c', 10, 10)), eight);
    expect(ringsOf(after).map(areaOf).map(Math.round)).toEqual([9990, 897]);
    expect(ids(after)).toEqual(['a', 'b']);
    // Parts that the frame of the picture cuts apart.
    const legs: readonly Vec[] = [
      [100, 200],
      [140, 200],
      [140, 320],
      [200, 320],
      [200, 200],
      [240, 200],
      [240, 380],
      [100, 380],
    ];
    expect(ringsOf(drawn(project(), legs)).map(areaOf)).toEqual([4000, 4000]);
  });
  it('keeps bars that cross it', () => {
    const line = [
      [20, 100],
      [300, 100],
    ] as const;
    const bar: Handle = { id: 'arm', kind: 'bar', rest: line, posed: line };
    expect(ids(drawn(project(bar), square(100, 80, 40)))).toEqual(['arm']);
    expect(ids(drawn(project(bar), square(100, 120, 40)))).toEqual([]);
  });
});

describe('a second lasso', () => {
  const first = drawn(project(), square(50, 50, 100));
  it('elsewhere adds an island', () => {
    expect(ringsOf(drawn(first, square(200, 50, 80)))).toHaveLength(2);
  });
  it('replaces rings that it crosses, contains or lies in', () => {
    for (const [left, side] of [
      [100, 100],
      [30, 200],
      [70, 40],
    ] as const) {
      expect(ringsOf(drawn(first, square(left, left, side)))).toHaveLength(1);
    }
  });
  it('cuts a hole if it lies inside the domain', () => {
    const holed = drawn(first, square(70, 70, 40), true);
    expect(ringsOf(holed)).toHaveLength(2);
    const after = drawn(
      { ...first, handles: [point('in hole', 80, 80), point('in', 60, 60)] },
      square(70, 70, 40),
      true,
    );
    expect(ids(after)).toEqual(['in']);
    // A hole replaces the holes inside it. A ring that crosses the boundary cuts no hole.
    expect(ringsOf(drawn(holed, square(60, 60, 80), true))).toHaveLength(2);
    expect(ringsOf(drawn(holed, square(60, 60, 200), true))).toHaveLength(1);
    // A line that crosses itself cuts a hole for each of its parts.
    const eight: readonly Vec[] = [...square(100, 100, 30), [100, 100], [80, 100], [80, 80], [100, 80]];
    expect(ringsOf(drawn(first, eight, true))).toHaveLength(3);
    const cut = (side: number) => withLasso(holed, square(60, 60, side), true)?.cut;
    expect([cut(80), cut(200)]).toEqual([true, false]);
    // A replaced ring is removed with its holes.
    expect(ringsOf(drawn(holed, square(120, 120, 90)))).toHaveLength(1);
  });
});
