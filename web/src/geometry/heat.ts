/** Heat maps over a picture: values from 0 to 1 at the vertices of its mesh, and their colours. */

export interface HeatMap {
  /** One per vertex. */
  readonly values: Float32Array;
  /** Draws isolines at every tenth, with a bold one at one half. */
  readonly lines: boolean;
}

export { HEAT_RAMP } from './generated/heat_ramp';

/** The coverage at the top of the heat map: one site more than most projects reach. */
export const MOST_COVERAGE = 10;
