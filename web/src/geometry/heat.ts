/** Heat maps over a picture: numbers from 0 to 1 at the vertices of its mesh, and the colours of these. */

export interface HeatMap {
  /** One for each vertex. */
  readonly values: Float32Array;
  /** Whether there is a line at every tenth, bold at the half. */
  readonly lines: boolean;
}

/** A colour in sRGB, 0 to 255, and its opacity, 0 to 1. */
export type RampColour = readonly [red: number, green: number, blue: number, alpha: number];

/**
 * Colours of 0, 0.2, … 1 over the picture: from transparent through blue to yellow. Lightness rises by equal
 * steps, from 0.42 to 0.93 in OKLab, so that the ramp reads without hues; nearly everyone can tell blue from yellow.
 */
export const HEAT_RAMP: readonly RampColour[] = [
  [85, 40, 169, 0],
  [59, 98, 196, 0.55],
  [18, 149, 187, 0.65],
  [54, 191, 166, 0.7],
  [142, 223, 124, 0.74],
  [244, 240, 78, 0.78],
];

/** Coverage at the top of the heat map: one site more than most scenes have anywhere. */
export const MOST_COVERAGE = 10;
