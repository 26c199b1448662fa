/** Weights of one site, from rows of all. */
import type { PointWeights } from '../../../src/core';

/** The weight of a site at each point. */
export function weightsOf(
  { offsets, sites, weights }: PointWeights,
  site: number,
): Float64Array<ArrayBuffer> {
  const field = new Float64Array(offsets.length - 1);
  for (let point = 0; point < field.length; point++) {
    for (let entry = offsets[point] as number; entry < (offsets[point + 1] as number); entry++) {
      if (sites[entry] === site) field[point] = weights[entry] as number;
    }
  }
  return field;
}
