/** Sizes that the figures share. */

/** The size of the picture in pixels: half of the drawing. */
export const SIZE = { width: 512, height: 640 } as const;

/** Samples of a solve. Weights and distances have a closed form, so more would not make them more exact. */
export const SAMPLES = 5_000;

/** Points at which figures ask, and draw straight lines in between. */
export const POINTS = 10_000;
