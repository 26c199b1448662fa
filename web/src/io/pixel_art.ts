/** Tells pixel art from other pictures, so that its pixels stay what they are when it bends. */
import type { Rgba } from './pixels';

const MOST_SIDE = 256;
/** Few enough that smoothed edges, which have a shade for every step, are none. */
const MOST_COLOURS = 64;

/** Whether a picture is small enough for pixel art. */
export const isSmall = ({ width, height }: Pick<Rgba, 'width' | 'height'>): boolean =>
  Math.max(width, height) <= MOST_SIDE;

/** Whether a picture is small, of few colours, and nowhere translucent. */
export function isPixelArt(picture: Rgba): boolean {
  if (!isSmall(picture)) return false;
  const { rgba } = picture;
  const colours = new Set<number>();
  for (let at = 0; at < rgba.length; at += 4) {
    const [r = 0, g = 0, b = 0, alpha = 0] = rgba.subarray(at, at + 4);
    if (alpha === 0) continue;
    if (alpha < 255) return false;
    colours.add((r << 16) | (g << 8) | b);
    if (colours.size > MOST_COLOURS) return false;
  }
  return true;
}
