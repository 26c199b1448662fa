/** Compares pictures, and attaches them to the test's report. */
import type { TestInfo } from '@playwright/test';
import { decode, encode } from 'fast-png';
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

const attach = (info: TestInfo, name: string, body: Buffer) =>
  info.attach(name, { body, contentType: 'image/png' });
