/**
 * Chooses the alpha threshold of the domain such that every visible pixel is warped, and what looks connected bends as
 * one.
 *
 * Half opaque is where the eye sees a hard edge. There are two exceptions. Soft shadows and veils need a low threshold.
 * Thin strands are half opaque in few pixels: the threshold falls to the alpha at which their pieces are connected.
 */
import { connectingAlpha } from './connected';
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
 * Returns the threshold, in (0, 1], or `null` if the picture is opaque.
 *
 * Cost: linear in the pixels; translucent pixels also read their neighbourhood.
 */
export function alphaThreshold(picture: Rgba): number | null {
  const { rgba } = picture;
  if (isOpaque(rgba)) return null;
  const edge = connectingAlpha(picture, EDGE);
  let translucent = 0;
  for (let pixel = 0; pixel * 4 < rgba.length; pixel++) {
    const alpha = rgba[pixel * 4 + 3] ?? 0;
    if (alpha < FAINT || alpha >= edge || isNearEdge(picture, pixel, edge)) continue;
    translucent++;
    if (translucent > DUST) return below(FAINT);
  }
  return edge === EDGE ? 0.5 : below(edge);
}

/** A threshold that an alpha exceeds and the next lower one does not. The outline then runs between pixels. */
const below = (alpha: number): number => (alpha - 0.5) / 255;

function isOpaque(rgba: Uint8Array): boolean {
  for (let at = 3; at < rgba.length; at += 4) if (rgba[at] !== 255) return false;
  return true;
}

/** Whether a pixel lies within the skirt of a pixel with at least the alpha `edge`. */
function isNearEdge({ width, height, rgba }: Rgba, pixel: number, edge: number): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let row = Math.max(0, y - SKIRT); row <= Math.min(height - 1, y + SKIRT); row++) {
    for (let column = Math.max(0, x - SKIRT); column <= Math.min(width - 1, x + SKIRT); column++) {
      if ((rgba[(row * width + column) * 4 + 3] ?? 0) >= edge) return true;
    }
  }
  return false;
}
