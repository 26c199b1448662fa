/** From which alpha on a picture is warped, so that nothing that can be seen is left out. */

/** Half way up a hard edge, or one that fades within a few pixels: the outline runs where the eye sees it. */
const EDGE = 128;
/** What the solver draws beyond the outline, pixels: the rest of such an edge (`WIDTH` in `sample/rim.rs`). */
const RIM = 3;
/** Alpha below this is not seen. */
const FAINT = 6;
/** So many faint pixels beyond the rim are a shadow or a veil, fewer are dust. */
const DUST = 64;

interface Rgba {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

/** The threshold, in (0, 1]; `null` where the picture is opaque. Soft shadows and veils ask for a low one. */
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

/** Whether the rim of something that is more than half opaque reaches a pixel. */
function isNearEdge({ width, height, rgba }: Rgba, pixel: number): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let row = Math.max(0, y - RIM); row <= Math.min(height - 1, y + RIM); row++) {
    for (let column = Math.max(0, x - RIM); column <= Math.min(width - 1, x + RIM); column++) {
      if ((rgba[(row * width + column) * 4 + 3] ?? 0) >= EDGE) return true;
    }
  }
  return false;
}
