import { deflateSync } from 'node:zlib';
import { decode } from 'fast-png';
import { describe, expect, it } from 'vitest';
import type { PngChunk } from '../encoding';
import { PngFile } from './png_file';

type Paint = (x: number, y: number, channel: number) => number;

const painted = (width: number, height: number, paint: Paint): Uint8Array<ArrayBuffer> =>
  Uint8Array.from({ length: width * height * 4 }, (_, i) =>
    paint((i >> 2) % width, Math.floor(i / 4 / width), i % 4),
  );

/** Writes a picture in pieces of some rows. */
async function written(
  width: number,
  rgba: Uint8Array<ArrayBuffer>,
  rows: number,
  chunks: readonly PngChunk[] = [],
): Promise<Uint8Array> {
  const height = rgba.length / width / 4;
  const file = new PngFile({
    type: 'image/png',
    width,
    height,
    quality: 1,
    background: '#ffffff',
    chunks,
  });
  for (let at = 0; at < height; at += rows)
    await file.write(rgba.slice(at * width * 4, Math.min(height, at + rows) * width * 4));
  return new Uint8Array(await (await file.finish()).arrayBuffer());
}

/** The types of the chunks of a file, in order. */
function types(file: Uint8Array): string[] {
  const found: string[] = [];
  const view = new DataView(file.buffer, file.byteOffset);
  for (let at = 8; at < file.length; at += view.getUint32(at) + 12)
    found.push(String.fromCharCode(...file.subarray(at + 4, at + 8)));
  return found;
}

const PAINTS: Readonly<Record<string, Paint>> = {
  'one colour': () => 77,
  noise: (x, y, channel) => (Math.imul(x * 31 + y * 17 + channel * 7, 2654435761) >>> 11) & 255,
  'a slope to the right': (x, _, channel) => (x * 3 + channel) & 255,
  'a slope down': (_, y, channel) => (y * 5 + channel) & 255,
  'a slope across': (x, y) => (x * 2 + y * 3) & 255,
  'translucent colours': (x, y, channel) => (channel === 3 ? (x + y) & 255 : (x * y) & 255),
};

describe('PngFile', () => {
  it.each(Object.entries(PAINTS))('keeps every byte of %s', async (_, paint) => {
    for (const [width, height, rows] of [
      [1, 1, 1],
      [37, 23, 5],
      [64, 16, 16],
    ] as const) {
      const rgba = painted(width, height, paint);
      const decoded = decode(await written(width, rgba, rows));
      expect([decoded.width, decoded.height, decoded.channels]).toEqual([width, height, 4]);
      expect(Array.from(decoded.data)).toEqual(Array.from(rgba));
    }
  });

  it('does not depend on the pieces in which it is written', async () => {
    const rgba = painted(50, 40, PAINTS.noise as Paint);
    expect(await written(50, rgba, 7)).toEqual(await written(50, rgba, 40));
  });

  it('compresses smooth pictures by its filters', async () => {
    const [width, height] = [400, 300];
    const rgba = painted(width, height, (x, y, channel) =>
      channel === 3 ? 255 : Math.round(128 + 90 * Math.sin(x / 40 + channel) * Math.cos(y / 30)),
    );
    expect((await written(width, rgba, 16)).length).toBeLessThan(0.75 * deflateSync(rgba).length);
  });

  it('holds other chunks before its pixels', async () => {
    const data = new TextEncoder().encode('Title\0wave');
    const file = await written(
      3,
      painted(3, 3, () => 1),
      3,
      [{ type: 'tEXt', data }],
    );
    expect(types(file)).toEqual(['IHDR', 'tEXt', 'IDAT', 'IEND']);
    expect(decode(file, { checkCrc: true }).text).toEqual({ Title: 'wave' });
  });

  it('refuses rows of another length, and an end before the last row', async () => {
    const file = () =>
      new PngFile({
        type: 'image/png',
        width: 4,
        height: 2,
        quality: 1,
        background: '#ffffff',
        chunks: [],
      });
    await expect(file().write(new Uint8Array(9))).rejects.toThrow('not rows of 16');
    const early = file();
    await early.write(new Uint8Array(16));
    await expect(early.finish()).rejects.toThrow('1 rows are missing');
  });
});
