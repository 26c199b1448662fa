/** Pictures with their pixels at hand. */
import type { PixelSource } from '../../../web/src/compute/solution';
import { decodePicture as decode } from '../../../web/src/io/decode';
import { openPicture } from '../../../web/src/io/open_picture';
import { pagePlatform } from '../../../web/src/io/page_platform';

export function pixelSource(width: number, height: number, rgba: Uint8Array): PixelSource {
  return { width, height, sendTo: (port) => port.postMessage(rgba) };
}

/** Decodes a picture in the page, as in browsers whose workers cannot. */
export async function decodePicture(file: Blob) {
  const decoded = await decode(file, pagePlatform, new AbortController().signal);
  const { width, height, rgba } = decoded;
  return { ...decoded, preview: null, ...pixelSource(width, height, rgba) };
}

/** Opens a picture as the editor does, and fetches its pixels from the worker. */
export async function openedPicture(file: Blob, signal = new AbortController().signal) {
  const { facts, texture, pixels, release } = await openPicture(file, signal);
  const { port1, port2 } = new MessageChannel();
  const received = new Promise<Uint8Array<ArrayBuffer>>((resolve) => {
    port1.onmessage = ({ data }) => resolve(data);
  });
  pixels.sendTo(port2);
  const rgba = await received;
  port1.close();
  const { bitmap, preview } = texture;
  const [shown, previewed] = [bitmap, preview].map((copy) => copy && [copy.width, copy.height]);
  release();
  return { ...facts, rgba, shown, previewed };
}
