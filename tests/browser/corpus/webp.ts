/** Writes WebP files: lossless pictures whose channels are 0 or 255, and their containers. */
import { type Bytes, FLAG, latin, little16, little24, little32, type Pixels } from './bytes';

export const chunk = (name: string, data: Bytes): Bytes => [
  ...latin(name),
  ...little32(data.length),
  ...data,
  ...new Array(data.length % 2).fill(0),
];

export const riff = (chunks: Bytes, size = chunks.length + 4): Bytes => [
  ...latin('RIFF'),
  ...little32(size),
  ...latin('WEBP'),
  ...chunks,
];

type Bits = readonly [value: number, length: number];

/** Packs bits from the lowest. */
export function packed(bits: readonly Bits[]): Bytes {
  const text = bits.flatMap(([value, length]) => Array.from({ length }, (_, i) => (value >> i) & 1));
  return Array.from({ length: Math.ceil(text.length / 8) }, (_, byte) =>
    text.slice(byte * 8, byte * 8 + 8).reduce((sum, bit, i) => sum + (bit << i), 0),
  );
}

/** A code of one bit for the values 0 and 255. */
const TWO: readonly Bits[] = [
  [0b111, 3],
  [0, 8],
  [255, 8],
];
/** A code of no bits for distances, which no pixel uses. */
const NONE: readonly Bits[] = [[0b0001, 4]];

export function lossless({ width, height, colours }: Pixels = FLAG): Bytes {
  const pixels = colours.flatMap(([r, g, b, a]) => [g, r, b, a].map((value): Bits => [value & 1, 1]));
  const size: Bits[] = [
    [width - 1, 14],
    [height - 1, 14],
  ];
  // Alpha is used; version 0; no transforms, no colour cache and one set of codes.
  const flags: Bits[] = [
    [1, 1],
    [0, 3],
    [0, 3],
  ];
  const codes = [...TWO, ...TWO, ...TWO, ...TWO, ...NONE];
  return chunk('VP8L', [0x2f, ...packed([...size, ...flags, ...codes, ...pixels])]);
}

export const FLAGS = { profile: 0x20, alpha: 0x10, exif: 0x08, xmp: 0x04, animation: 0x02 };

export const extended = (flags: number, chunks: Bytes, { width, height } = FLAG): Bytes =>
  riff([...chunk('VP8X', [flags, 0, 0, 0, ...little24(width - 1), ...little24(height - 1)]), ...chunks]);

export const animationControl = chunk('ANIM', [...little32(0), ...little16(0)]);

export const animationFrame = (pixels: Pixels): Bytes =>
  chunk('ANMF', [
    ...[0, 0, pixels.width - 1, pixels.height - 1].flatMap(little24),
    ...little24(1000),
    0,
    ...lossless(pixels),
  ]);
