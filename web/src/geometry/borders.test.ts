import { expect, it } from 'vitest';
import { posedBorders } from './borders';

it('takes the ends of each piece along with its triangle', () => {
  const posed = Float32Array.of(0, 0, 8, 0, 0, 4, 8, 4);
  const corners = Uint32Array.of(0, 1, 2, 1, 3, 2);
  const shares = Float32Array.of(0.5, 0.5, 0, 0, 0.25, 0.75, 1, 0, 0, 0, 0.5, 0.5);
  expect([...posedBorders({ corners, shares }, posed)]).toEqual([4, 0, 2, 3, 8, 0, 4, 4]);
});
