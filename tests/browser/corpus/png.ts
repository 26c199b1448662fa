/** Writes PNG files. */
import { crc32, deflateSync } from 'node:zlib';
import { type Bytes, big16, big32, FLAG, latin, type Pixels } from './bytes';

export function chunk(name: string, data: Bytes, checksum?: number): Bytes {
  const named = [...latin(name), ...data];
  return [...big32(data.length), ...named, ...big32(checksum ?? crc32(Uint8Array.from(named)))];
}

const SIGNATURE = latin('\x89PNG\r\n\x1a\n');
const END = chunk('IEND', []);

export const header = (width: number, height: number, depth: number, type: number): Bytes =>
  chunk('IHDR', [...big32(width), ...big32(height), depth, type, 0, 0, 0]);

/** Compressed rows without a filter. */
export const compressed = (rows: readonly Bytes[]): Bytes => [
  ...deflateSync(Uint8Array.from(rows.flatMap((row) => [0, ...row]))),
];

const rowsOf = ({ width, height, colours }: Pixels, channels: number): Bytes[] =>
  Array.from({ length: height }, (_, y) =>
    colours.slice(y * width, (y + 1) * width).flatMap((colour) => colour.slice(0, channels)),
  );

export const pixelData = (pixels: Pixels, channels = 4): Bytes => compressed(rowsOf(pixels, channels));

interface Parts {
  readonly pixels?: Pixels;
  /** 3 for RGB, 4 for RGBA. */
  readonly channels?: 3 | 4;
  /** Chunks before and after the pixel data. */
  readonly before?: Bytes;
  readonly after?: Bytes;
  readonly end?: Bytes;
}

export function png({ pixels = FLAG, channels = 4, before = [], after = [], end = END }: Parts = {}): Bytes {
  const type = channels === 4 ? 6 : 2;
  const data = chunk('IDAT', pixelData(pixels, channels));
  return [
    ...SIGNATURE,
    ...header(pixels.width, pixels.height, 8, type),
    ...before,
    ...data,
    ...after,
    ...end,
  ];
}

/** A PNG of other types than RGB and RGBA, with the bytes of its rows. */
export const pngOfType = (
  depth: number,
  type: number,
  rows: readonly Bytes[],
  before: Bytes = [],
  size: readonly [number, number] = [3, 2],
): Bytes => [
  ...SIGNATURE,
  ...header(...size, depth, type),
  ...before,
  ...chunk('IDAT', compressed(rows)),
  ...END,
];

/** 16 bits for each channel. */
export const deepPng = (): Bytes =>
  pngOfType(
    16,
    6,
    rowsOf(FLAG, 4).map((row) => row.flatMap((value) => [value, value])),
  );

export const animation = (frames: number): Bytes => chunk('acTL', [...big32(frames), ...big32(0)]);

/** The control of a frame that covers the picture for a second. */
export const frameControl = (sequence: number, { width, height }: Pixels = FLAG, [x, y] = [0, 0]): Bytes =>
  chunk('fcTL', [
    ...[sequence, width, height, x, y].flatMap((value) => big32(value ?? 0)),
    ...big16(1),
    ...big16(1),
    0,
    0,
  ]);

export const frameData = (sequence: number, pixels: Pixels): Bytes =>
  chunk('fdAT', [...big32(sequence), ...pixelData(pixels)]);
