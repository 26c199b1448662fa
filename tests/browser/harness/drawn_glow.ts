import { encodePng } from './encoded';

const SIZE = 256;
const DISCS = [90, 166];
const GLOW = [40, 200, 255];
const DISC = [240, 180, 40];
/** The width of the rim of a disc, between those of an upright and a diagonal edge that are drawn without steps. */
const RIM = 1.25;

/**
 * Draws two discs that a thin gap parts, with a soft glow around them and a spark in it. It is computed, since the CPU
 * and the graphics card draw the rims of a canvas differently.
 */
export function drawnGlow(): Promise<Blob> {
  const rgba = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 0; y < SIZE; y++)
    for (let x = 0; x < SIZE; x++) rgba.set(pixel(x + 0.5, y + 0.5), (y * SIZE + x) * 4);
  return encodePng(SIZE, SIZE, rgba);
}

function pixel(x: number, y: number): number[] {
  const distances = DISCS.map((middle) => Math.hypot(x - middle, y - 128));
  const glows = distances.map((distance) => [GLOW, 0.7 * clamped((84 - distance) / 48)] as const);
  const discs = distances.map((distance) => [DISC, clamped((37 - distance) / RIM + 0.5)] as const);
  const spark = [DISC, Math.abs(x - 127) < 1 && Math.abs(y - 21) < 1 ? 1 : 0] as const;
  let [colour, alpha] = [[0, 0, 0], 0];
  for (const [over, share] of [...glows, ...discs, spark]) {
    colour = colour.map((value, k) => value * (1 - share) + (over[k] ?? 0) * share);
    alpha = alpha * (1 - share) + share;
  }
  return [...colour.map((value) => Math.round(value / (alpha || 1))), Math.round(alpha * 255)];
}

const clamped = (value: number): number => Math.min(Math.max(value, 0), 1);
