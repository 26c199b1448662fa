import { describe, expect, it } from 'vitest';
import { posedPositions } from './blend';
import { locate, locateNear, locatePosed } from './locate';
import { MOTION_STRIDE, type Skin } from './skin';

/** A unit square of two triangles, its left side held by site 0 and its right by site 1; a lone vertex without weights. */
const skin: Skin = {
  positions: Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1, 5, 5),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
  offsets: Uint32Array.of(0, 1, 2, 3, 4, 4),
  sites: Uint32Array.of(0, 1, 1, 0),
  weights: Float32Array.of(1, 1, 1, 1),
};

const motions = (...sites: readonly (readonly number[])[]) => {
  const array = new Float32Array(sites.length * MOTION_STRIDE);
  sites.forEach((site, k) => {
    array.set(site, k * MOTION_STRIDE);
  });
  return array;
};

describe('posedPositions', () => {
  it('is the rest without motions, and for vertices without weights', () => {
    expect(posedPositions(skin, null)).toEqual(skin.positions);
    const posed = posedPositions(skin, motions([1, 0, 0, 1, 0, 0, 3, 4], [1, 0, 0, 1, 1, 0, 4, 4]));
    expect([...posed]).toEqual([3, 4, 4, 4, 4, 5, 3, 5, 5, 5]);
  });

  it('turns about the site’s rest place', () => {
    // A quarter turn, clockwise on the screen, about (1, 0) for the right side.
    const posed = posedPositions(skin, motions([1, 0, 0, 1, 0, 0, 0, 0], [0, 1, -1, 0, 1, 0, 1, 0]));
    expect([...posed.slice(4, 6)]).toEqual([0, 0]);
  });

  it('stretches along one direction alone', () => {
    const stretch = [3, 0, 0, 1, 0, 0, 0, 0];
    expect([...posedPositions(skin, motions(stretch, stretch)).slice(2, 6)]).toEqual([3, 0, 3, 1]);
  });
});

describe('locate', () => {
  it('inverts the map, with the motion it has there', () => {
    // Everything doubled and turned by a quarter about the origin, then moved by (10, 0).
    const turn = [0, 2, -2, 0, 0, 0, 10, 0];
    const posed = posedPositions(skin, motions(turn, turn));
    const found = locate(skin, posed, [10 - 2 * 0.75, 2 * 0.25]);
    expect(found?.rest[0]).toBeCloseTo(0.25);
    expect(found?.rest[1]).toBeCloseTo(0.75);
    expect(found?.rotation).toBeCloseTo(90);
    expect(found?.scale).toBeCloseTo(2);
  });

  it('leads from rest to the posed picture, by the blends of all vertices', () => {
    const [left, right] = [
      [1, 0, 0, 1, 0, 0, 3, 4],
      [0, 2, -2, 0, 1, 0, 4, 4],
    ];
    const moved = motions(left, right);
    const inverse = { ...skin, positions: posedPositions(skin, moved) };
    const there = locatePosed(skin, moved, 'linear', [0.75, 0.5]);
    expect(there).toEqual(locate(inverse, skin.positions, [0.75, 0.5]));
    expect(locatePosed(skin, null, 'linear', [0.75, 0.5])?.rest).toEqual([0.75, 0.5]);
    expect(locatePosed(skin, moved, 'linear', [2, 2])).toBeNull();
    expect(locatePosed(skin, moved, 'linear', [1, 0])?.rest).toEqual([4, 4]);
  });

  it('is null where there is no picture', () => {
    expect(locate(skin, posedPositions(skin, null), [2, 2])).toBeNull();
  });

  it('picks the triangle drawn last where the picture overlaps itself', () => {
    const folded = { ...skin, triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 1, 2) };
    const posed = Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1, 0, 0.5);
    const found = locate(folded, posed, [0.9, 0.5]);
    expect(found?.rest[0]).toBeGreaterThan(1);
  });

  it('goes on beside the picture as at its nearest place', () => {
    const turn = [0, 2, -2, 0, 0, 0, 10, 0];
    const posed = posedPositions(skin, motions(turn, turn));
    // What rests at (3, 0.5), beside the square.
    const { rest, rotation } = locateNear(skin, posed, [10 - 2 * 0.5, 2 * 3]) ?? {
      rest: [0, 0],
      rotation: 0,
    };
    expect(rest[0]).toBeCloseTo(3);
    expect(rest[1]).toBeCloseTo(0.5);
    expect(rotation).toBeCloseTo(90);
  });
});
