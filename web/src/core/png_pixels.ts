/** Decodes PNG files without a canvas. The pixels equal those of the command, bit for bit. */
import { type DecodedPng, decode } from 'fast-png';
import type { Pixels } from '../compute/solution';
import { orientationOf } from '../io/formats/exif';
import { latin } from '../io/formats/latin';
import { turned } from '../io/turn';

/** The upright picture in straight alpha. An animated PNG shows its default picture. @throws Error if it is damaged. */
export function pngPixels(file: ArrayBuffer): Pixels {
  const png = decode(file, { checkCrc: true });
  return turned({ width: png.width, height: png.height, rgba: rgbaOf(png) }, recordedOrientation(file));
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
function recordedOrientation(file: ArrayBuffer) {
  const view = new DataView(file);
  for (let at = 8; at + 12 <= view.byteLength; at += 12 + view.getUint32(at)) {
    const length = view.getUint32(at);
    if (latin(view, at + 4, 4) === 'eXIf' && at + 12 + length <= view.byteLength) {
      return orientationOf(new DataView(file, at + 8, length));
    }
  }
  return 1;
}
