import { describe, expect, it } from 'vitest';
import { type Homography, inverted, mapped, type Quad, squareToQuad } from './homography';
import { rotated, type Vec } from './vec';

const SQUARE: Quad = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];
/** A square whose right edge is farther away. */
const RECEDING: Quad = [
  [10, 20],
  [210, 60],
  [210, 140],
  [10, 220],
];

const turned = (degrees: number): Quad => SQUARE.map((p) => rotated(p, degrees)) as unknown as Quad;

const onto = (quad: Quad): Homography => squareToQuad(quad) as Homography;

function expectNear([x, y]: Vec, [u, v]: Vec): void {
  expect(x).toBeCloseTo(u, 9);
  expect(y).toBeCloseTo(v, 9);
}

describe('homographies', () => {
  it('map the corners of the square to those of the quad', () => {
    for (const quad of [SQUARE, RECEDING, turned(20)])
      SQUARE.forEach((corner, k) => {
        expectNear(mapped(onto(quad), corner), quad[k] as Vec);
      });
  });

  it('map lines to lines: diagonals meet where those of the quad do', () => {
    const [x, y] = mapped(onto(RECEDING), [0.5, 0.5]);
    expect(y).toBeCloseTo(20 + x - 10 + ((x - 10) * (140 - 20 - 200)) / 200, 9);
    // The nearer half of the square covers more.
    expect(x).toBeGreaterThan(110);
  });

  it('have an inverse, also of a mirrored quad', () => {
    const mirrored: Quad = [RECEDING[1], RECEDING[0], RECEDING[3], RECEDING[2]];
    for (const quad of [RECEDING, mirrored, turned(-75)]) {
      const inverse = inverted(onto(quad)) as Homography;
      for (const p of [[0.25, 0.75], [0.9, 0.1], ...SQUARE] as const)
        expectNear(mapped(inverse, mapped(onto(quad), p)), p);
    }
  });

  it('keep points beyond the vanishing line on their side', () => {
    const inverse = inverted(onto(RECEDING)) as Homography;
    const vanishing = 343.3;
    for (const x of [vanishing - 1, vanishing, vanishing + 1, 5000])
      expect(mapped(inverse, [x, 100])[0]).toBeGreaterThan(10);
  });

  it('do not exist for quads without an area', () => {
    const edgeOn: Quad = [
      [0, 0],
      [0, 0],
      [0, 5],
      [0, 5],
    ];
    expect(squareToQuad(edgeOn)).toBeNull();
    expect(squareToQuad([SQUARE[0], SQUARE[0], SQUARE[0], SQUARE[0]])).toBeNull();
  });
});
