/**
 * Decodes PNG files without a canvas. The pixels equal those of the command, bit for bit.
 *
 * The decoder decompresses without a limit. So it gets no profiles, and only as much pixel data as the size needs.
 */

import { inflateSync } from 'node:zlib';
import { type DecodedPng, decode } from 'fast-png';
import type { Pixels } from '../compute/solution';
import { orientationOf } from '../io/formats/exif';
import { latin } from '../io/formats/latin';
import { SIGNATURE } from '../io/png_chunk';
import { turned } from '../io/turn';

/** The upright picture in straight alpha. An animated PNG shows its default picture. @throws Error if it is damaged. */
export function pngPixels(file: ArrayBuffer): Pixels {
  const chunks = chunksOf(file);
  checkPixels(chunks);
  const needed = chunks.filter(({ name }) => NEEDED.includes(name)).map(({ whole }) => whole);
  const png = decode(Buffer.concat([SIGNATURE, ...needed]), { checkCrc: true });
  return turned({ width: png.width, height: png.height, rgba: rgbaOf(png) }, recordedOrientation(chunks));
}

/** The chunks that pixels depend on. */
const NEEDED = ['IHDR', 'PLTE', 'tRNS', 'IDAT', 'IEND'];

interface Chunk {
  readonly name: string;
  readonly data: Uint8Array<ArrayBuffer>;
  /** With its length, its name and its checksum. */
  readonly whole: Uint8Array<ArrayBuffer>;
}

/** The chunks up to the first that is cut short. */
function chunksOf(file: ArrayBuffer): readonly Chunk[] {
  const view = new DataView(file);
  const chunks: Chunk[] = [];
  for (let at = SIGNATURE.length; at + 12 <= view.byteLength; ) {
    const end = at + 12 + view.getUint32(at);
    if (end > view.byteLength) break;
    const whole = new Uint8Array(file, at, end - at);
    chunks.push({ name: latin(view, at + 4, 4), data: whole.subarray(8, -4), whole });
    at = end;
  }
  return chunks;
}

/** Samples of a pixel by colour type (PNG, 3rd edition, table 8). */
const SAMPLES: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** @throws Error if the pixels unfold to more bytes than their size needs. */
function checkPixels(chunks: readonly Chunk[]): void {
  const header = chunks[0]?.data;
  if (!header || header.length < 13) return;
  const view = new DataView(header.buffer, header.byteOffset);
  const [width, height] = [view.getUint32(0), view.getUint32(4)];
  const row = Math.ceil((width * (SAMPLES[view.getUint8(9)] ?? 4) * view.getUint8(8)) / 8);
  // Interlaced, there are up to twice as many rows. Each has a byte for its filter, and may end within a byte.
  const maxOutputLength = row * height + 4 * height + 16;
  const deflated = Buffer.concat(chunks.filter(({ name }) => name === 'IDAT').map(({ data }) => data));
  try {
    inflateSync(deflated, { maxOutputLength });
  } catch (error) {
    // The decoder reports any other fault.
    if ((error as NodeJS.ErrnoException).code === 'ERR_BUFFER_TOO_LARGE')
      throw new Error('its pixels unfold to more than its size', { cause: error });
  }
}

function rgbaOf(png: DecodedPng): Uint8Array<ArrayBuffer> {
  const { width, height, palette, channels, depth, transparency } = png;
  const values = unpacked(png);
  const rgba = new Uint8Array(width * height * 4);
  const isGrey = channels < 3;
  const hasAlpha = channels % 2 === 0;
  // Samples of less than eight bits are stretched, and those of sixteen are rounded.
  const most = 2 ** depth - 1;
  const byte = (value: number) => Math.floor((value * 255 + (most >> 1)) / most);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const from = pixel * channels;
    const at = pixel * 4;
    if (palette) {
      const colour = palette[values[pixel] ?? 0];
      if (!colour) throw new Error('a colour is not in the palette');
      rgba.set(colour, at);
      rgba[at + 3] = colour[3] ?? 255;
      continue;
    }
    for (let k = 0; k < 3; k++) rgba[at + k] = byte(values[from + (isGrey ? 0 : k)] ?? 0);
    const last = values[from + channels - 1] ?? 0;
    const isKey = transparency?.every((value, k) => value === values[from + k]) ?? false;
    rgba[at + 3] = hasAlpha ? byte(last) : isKey ? 0 : 255;
  }
  return rgba;
}

/** The samples, one per element. */
function unpacked({ data, depth, width, height, channels }: DecodedPng): ArrayLike<number> {
  if (depth >= 8) return data;
  const row = width * channels;
  const bytes = Math.ceil((row * depth) / 8);
  const values = new Uint8Array(row * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < row; x++) {
      const bit = x * depth;
      const byte = data[y * bytes + (bit >> 3)] ?? 0;
      values[y * row + x] = (byte >> (8 - depth - (bit & 7))) & (2 ** depth - 1);
    }
  }
  return values;
}

/** The orientation in the EXIF data of a PNG. */
function recordedOrientation(chunks: readonly Chunk[]) {
  const exif = chunks.find(({ name }) => name === 'eXIf')?.data;
  return exif ? orientationOf(new DataView(exif.buffer, exif.byteOffset, exif.length)) : 1;
}
