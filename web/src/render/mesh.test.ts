import { describe, expect, it } from 'vitest';
import { meshEdges, unwarpedMesh, weightRows } from './mesh';

describe('mesh', () => {
  it('converts offsets to pairs of first entry and count', () => {
    expect([...weightRows(new Uint32Array([0, 2, 2, 5]))]).toEqual([0, 2, 2, 0, 2, 3]);
    expect([...weightRows(new Uint32Array())]).toEqual([]);
  });

  it('lists every edge once', () => {
    const { triangles } = unwarpedMesh(4, 3);
    expect([...meshEdges(triangles)]).toEqual([0, 1, 0, 2, 1, 2, 1, 3, 2, 3]);
  });
});
