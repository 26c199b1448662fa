import { describe, expect, it } from 'vitest';
import type { Skin } from './skin';
import { spotAt } from './spot';

/** A unit square of two triangles, and a skirt of one more that goes 2 beyond its right side. */
const skin: Skin = {
  positions: Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1, 3, 0.5),
  triangles: Uint32Array.of(1, 4, 2, 0, 1, 2, 0, 2, 3),
  offsets: new Uint32Array(6),
  sites: new Uint32Array(0),
  weights: new Float32Array(0),
};
const SAMPLES = 4;
/** Twice as large, and moved by (10, 0). */
const posed = skin.positions.map((coordinate, index) => 2 * coordinate + (index % 2 === 0 ? 10 : 0));
const spot = (x: number, y: number, within: number) => spotAt(skin, SAMPLES, posed, [x, y], within);

describe('spotAt', () => {
  it('is the place itself on what bends, however near the border', () => {
    const found = spot(11.99, 0.5, 0);
    expect(found?.at).toEqual([11.99, 0.5]);
    expect(found?.rest[0]).toBeCloseTo(0.995);
    expect(found?.rest[1]).toBeCloseTo(0.25);
    expect(found?.scale).toBeCloseTo(2);
  });

  it('leads from the skirt onto what bends, a little inside', () => {
    const found = spot(13, 1, 0);
    expect(found?.at[0]).toBeGreaterThan(11.8);
    expect(found?.at[0]).toBeLessThan(12);
    expect(found?.rest[0]).toBeCloseTo(((found?.at[0] ?? 0) - 10) / 2);
    expect(found?.rest[1]).toBeCloseTo(0.5, 1);
  });

  it('leads from beside the picture no farther than asked for', () => {
    expect(spot(9.5, 1, 0.4)).toBeNull();
    expect(spot(9.5, 1, 0.6)?.at[0]).toBeGreaterThan(10);
    expect(spot(9, 3, 1.3)).toBeNull();
    const corner = spot(9, 3, 1.5);
    expect(corner?.rest[0]).toBeGreaterThan(0);
    expect(corner?.rest[1]).toBeLessThan(1);
  });

  it('is on what lies under a skirt, where something does', () => {
    const covered = posed.slice();
    // The skirt goes back over the square.
    covered.set([10, 1], 8);
    expect(spotAt(skin, SAMPLES, covered, [11.5, 1], 0)?.at).toEqual([11.5, 1]);
  });
});
