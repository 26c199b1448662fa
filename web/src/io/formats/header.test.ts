import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { readHeader } from './header';
import { withoutExif } from './webp';

const latin = (text: string) => [...text].map((c) => c.charCodeAt(0));

const bytes = (...parts: (string | number[])[]): ArrayBuffer =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? latin(part) : part))).buffer;

const SIGNATURE = '\x89PNG\r\n\x1a\n';
const IHDR = [0, 0, 0, 13, ...latin('IHDR')];
const IEND = bytes([0, 0, 0, 0], 'IEND', [1, 2, 3, 4]);

describe('readHeader', () => {
  const png = [SIGNATURE, IHDR, [0, 0, 0x4e, 0x20, 0, 0, 0, 20, 8, 6, 0, 0, 0, 1, 2, 3, 4]];

  it('reads the size of a PNG and finds its end', () => {
    const whole = bytes(...png, [...new Uint8Array(IEND)]);
    expect(readHeader(whole)).toEqual({
      kind: 'png',
      name: 'png',
      size: { width: 20_000, height: 20 },
      end: 'found',
      moves: false,
    });
    expect(readHeader(bytes(...png)).end).toBe('missing');
    expect(readHeader(bytes(SIGNATURE))).toMatchObject({ kind: 'png', size: undefined, end: 'missing' });
  });

  it('reads a real PNG', () => {
    const file = readFileSync(new URL('../../../public/samples/gingerbread.png', import.meta.url));
    const whole = file.buffer.slice(file.byteOffset, file.byteOffset + file.length) as ArrayBuffer;
    const header = readHeader(whole);
    expect(header).toMatchObject({ kind: 'png', end: 'found' });
    expect(header.size?.width).toBeGreaterThanOrEqual(1024);
    expect(readHeader(whole.slice(0, -20)).end).toBe('missing');
  });

  it('finds animations', () => {
    const control = (frames: number) => [
      0,
      0,
      0,
      8,
      ...latin('acTL'),
      0,
      0,
      0,
      frames,
      0,
      0,
      0,
      0,
      9,
      9,
      9,
      9,
    ];
    const end = [...new Uint8Array(IEND)];
    expect(readHeader(bytes(...png, control(2), end)).moves).toBe(true);
    expect(readHeader(bytes(...png, control(1), end)).moves).toBe(false);

    const screen = ['GIF89a', [4, 0, 3, 0, 0x80, 0, 0], [0, 0, 0, 255, 255, 255]];
    const wait = [0x21, 0xf9, 4, 0, 0, 0, 0, 0];
    const frame = [0x2c, 0, 0, 0, 0, 4, 0, 3, 0, 0x80, 1, 2, 3, 4, 5, 6, 2, 2, 0x4c, 1, 0];
    const still = readHeader(bytes(...screen, wait, frame, [0x3b]));
    expect(still).toMatchObject({ kind: 'gif', size: { width: 4, height: 3 }, moves: false });
    expect(readHeader(bytes(...screen, wait, frame, wait, frame, [0x3b])).moves).toBe(true);

    expect(readHeader(bytes([0, 0, 0, 20], 'ftypavis', [0, 0, 0, 0], 'avif')).moves).toBe(true);
    expect(readHeader(bytes([0, 0, 0, 20], 'ftypavif', [0, 0, 0, 0], 'mif1')).moves).toBe(false);
  });

  it('reads the size of each kind of WebP', () => {
    const webp = (length: number, fourcc: string, data: number[]) =>
      readHeader(bytes('RIFF', [length, 0, 0, 0], 'WEBP', fourcc, [10, 0, 0, 0], data));
    const lossy = [0, 0, 0, 0x9d, 0x01, 0x2a, 64, 1, 200, 0];
    expect(webp(22, 'VP8 ', lossy)).toMatchObject({
      kind: 'webp',
      size: { width: 320, height: 200 },
      end: 'found',
    });
    expect(webp(200, 'VP8 ', lossy).end).toBe('missing');
    const lossless = [0x2f, 0xff, 0xc0, 0x3f, 0, 0, 0, 0, 0, 0];
    expect(webp(22, 'VP8L', lossless).size).toEqual({ width: 256, height: 256 });
    const extended = [0x10, 0, 0, 0, 0xff, 0, 0, 0x7f, 0, 0];
    expect(webp(22, 'VP8X', extended).size).toEqual({ width: 256, height: 128 });
  });

  it('reads the orientation of a WebP', () => {
    const file = (...exif: (string | number[])[]) => {
      const data = [...new Uint8Array(bytes(...exif))];
      const extended = ['VP8X', [10, 0, 0, 0], [8, 0, 0, 0, 1, 0, 0, 1, 0, 0]];
      return bytes(
        'RIFF',
        [data.length + 30, 0, 0, 0],
        'WEBP',
        ...extended,
        'EXIF',
        [data.length, 0, 0, 0],
        data,
      );
    };
    const little = ['II*\0', [8, 0, 0, 0], [1, 0], [0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0]];
    const big = ['MM\0*', [0, 0, 0, 8], [0, 1], [1, 0x12, 0, 3, 0, 0, 0, 1, 0, 8, 0, 0]];
    expect(readHeader(file(...little)).orientation).toBe(6);
    expect(readHeader(file('Exif\0\0', ...big)).orientation).toBe(8);
    expect(readHeader(file('II*\0', [8, 0, 0, 0], [9, 0])).orientation).toBe(1);
    expect(readHeader(withoutExif(file(...little))).orientation).toBeUndefined();
  });

  it('names file types that browsers may not read', () => {
    const nameOf = (...parts: (string | number[])[]) => readHeader(bytes(...parts)).name;
    expect(nameOf('<?xml version="1.0"?><svg/>')).toBe('svg');
    expect(nameOf('  <svg xmlns="…"/>')).toBe('svg');
    expect(nameOf([0xef, 0xbb, 0xbf], '<svg/>')).toBe('svg');
    expect(nameOf('II*\0', [8, 0])).toBe('tiff');
    expect(nameOf('8BPS', [0, 1])).toBe('photoshop');
    expect(nameOf([0, 0, 0, 24], 'ftypheic', [0, 0, 0, 0], 'mif1heic')).toBe('heic');
    expect(nameOf([0, 0, 0, 20], 'ftypmif1', [0, 0, 0, 0], 'avif')).toBe('avif');
    expect(nameOf([0, 0, 0, 20], 'ftypisom', [0, 0, 0, 0], 'isom')).toBeUndefined();
    expect(nameOf('hello')).toBeUndefined();
    expect(readHeader(new ArrayBuffer(0)).kind).toBe('other');
  });
});
