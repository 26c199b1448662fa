import { describe, expect, it } from 'vitest';
import { displacementAt, displacementOf, fieldForStrokes, restingField, withField } from './displacement';
import { newProject } from './document';
import type { Project } from './project';

const resting = newProject({ src: 'a.png', width: 640, height: 320 }, null);

/** The project with every control point moved by a smooth function of its place. */
function waved(width: number, height: number): Project {
  const numbers = new Int16Array(2 * width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) {
      const at = 2 * (row * width + column);
      numbers[at] = 200 * Math.sin((4 * column) / width);
      numbers[at + 1] = -90;
    }
  return { ...resting, displacement: displacementOf(width, height, numbers) };
}

describe('a displacement', () => {
  it('has 128 intervals along the longer side, as square as they can be', () => {
    expect(restingField(resting.image)).toMatchObject({ width: 131, height: 67, spacing: [5, 5] });
    expect(restingField({ src: '', width: 1, height: 2000 })).toMatchObject({ width: 4, height: 131 });
  });

  it('is read as it was written, and is no part of a project in which nothing moves', () => {
    const project = waved(131, 67);
    const again = withField(resting, fieldForStrokes(JSON.parse(JSON.stringify(project)) as Project));
    expect(again.displacement).toEqual(project.displacement);
    expect('displacement' in withField(project, restingField(resting.image))).toBe(false);
  });

  it('moves places by a spline of its control points', () => {
    const numbers = Int16Array.from({ length: 2 * 131 * 67 }, (_, at) => (at % 2 === 0 ? 256 : -128));
    const field = fieldForStrokes({ ...resting, displacement: displacementOf(131, 67, numbers) });
    for (const place of [
      [0, 0],
      [3, 319],
      [640, 320],
      [-50, 900],
    ] as const) {
      const [x, y] = displacementAt(field, place);
      expect([x, y].map((value) => value.toFixed(6))).toEqual(['5.000000', '-2.500000']);
    }
  });

  it('of another grid is continued in the grid of strokes', () => {
    const project = waved(40, 22);
    const { displacement } = project;
    const coarse = { ...fieldForStrokes(project) };
    expect(coarse).toMatchObject({ width: 131, height: 67 });
    const file = displacement && {
      width: 40,
      height: 22,
      spacing: [640 / 37, 320 / 19] as const,
      values: Float64Array.from({ length: 2 * 40 * 22 }, (_, at) => {
        const column = Math.floor(at / 2) % 40;
        return at % 2 === 0
          ? (Math.trunc(200 * Math.sin((4 * column) / 40)) / 256) * (640 / 37)
          : (-90 / 256) * (320 / 19);
      }),
    };
    if (!file) throw new Error('nothing moves');
    for (const place of [
      [20, 20],
      [333, 100],
      [600, 300],
    ] as const) {
      const [a, b] = [displacementAt(coarse, place), displacementAt(file, place)];
      expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThan(0.02);
    }
  });
});
