import { describe, expect, it } from 'vitest';
import { foldCount, foldedTriangles, foldingMesh } from './folds';

const skin = {
  positions: Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
  offsets: new Uint32Array(5),
  sites: new Uint32Array(),
  weights: new Float32Array(),
};
const mesh = foldingMesh(skin, 4);
/** The corner at (1, 0) is pulled across the diagonal. */
const pulled = Float32Array.of(0, 0, 0.2, 0.8, 1, 1, 0, 1);

describe('folds', () => {
  it('are none at rest, nor where everything is turned', () => {
    expect(foldCount(mesh, skin.positions)).toBe(0);
    expect(foldCount(mesh, Float32Array.of(0, 0, -1, 0, -1, -1, 0, -1))).toBe(0);
  });

  it('are the triangles that have turned over, whichever way round they lie at rest', () => {
    expect(foldCount(mesh, pulled)).toBe(1);
    expect([...foldedTriangles(mesh, pulled)]).toEqual([0, 1, 2]);
    const mirrored = foldingMesh({ ...skin, triangles: Uint32Array.of(2, 1, 0, 0, 2, 3) }, 4);
    expect(foldCount(mirrored, pulled)).toBe(1);
    expect(foldCount(mirrored, skin.positions)).toBe(0);
  });

  it('do not count beyond the skirt, nor beyond a limit', () => {
    expect(foldCount(foldingMesh(skin, 1), pulled)).toBe(0);
    const over = Float32Array.of(0, 0, 0, 1, 1, 1, 1, 0);
    expect(foldCount(mesh, over)).toBe(2);
    expect(foldCount(mesh, over, 0)).toBe(1);
  });
});
