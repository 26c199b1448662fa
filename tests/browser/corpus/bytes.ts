/** Parts of files. */

export type Bytes = readonly number[];

export const latin = (text: string): Bytes => [...text].map((letter) => letter.charCodeAt(0));
export const big16 = (value: number): Bytes => [(value >> 8) & 255, value & 255];
export const big32 = (value: number): Bytes => [...big16(value >>> 16), ...big16(value & 0xffff)];
export const little16 = (value: number): Bytes => [value & 255, (value >> 8) & 255];
export const little24 = (value: number): Bytes => [...little16(value & 0xffff), (value >> 16) & 255];
export const little32 = (value: number): Bytes => [...little16(value & 0xffff), ...little16(value >>> 16)];

/** A colour: red, green, blue, alpha. */
export type Colour = readonly [number, number, number, number];

export const RED: Colour = [255, 0, 0, 255];
export const GREEN: Colour = [0, 255, 0, 255];
export const BLUE: Colour = [0, 0, 255, 255];
export const YELLOW: Colour = [255, 255, 0, 255];
export const MAGENTA: Colour = [255, 0, 255, 255];
export const CYAN: Colour = [0, 255, 255, 255];

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Rows from the top. */
  readonly colours: readonly Colour[];
}

/** Every orientation of this picture has another size or another colour at its upper left. */
export const FLAG: Pixels = { width: 3, height: 2, colours: [RED, GREEN, BLUE, YELLOW, MAGENTA, CYAN] };

export const flat = (colour: Colour, width = 3, height = 2): Pixels => ({
  width,
  height,
  colours: new Array<Colour>(width * height).fill(colour),
});

/** EXIF data with an orientation, in the byte order of Intel (II) or Motorola (MM). */
export function exif(orientation: number, order: 'II' | 'MM' = 'II'): Bytes {
  const [short, long] = order === 'II' ? [little16, little32] : [big16, big32];
  const entry = [...short(0x112), ...short(3), ...long(1), ...short(orientation), ...short(0)];
  return [...latin(order), ...short(42), ...long(8), ...short(1), ...entry, ...long(0)];
}
