/** Detects pixel art, which is warped without mixing the colours of its pixels. */
import type { Rgba } from './pixels';

const MAX_SIDE = 256;
/** Pictures with antialiased edges have more colours. */
const MAX_COLOURS = 64;

/** Whether a picture is small enough for pixel art. */
export const isSmall = ({ width, height }: Pick<Rgba, 'width' | 'height'>): boolean =>
  Math.max(width, height) <= MAX_SIDE;

/** Whether a picture is small, has few colours and no translucent pixel. */
export function isPixelArt(picture: Rgba): boolean {
  if (!isSmall(picture)) return false;
  const { rgba } = picture;
  const colours = new Set<number>();
  for (let at = 0; at < rgba.length; at += 4) {
    const [r = 0, g = 0, b = 0, alpha = 0] = rgba.subarray(at, at + 4);
    if (alpha === 0) continue;
    if (alpha < 255) return false;
    colours.add((r << 16) | (g << 8) | b);
    if (colours.size > MAX_COLOURS) return false;
  }
  return true;
}
