/**
 * PNG files, written in straight alpha: what the solver gives is what the file holds, to the byte.
 *
 * Compressing takes about 0.1 s per million pixels, so a worker does it, which loads with the first export.
 */

/** @param rgba Straight alpha, rows from the top. */
export async function encodePng(width: number, height: number, rgba: Uint8Array): Promise<Blob> {
  const worker = new Worker(new URL('./worker/png.ts', import.meta.url), { type: 'module' });
  try {
    const bytes = await new Promise<Uint8Array<ArrayBuffer>>((resolve, reject) => {
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = (event) => reject(new Error(`The PNG could not be written: ${event.message}`));
      worker.postMessage({ width, height, rgba });
    });
    return new Blob([bytes], { type: 'image/png' });
  } finally {
    worker.terminate();
  }
}
