/** Compares pictures, and attaches them to the test's report. */
import type { TestInfo } from '@playwright/test';
import { type DecodedPng, decode, encode } from 'fast-png';
import pixelmatch from 'pixelmatch';

/** The difference of two pictures in 255ths, over the pixels that are opaque in both. */
export interface Difference {
  readonly mean: number;
  /** Fraction of pixels within 8/255 in every channel. */
  readonly close: number;
  readonly opaque: number;
}

/** Compares two PNG files given in base64; attaches both and their difference to the test. */
export async function difference(actual: string, expected: string, info: TestInfo): Promise<Difference> {
  const [a, b] = [decode(Buffer.from(actual, 'base64')), decode(Buffer.from(expected, 'base64'))];
  const { width, height } = a;
  if (width !== b.width || height !== b.height) {
    throw new Error(`Expected ${b.width} × ${b.height} px, found ${width} × ${height} px.`);
  }
  const marked = new Uint8Array(width * height * 4);
  pixelmatch(a.data as Uint8Array, b.data as Uint8Array, marked, width, height, { threshold: 8 / 255 });
  await attach(info, 'actual', Buffer.from(actual, 'base64'));
  await attach(info, 'expected', Buffer.from(expected, 'base64'));
  await attach(info, 'difference', Buffer.from(encode({ width, height, data: marked, channels: 4 })));
  const result = measured(a.data, b.data);
  info.annotations.push({ type: 'difference', description: JSON.stringify(result) });
  return result;
}

function measured(a: ArrayLike<number>, b: ArrayLike<number>): Difference {
  let [opaque, sum, close] = [0, 0, 0];
  for (let pixel = 0; pixel < a.length; pixel += 4) {
    if (a[pixel + 3] !== 255 || b[pixel + 3] !== 255) continue;
    const apart = [0, 1, 2].map((channel) => Math.abs((a[pixel + channel] ?? 0) - (b[pixel + channel] ?? 0)));
    opaque += 1;
    sum += apart.reduce((total, value) => total + value, 0) / 3;
    if (Math.max(...apart) <= 8) close += 1;
  }
  return { mean: sum / opaque, close: close / opaque, opaque };
}

/**
 * The fraction of pixels of a PNG file in base64 that have no similar pixel within a distance in another one. It is
 * small if nothing has moved farther.
 */
export function movedFarther(before: string, after: string, distance: number): number {
  const [a, b] = [before, after].map((file) => decode(Buffer.from(file, 'base64'))) as [
    DecodedPng,
    DecodedPng,
  ];
  const apart = (from: number, to: number) =>
    Math.max(
      ...[0, 1, 2, 3].map((channel) => Math.abs((a.data[from + channel] ?? 0) - (b.data[to + channel] ?? 0))),
    );
  const isKnown = (x: number, y: number) => {
    const reach = Math.ceil(distance);
    for (let dy = -reach; dy <= reach; dy++)
      for (let dx = -reach; dx <= reach; dx++) {
        const [px, py] = [x + dx, y + dy];
        const isInside = px >= 0 && py >= 0 && px < a.width && py < a.height;
        if (isInside && apart(4 * (py * a.width + px), 4 * (y * b.width + x)) <= 48) return true;
      }
    return false;
  };
  let lost = 0;
  for (let y = 0; y < b.height; y++) for (let x = 0; x < b.width; x++) if (!isKnown(x, y)) lost += 1;
  return lost / (b.width * b.height);
}

const attach = (info: TestInfo, name: string, body: Buffer) =>
  info.attach(name, { body, contentType: 'image/png' });
