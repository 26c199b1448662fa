/** Heat maps over a picture: values from 0 to 1 at the vertices of its mesh, and their colours. */

export interface HeatMap {
  /** One per vertex. */
  readonly values: Float32Array;
  /** Draws isolines at every tenth, with a bold one at one half. */
  readonly lines: boolean;
}

/** An sRGB colour, 0 to 255, and an opacity, 0 to 1. */
export type RampColour = readonly [red: number, green: number, blue: number, alpha: number];

/**
 * The colours of 0, 0.2, … 1: from transparent through blue to yellow.
 *
 * The OKLab lightness rises in equal steps from 0.42 to 0.93, so that the ramp reads without hues. Nearly everyone can
 * tell blue from yellow.
 */
export const HEAT_RAMP: readonly RampColour[] = [
  [85, 40, 169, 0],
  [59, 98, 196, 0.55],
  [18, 149, 187, 0.65],
  [54, 191, 166, 0.7],
  [142, 223, 124, 0.74],
  [244, 240, 78, 0.78],
];

/** The coverage at the top of the heat map: one site more than most projects reach. */
export const MOST_COVERAGE = 10;
