/** A field as an image: colours by its values, and isolines. */
import { packed, type Rgb } from './colours';
import type { PixelMap } from './pixel_map';

/** Colours of the values from 0 to `most`. */
export interface Ramp {
  readonly most: number;
  readonly at: (value: number) => Rgb;
}

export interface Isolines {
  readonly field: Float64Array;
  /** The first level, and the distance to each next one. */
  readonly step: number;
  /** The last level, where lines end before the largest value. */
  readonly most?: number;
  readonly colour: Rgb;
  /** Device pixels. */
  readonly width: number;
}

/** The number of distinct colours of a ramp. */
const SHADES = 256;

/** @param isolines The last ones lie on top. */
export function fieldImage(
  map: PixelMap,
  field: Float64Array,
  ramp: Ramp,
  isolines: readonly Isolines[],
): ImageData {
  const image = new ImageData(map.width, map.height);
  const values = map.values(field);
  const shades = Uint32Array.from({ length: SHADES + 1 }, (_, shade) =>
    packed(ramp.at((ramp.most * shade) / SHADES)),
  );
  const pixels = new Uint32Array(image.data.buffer);
  const factor = SHADES / ramp.most;
  for (let pixel = 0; pixel < pixels.length; pixel++) {
    const value = values[pixel] as number;
    if (value >= 0) pixels[pixel] = shades[Math.min(SHADES, (value * factor + 0.5) | 0)] as number;
  }
  for (const lines of isolines) {
    drawLines(image, lines.field === field ? values : map.values(lines.field), lines);
  }
  return image;
}

/** A pixel is covered by a level as far as its value is near to it, relative to the slope of the field. */
function drawLines({ data, width }: ImageData, values: Float32Array, lines: Isolines): void {
  const { step, most = Number.POSITIVE_INFINITY, colour } = lines;
  const reach = lines.width / 2 + 0.5;
  for (let pixel = 0; pixel < values.length; pixel++) {
    const value = values[pixel] as number;
    // Outside the shape.
    if (!(value >= 0)) continue;
    const nearest = Math.min(most, step * Math.max(1, Math.round(value / step)));
    const x = difference(values[pixel - 1] as number, value, values[pixel + 1] as number);
    const y = difference(values[pixel - width] as number, value, values[pixel + width] as number);
    const cover = reach - Math.abs(value - nearest) / Math.max(Math.sqrt(x * x + y * y), 1e-12);
    if (cover > 0) paint(data, pixel, colour, Math.min(cover, 1));
  }
}

/** A difference of neighbours, across the rim of the shape to the only one. Outside it, values are NaN. */
function difference(before: number, value: number, after: number): number {
  if (before >= 0) return after >= 0 ? (after - before) / 2 : value - before;
  return after >= 0 ? after - value : 0;
}

/** Paints over an opaque pixel. */
export function paint(data: Uint8ClampedArray, pixel: number, colour: Rgb, opacity: number): void {
  const at = 4 * pixel;
  data[at] = (data[at] as number) * (1 - opacity) + colour[0] * opacity;
  data[at + 1] = (data[at + 1] as number) * (1 - opacity) + colour[1] * opacity;
  data[at + 2] = (data[at + 2] as number) * (1 - opacity) + colour[2] * opacity;
}
