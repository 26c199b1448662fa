import { describe, expect, it } from 'vitest';
import { lineOpacity, meanEdge, meshEdges, unwarpedMesh, weightRows } from './mesh';

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

describe('the lines of a mesh', () => {
  it('have a mean length, and are fainter in proportion where they are shorter', () => {
    const edges = meshEdges(new Uint32Array([0, 1, 2]));
    expect(meanEdge(edges, new Float32Array([0, 0, 3, 0, 0, 4]))).toBe(4);
    expect(meanEdge(new Uint32Array(), new Float32Array())).toBe(0);
    expect([lineOpacity(2.5), lineOpacity(10), lineOpacity(200)]).toEqual([0.25, 1, 1]);
  });
});
