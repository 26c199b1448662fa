/** Writes JPEG files with one colour for each block of 8 × 8 pixels: no coefficient but the first is ever used. */
import { type Bytes, big16, type Colour, FLAG, latin, type Pixels } from './bytes';

const segment = (marker: number, data: Bytes): Bytes => [0xff, marker, ...big16(data.length + 2), ...data];

export const START: Bytes = [0xff, 0xd8];
export const END: Bytes = [0xff, 0xd9];
export const exifSegment = (exif: Bytes): Bytes => segment(0xe1, [...latin('Exif\0\0'), ...exif]);
export const adobe = (transform: number): Bytes =>
  segment(0xee, [...latin('Adobe'), ...big16(100), 0, 0, 0, 0, transform]);

/** All quantisation by 8: the first coefficient is then the value of the block. */
const QUANTISATION = segment(0xdb, [0, ...new Array(64).fill(8)]);
/** Codes of 4 bits for differences of up to 8 bits, and one code of 1 bit for blocks that end. */
const CODES = segment(0xc4, [
  ...[0x00, 0, 0, 0, 9, ...new Array(12).fill(0), 0, 1, 2, 3, 4, 5, 6, 7, 8],
  ...[0x10, 1, ...new Array(15).fill(0), 0],
]);
const END_OF_BLOCK = [0, 1] as const;

/** A value and its number of bits. */
type Bits = readonly [value: number, length: number];

/** Packs bits from the highest. A byte 255 is followed by 0. */
function packed(bits: readonly Bits[]): Bytes {
  const text = bits
    .map(([value, length]) => (length ? value.toString(2).padStart(length, '0') : ''))
    .join('');
  const bytes = (text.match(/.{1,8}/g) ?? []).map((part) => Number.parseInt(part.padEnd(8, '1'), 2));
  return bytes.flatMap((byte) => (byte === 255 ? [255, 0] : [byte]));
}

function difference(value: number): Bits[] {
  const length = value === 0 ? 0 : Math.floor(Math.log2(Math.abs(value))) + 1;
  return [
    [length, 4],
    [value < 0 ? value + (1 << length) - 1 : value, length],
  ];
}

const SCALES = {
  grey: ([red]: Colour) => [red - 128],
  colour: ([r, g, b]: Colour) =>
    [
      0.299 * r + 0.587 * g + 0.114 * b - 128,
      -0.1687 * r - 0.3313 * g + 0.5 * b,
      0.5 * r - 0.4187 * g - 0.0813 * b,
    ].map((value) => Math.max(-128, Math.min(127, Math.round(value)))),
  plain: ([r, g, b]: Colour) => [r - 128, g - 128, b - 128],
  /** Inverted CMYK without black, as Photoshop writes it. */
  print: ([r, g, b]: Colour) => [r - 128, g - 128, b - 128, 127],
};

interface Parts {
  readonly pixels?: Pixels;
  readonly scale?: keyof typeof SCALES;
  /** Segments before the frame. */
  readonly before?: Bytes;
  readonly end?: Bytes;
  /** A restart marker after each block. */
  readonly restarts?: boolean;
}

const frame = (marker: number, { width, height }: Pixels, components: number): Bytes =>
  segment(marker, [
    ...[8, ...big16(height * 8), ...big16(width * 8), components],
    ...Array.from({ length: components }, (_, i) => [i + 1, 0x11, 0]).flat(),
  ]);

/** The scan header of some components: coefficients from first to last, with bits from high to low. */
const scan = (components: readonly number[], first: number, last: number, high: number, low: number): Bytes =>
  segment(0xda, [components.length, ...components.flatMap((id) => [id, 0]), first, last, (high << 4) | low]);

const idsOf = (values: readonly (readonly number[])[]): number[] => (values[0] ?? []).map((_, i) => i + 1);

export function jpeg(parts: Parts = {}): Bytes {
  const { pixels = FLAG, scale = 'colour', before = [], end = END, restarts = false } = parts;
  const values = pixels.colours.map(SCALES[scale]);
  const ids = idsOf(values);
  const blocks = values.map((block, at) => {
    const last = at === 0 || restarts ? undefined : values[at - 1];
    return block.flatMap((value, i) => [...difference(value - (last?.[i] ?? 0)), END_OF_BLOCK]);
  });
  const data = restarts
    ? blocks.flatMap((bits, i) => [...packed(bits), ...(i + 1 < blocks.length ? [0xff, 0xd0 + (i % 8)] : [])])
    : packed(blocks.flat());
  return [
    ...START,
    ...before,
    ...QUANTISATION,
    ...frame(0xc0, pixels, ids.length),
    ...CODES,
    ...(restarts ? segment(0xdd, big16(1)) : []),
    ...scan(ids, 0, 63, 0, 0),
    ...data,
    ...end,
  ];
}

/** A progressive file: the first coefficients without their lowest bit, these bits, then the empty rest. */
export function progressiveJpeg({ pixels = FLAG, end = END, scans = 5 } = {}): Bytes {
  const values = pixels.colours.map(SCALES.colour);
  const ids = idsOf(values);
  const halves = values.map((block) => block.map((value) => value >> 1));
  const rough = halves.flatMap((block, at) =>
    block.flatMap((value, i) => difference(value - (at === 0 ? 0 : (halves[at - 1]?.[i] ?? 0)))),
  );
  const low = values.flat().map((value): Bits => [value & 1, 1]);
  const rest = packed(values.map(() => END_OF_BLOCK));
  const all = [
    [...scan(ids, 0, 0, 0, 1), ...packed(rough)],
    ...ids.map((id) => [...scan([id], 1, 63, 0, 0), ...rest]),
    [...scan(ids, 0, 0, 1, 0), ...packed(low)],
  ];
  return [
    ...START,
    ...QUANTISATION,
    ...frame(0xc2, pixels, ids.length),
    ...CODES,
    ...all.slice(0, scans).flat(),
    ...end,
  ];
}
