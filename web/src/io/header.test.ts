import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { readHeader } from './header';

const bytes = (...parts: (string | number[])[]): ArrayBuffer =>
  Uint8Array.from(
    parts.flatMap((part) => (typeof part === 'string' ? [...part].map((c) => c.charCodeAt(0)) : part)),
  ).buffer;

const SIGNATURE = '\x89PNG\r\n\x1a\n';
const IHDR = [0, 0, 0, 13, ...'IHDR'].map((v) => (typeof v === 'string' ? v.charCodeAt(0) : v));
const IEND = bytes([0, 0, 0, 0], 'IEND', [1, 2, 3, 4]);

describe('readHeader', () => {
  const png = [SIGNATURE, IHDR, [0, 0, 0x4e, 0x20, 0, 0, 0, 20, 8, 6, 0, 0, 0, 1, 2, 3, 4]];

  it('reads the size of a PNG and finds its end', () => {
    const whole = bytes(...png, [...new Uint8Array(IEND)]);
    expect(readHeader(whole)).toEqual({ kind: 'png', size: { width: 20_000, height: 20 }, complete: true });
    expect(readHeader(bytes(...png)).complete).toBe(false);
    expect(readHeader(bytes(SIGNATURE))).toEqual({ kind: 'png', size: undefined, complete: false });
  });

  it('reads a real PNG', () => {
    const file = readFileSync(new URL('../../public/samples/gingerbread.png', import.meta.url));
    const whole = file.buffer.slice(file.byteOffset, file.byteOffset + file.length) as ArrayBuffer;
    const header = readHeader(whole);
    expect(header).toMatchObject({ kind: 'png', complete: true });
    expect(header.size?.width).toBeGreaterThanOrEqual(1024);
    expect(readHeader(whole.slice(0, -20)).complete).toBe(false);
  });

  it('reads the size of a JPEG, and takes no end of a thumbnail for its own', () => {
    const start = [0xff, 0xd8, 0xff, 0xe1, 0, 6, 0xff, 0xd9, 0, 0];
    const frame = [0xff, 0xc2, 0, 11, 8, 0, 30, 0, 40, 1, 1, 0x11, 0];
    const scan = [0xff, 0xda, 0, 4, 0, 0, 7, 7, 7];
    expect(readHeader(bytes(start, frame, scan, [0xff, 0xd9]))).toEqual({
      kind: 'jpeg',
      size: { width: 40, height: 30 },
      complete: true,
    });
    // Cameras leave stray bytes between segments; decoders pass over them.
    expect(readHeader(bytes(start, [0, 0], frame, [0], scan, [0xff, 0xd9]))).toEqual({
      kind: 'jpeg',
      size: { width: 40, height: 30 },
      complete: true,
    });
    expect(readHeader(bytes(start, frame, scan)).complete).toBe(false);
    expect(readHeader(bytes(start)).complete).toBe(false);
  });

  it('reads the size of each kind of WebP', () => {
    const webp = (length: number, fourcc: string, data: number[]) =>
      readHeader(bytes('RIFF', [length, 0, 0, 0], 'WEBP', fourcc, [10, 0, 0, 0], data));
    const lossy = [0, 0, 0, 0x9d, 0x01, 0x2a, 64, 1, 200, 0];
    expect(webp(22, 'VP8 ', lossy)).toEqual({
      kind: 'webp',
      size: { width: 320, height: 200 },
      complete: true,
    });
    expect(webp(200, 'VP8 ', lossy).complete).toBe(false);
    const lossless = [0x2f, 0xff, 0xc0, 0x3f, 0, 0, 0, 0, 0, 0];
    expect(webp(22, 'VP8L', lossless).size).toEqual({ width: 256, height: 256 });
    const extended = [0x10, 0, 0, 0, 0xff, 0, 0, 0x7f, 0, 0];
    expect(webp(22, 'VP8X', extended).size).toEqual({ width: 256, height: 128 });
  });

  it('recognizes SVG drawings', () => {
    expect(readHeader(bytes('<?xml version="1.0"?><svg/>')).kind).toBe('svg');
    expect(readHeader(bytes('  <svg xmlns="…"/>')).kind).toBe('svg');
    expect(readHeader(bytes([0xef, 0xbb, 0xbf], '<svg/>')).kind).toBe('svg');
    expect(readHeader(bytes('hello')).kind).toBe('other');
    expect(readHeader(new ArrayBuffer(0)).kind).toBe('other');
  });
});
