import { expect, it } from 'vitest';
import { coverageOf } from './coverage';

it('is the share of ten sites that move a vertex', () => {
  const coverage = coverageOf({ offsets: Uint32Array.of(0, 1, 1, 6) });
  expect(Array.from(coverage, (share) => Math.round(10 * share))).toEqual([1, 0, 5]);
});
