import { describe, expect, it } from 'vitest';
import { jpegHeader, probes } from './jpeg';

const latin = (text: string) => [...text].map((c) => c.charCodeAt(0));
const ended = (...parts: number[][]) => {
  const bytes = Uint8Array.from([0xff, 0xd8, ...parts.flat()]);
  return jpegHeader(new DataView(bytes.buffer));
};

/** A segment that looks like the end of a thumbnail. */
const THUMBNAIL = [0xff, 0xe1, 0, 6, 0xff, 0xd9, 0, 0];
const frame = (marker: number) => [0xff, marker, 0, 11, 8, 0, 30, 0, 40, 1, 7, 0x11, 0];
/** A scan with a stuffed byte and a restart. */
const scan = (first = 0, last = 63, bits = 0) => [
  ...[0xff, 0xda, 0, 8, 1, 7, 0, first, last, bits],
  ...latin('abc\xff\0\xff\xd3def'),
];
const END = [0xff, 0xff, 0xd9];
const SIZE = { width: 40, height: 30 };

describe('jpegHeader', () => {
  it('reads the size of a JPEG, and takes no end of a thumbnail for its own', () => {
    expect(ended(THUMBNAIL, frame(0xc0), scan(), END)).toEqual({ size: SIZE, end: 'found', moves: false });
    expect(ended(THUMBNAIL, frame(0xc0))).toEqual({ size: SIZE, end: 'missing', moves: false });
    expect(ended(THUMBNAIL).end).toBe('missing');
    expect(ended([0xff, 0xe1, 0xff, 0xff, 1]).end).toBe('missing');
  });

  it('passes over stray bytes between segments, as decoders do', () => {
    expect(ended(THUMBNAIL, [0, 0], frame(0xc2), [0], scan(), END)).toMatchObject({
      size: SIZE,
      end: 'found',
    });
  });

  it('finds the end of the last scan of a file without an end marker', () => {
    const length = 2 + frame(0xc0).length + scan().length;
    expect(ended(frame(0xc0), scan()).end).toBe(length);
    expect(ended(frame(0xc0), scan(), [0xff, 0xe5, 0, 4, 1, 2]).end).toBe(length);
    expect(ended(frame(0xc0), scan(), [0xff, 0xe5, 0xff]).end).toBe(length);
  });

  it('needs the scans of all bits of a progressive file', () => {
    const scans = [
      scan(0, 0, 0x01),
      scan(1, 63, 0x02),
      scan(0, 0, 0x10),
      scan(1, 63, 0x21),
      scan(1, 63, 0x10),
    ];
    for (const count of scans.keys()) {
      expect(ended(frame(0xc2), scans.slice(0, count).flat()).end).toBe('missing');
    }
    expect(ended(frame(0xc2), scans.flat()).end).toBe(2 + frame(0xc2).length + scans.flat().length);
  });
});

it('probes end with a marker behind the scan, without and with filler', async () => {
  const file = Uint8Array.of(1, 2, 3, 4).buffer;
  const probed = await Promise.all(
    probes(file, 3).map(async (probe) => [...new Uint8Array(await probe.arrayBuffer())]),
  );
  const fillers = [[], new Array(64).fill(0x33), new Array(64).fill(0xcc)];
  expect(probed).toEqual(fillers.map((filler) => [1, 2, 3, ...filler, 0xff, 0xd9]));
});
