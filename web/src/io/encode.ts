/**
 * PNG files, written in straight alpha: what the solver gives is what the file holds, to the byte.
 *
 * Compressing takes about 0.1 s per million pixels, so a worker does it, one for all editors of a page.
 */

let worker: Worker | null = null;

/** Loads what encoding takes, so that it needs no network when it is asked for. */
export function preparePng(): Worker {
  if (worker) return worker;
  const made = new Worker(new URL('./worker/png.ts', import.meta.url), { type: 'module' });
  // Where it did not come, another try begins anew.
  made.addEventListener('error', () => {
    if (worker === made) worker = null;
    made.terminate();
  });
  worker = made;
  return made;
}

/** @param rgba Straight alpha, rows from the top. It goes to the worker: whoever needs it longer gives a copy. */
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
