import { expect, it } from 'vitest';
import { nearestFields } from './cell_image';

it('gives a point to the least field, and to the first of equal ones', () => {
  const fields = [Float64Array.of(1, 5, 3), Float64Array.of(2, 4, 3)];
  expect(Array.from(nearestFields(fields, 3))).toEqual([0, 1, 0]);
});
