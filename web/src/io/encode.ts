/**
 * PNG files, written in straight alpha: the file holds exactly the bytes that the solver returns.
 *
 * Compressing takes about 0.1 s per million pixels, so a worker does it, one for all editors of a page.
 */
import { startWorker } from '../start_worker';
import png from './worker/png?worker&url';

let worker: Worker | null = null;

/** Loads the worker ahead, so that a later export needs no network. */
export function preparePng(): Worker {
  if (worker) return worker;
  const made = startWorker(png);
  // After a failure, the next call starts another worker.
  made.addEventListener('error', () => {
    if (worker === made) worker = null;
    made.terminate();
  });
  worker = made;
  return made;
}

/**
 * A canvas of this size with a picture on it, which it premultiplies.
 * @param rgba Straight alpha, rows from the top.
 */
export function onCanvas(
  document: Document,
  width: number,
  height: number,
  rgba: Uint8Array<ArrayBuffer>,
): HTMLCanvasElement {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const bytes = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no 2D canvas.');
  context.putImageData(new ImageData(bytes, width, height), 0, 0);
  return canvas;
}

/** @param rgba Straight alpha, rows from the top. Transferred to the worker: pass a copy to keep the original. */
export async function encodePng(width: number, height: number, rgba: Uint8Array<ArrayBuffer>): Promise<Blob> {
  const encoder = preparePng();
  const { port1: here, port2: there } = new MessageChannel();
  const over = new AbortController();
  try {
    const bytes = await new Promise<Uint8Array<ArrayBuffer>>((resolve, reject) => {
      const fail = () =>
        reject(new Error('The PNG could not be written: a part of the editor did not load, or failed.'));
      here.onmessage = ({ data }) => resolve(data);
      encoder.addEventListener('error', fail, { signal: over.signal });
      encoder.postMessage({ width, height, rgba, to: there }, [there, rgba.buffer]);
    });
    return new Blob([bytes], { type: 'image/png' });
  } finally {
    over.abort();
    here.close();
  }
}
