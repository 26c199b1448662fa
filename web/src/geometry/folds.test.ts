import { describe, expect, it } from 'vitest';
import { foldCount, foldedTriangles } from './folds';

const mesh = {
  positions: Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
  samples: 4,
};

describe('folds', () => {
  it('are none at rest, nor where everything is turned', () => {
    expect(foldCount(mesh, mesh.positions)).toBe(0);
    expect(foldCount(mesh, Float32Array.of(0, 0, -1, 0, -1, -1, 0, -1))).toBe(0);
  });

  it('are the triangles that have turned over, whichever way round they lie at rest', () => {
    // The corner at (1, 0) is pulled across the diagonal.
    const posed = Float32Array.of(0, 0, 0.2, 0.8, 1, 1, 0, 1);
    expect(foldCount(mesh, posed)).toBe(1);
    expect([...foldedTriangles(mesh, posed)]).toEqual([0, 1, 2]);
    const mirrored = { ...mesh, triangles: Uint32Array.of(2, 1, 0, 0, 2, 3) };
    expect([...foldedTriangles(mirrored, posed)]).toEqual([2, 1, 0]);
  });

  it('do not count beyond the rim', () => {
    const posed = Float32Array.of(0, 0, 0.2, 0.8, 1, 1, 0, 1);
    expect(foldCount({ ...mesh, samples: 1 }, posed)).toBe(0);
  });
});
