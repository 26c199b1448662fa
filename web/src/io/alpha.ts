/** Chooses the alpha threshold of the domain such that every visible pixel is warped. */
import type { Rgba } from './pixels';

/** Half opaque. On hard edges, and edges that fade within a few pixels, the eye sees the outline here. */
const EDGE = 128;
/** Pixels that the solver draws beyond the outline, for soft edges (`WIDTH` in `sample/skirt.rs`). */
const SKIRT = 3;
/** Smaller alphas are invisible. */
const FAINT = 6;
/** More translucent pixels than this beyond the skirt are a shadow or a veil; fewer are dust. */
const DUST = 64;

/**
 * Returns the threshold, in (0, 1], or `null` if the picture is opaque. Soft shadows and veils need a low threshold.
 *
 * Cost: linear in the pixels; translucent pixels also read their neighbourhood.
 */
export function alphaThreshold(picture: Rgba): number | null {
  const { rgba } = picture;
  let [opaque, translucent] = [true, 0];
  for (let pixel = 0; pixel * 4 < rgba.length; pixel++) {
    const alpha = rgba[pixel * 4 + 3] ?? 0;
    if (alpha !== 255) opaque = false;
    if (alpha < FAINT || alpha >= EDGE || isNearEdge(picture, pixel)) continue;
    translucent++;
    if (translucent > DUST) return FAINT / 255;
  }
  return opaque ? null : 0.5;
}

/** Whether a pixel lies within the skirt of a pixel that is at least half opaque. */
function isNearEdge({ width, height, rgba }: Rgba, pixel: number): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let row = Math.max(0, y - SKIRT); row <= Math.min(height - 1, y + SKIRT); row++) {
    for (let column = Math.max(0, x - SKIRT); column <= Math.min(width - 1, x + SKIRT); column++) {
      if ((rgba[(row * width + column) * 4 + 3] ?? 0) >= EDGE) return true;
    }
  }
  return false;
}
