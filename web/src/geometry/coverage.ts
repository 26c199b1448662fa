/** Coverage: how many sites move each place. */
import type { Skin } from './skin';

/** Sites at the top of the heat map: one more than most scenes have anywhere. */
export const MOST_COVERAGE = 10;

/** Vertices: the number of sites that move each, as a share of `MOST_COVERAGE`. */
export function coverageOf({ offsets }: Pick<Skin, 'offsets'>): Float32Array {
  return Float32Array.from({ length: offsets.length - 1 }, (_, vertex) => {
    return ((offsets[vertex + 1] ?? 0) - (offsets[vertex] ?? 0)) / MOST_COVERAGE;
  });
}
