/** PNG files. */
import { plainPng } from '../io/encoding';
import { PngFile } from '../io/worker/png_file';
import type { PixelData } from './types';

/** The bytes of a PNG file. */
export async function pngBytes({ width, height, data }: PixelData): Promise<Uint8Array<ArrayBuffer>> {
  const file = new PngFile(plainPng(width, height));
  await file.write(new Uint8Array(data));
  return new Uint8Array(await (await file.finish()).arrayBuffer());
}
