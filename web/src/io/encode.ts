/**
 * Writes PNG files in straight alpha: the file holds exactly the bytes that the solver returns.
 *
 * Compression takes about 0.1 s per million pixels, so it runs in a worker. All editors of a page share the worker.
 */
import { startWorker } from '../start_worker';
import png from './worker/png?worker&url';

let worker: Worker | null = null;

/** Starts the worker ahead of time, so that a later export needs no network. */
export function preparePng(): Worker {
  if (worker) return worker;
  const started = startWorker(png);
  // After a failure, the next call starts another worker.
  started.addEventListener('error', () => {
    if (worker === started) worker = null;
    started.terminate();
  });
  worker = started;
  return started;
}

/**
 * Returns a new canvas with the picture on it. Canvases premultiply, so translucent colours are rounded.
 *
 * @param rgba Straight alpha, rows from the top.
 */
export function pictureCanvas(
  document: Document,
  width: number,
  height: number,
  rgba: Uint8Array<ArrayBuffer>,
): HTMLCanvasElement {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const bytes = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser cannot draw on a 2D canvas.');
  context.putImageData(new ImageData(bytes, width, height), 0, 0);
  return canvas;
}

/**
 * Returns a PNG file of a picture.
 *
 * @param rgba Straight alpha, rows from the top. Transferred to the worker: pass a copy to keep the original.
 * @throws Error if the worker fails or does not load.
 */
export async function encodePng(width: number, height: number, rgba: Uint8Array<ArrayBuffer>): Promise<Blob> {
  const encoder = preparePng();
  const { port1: receiver, port2: sender } = new MessageChannel();
  const finished = new AbortController();
  try {
    const bytes = await new Promise<Uint8Array<ArrayBuffer>>((resolve, reject) => {
      const fail = () =>
        reject(
          new Error('The PNG could not be written: the encoder failed or did not load. Reload the page.'),
        );
      receiver.onmessage = ({ data }) => resolve(data);
      encoder.addEventListener('error', fail, { signal: finished.signal });
      encoder.postMessage({ width, height, rgba, to: sender }, [sender, rgba.buffer]);
    });
    return new Blob([bytes], { type: 'image/png' });
  } finally {
    finished.abort();
    receiver.close();
  }
}
