import { describe, expect, it } from 'vitest';
import type { Vec } from '../geometry/vec';
import { newProject, openDocument } from './document';
import { ringsOf, withFill, withLasso } from './domain';
import { anchor, corners } from './handle';
import { withPartPolygons } from './part_polygon';

const IMAGE = { src: 'a.png', width: 400, height: 300 };

const circle = (centre: Vec, radius: number, count = 90): readonly Vec[] =>
  Array.from({ length: count }, (_, k): Vec => {
    const turn = (2 * Math.PI * k) / count;
    return [centre[0] + radius * Math.cos(turn), centre[1] + radius * Math.sin(turn)];
  });

/** The polygon that replaces these lassos. */
const polygonOf = (...rings: readonly (readonly Vec[])[]) => {
  const project = rings.reduce(
    (before, ring) => withLasso(before, ring, false)?.project ?? before,
    withFill({ ...newProject(IMAGE, null), fix_boundary: false }, true),
  );
  const made = withPartPolygons(openDocument(project));
  if (!made) throw new Error('There is no polygon.');
  const [polygon] = made.project.handles;
  if (!polygon) throw new Error('There is no handle.');
  return { made, polygon, outline: corners(polygon, 'rest') };
};

describe('a polygon in place of a lasso', () => {
  it('lets all of the picture bend up to its held frame', () => {
    const { made, polygon } = polygonOf(circle([200, 150], 80));
    expect(made.project).toMatchObject({ domain: { kind: 'image' }, fix_boundary: true });
    expect(made.project.fill).toBeUndefined();
    expect(polygon.kind).toBe('polygon');
    expect(made.selection).toEqual([polygon.id]);
  });

  it('follows the outline with few corners', () => {
    const { outline } = polygonOf(circle([200, 150], 80));
    expect(outline.length).toBeGreaterThan(5);
    expect(outline.length).toBeLessThanOrEqual(16);
    for (const [x, y] of outline) expect(Math.abs(Math.hypot(x - 200, y - 150) - 80)).toBeLessThan(8);
  });

  it('keeps away from the frame', () => {
    for (const [x, y] of polygonOf(circle([200, 20], 100)).outline) {
      expect(Math.min(x, y)).toBeGreaterThanOrEqual(8);
      expect(x).toBeLessThanOrEqual(392);
    }
  });

  it('has one for each part of the lasso', () => {
    const { made } = polygonOf(circle([60, 150], 20), circle([250, 150], 80));
    expect(made.selection).toEqual(['polygon-1', 'polygon-2']);
    const middles = made.project.handles.map((handle) => Math.round(anchor(handle)[0] / 10));
    expect(middles).toEqual([6, 25]);
  });

  it('cannot lie along the frame', () => {
    const along: readonly Vec[] = [
      [0, 0],
      [400, 0],
      [400, 6],
      [0, 6],
    ];
    const found = withLasso(newProject(IMAGE, null), along, false);
    expect(found && withPartPolygons(openDocument(found.project))).toBeNull();
  });

  it('needs a lasso', () => {
    const document = openDocument(newProject(IMAGE, null));
    expect(ringsOf(document.project)).toEqual([]);
    expect(withPartPolygons(document)).toBeNull();
  });
});
