import { describe, expect, it } from 'vitest';
import { boxMeans } from './box_means';

describe('means over squares', () => {
  const field = {
    width: 7,
    height: 5,
    spacing: [1, 1],
    values: Float64Array.from({ length: 70 }, (_, at) => (at * at) % 17),
  } as const;

  it('are those of the values at most so far away, also beyond an edge', () => {
    const window = { left: 0, top: 1, columns: 6, rows: 4 };
    for (const by of [1, 2, 3]) {
      const means = boxMeans(field, window, by);
      for (let row = 0; row < window.rows; row++)
        for (let column = 0; column < window.columns; column++)
          for (const axis of [0, 1]) {
            let sum = 0;
            for (let y = -by; y <= by; y++)
              for (let x = -by; x <= by; x++) {
                const line = Math.min(Math.max(window.top + row + y, 0), field.height - 1);
                const place = Math.min(Math.max(window.left + column + x, 0), field.width - 1);
                sum += field.values[2 * (line * field.width + place) + axis] ?? 0;
              }
            const own = 2 * (row * window.columns + column) + axis;
            expect(means[own]).toBeCloseTo(sum / (2 * by + 1) ** 2, 9);
          }
    }
  });
});
