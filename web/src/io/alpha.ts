/** The alpha from which on a picture is warped, so that nothing visible is left out. */
import type { Rgba } from './pixels';

/** Halfway up an edge that is hard or fades within a few pixels: the outline runs where the eye sees it. */
const EDGE = 128;
/** How far the solver draws beyond the outline, pixels: the rest of such an edge (`WIDTH` in `sample/rim.rs`). */
const RIM = 3;
/** Alpha below this is invisible. */
const FAINT = 6;
/** More faint pixels than this beyond the rim are a shadow or a veil, fewer are dust. */
const DUST = 64;

/** The threshold, in (0, 1]; `null` where the picture is opaque. Soft shadows and veils need a low one. */
export function alphaThreshold(picture: Rgba): number | null {
  const { rgba } = picture;
  let [opaque, beyond] = [true, 0];
  for (let pixel = 0; pixel * 4 < rgba.length; pixel++) {
    const alpha = rgba[pixel * 4 + 3] ?? 0;
    if (alpha !== 255) opaque = false;
    if (alpha < FAINT || alpha >= EDGE || isNearEdge(picture, pixel)) continue;
    beyond++;
    if (beyond > DUST) return FAINT / 255;
  }
  return opaque ? null : 0.5;
}

/** Whether a pixel lies within the rim of something that is more than half opaque. */
function isNearEdge({ width, height, rgba }: Rgba, pixel: number): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let row = Math.max(0, y - RIM); row <= Math.min(height - 1, y + RIM); row++) {
    for (let column = Math.max(0, x - RIM); column <= Math.min(width - 1, x + RIM); column++) {
      if ((rgba[(row * width + column) * 4 + 3] ?? 0) >= EDGE) return true;
    }
  }
  return false;
}
