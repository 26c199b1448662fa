/** Writes drawings to files and canvases, band by band. */
import type { Drawing } from '../compute/drawing';
import { putRows } from '../io/canvas';
import { type FileSettings, PictureFile } from '../io/encoder';

/** How to follow and to stop something that takes time. */
export interface Following {
  readonly signal?: AbortSignal | undefined;
  /** Called with the fraction that is done, from 0 to 1. */
  readonly onProgress?: ((fraction: number) => void) | undefined;
}

/** The part of the time that drawing takes, where the browser encodes the whole picture at the end. */
const DRAWN = 0.8;

/**
 * Returns a file of a drawing.
 *
 * @throws The reason of the signal; Error if the file cannot be written.
 */
export async function writtenFile(
  asked: Promise<Drawing>,
  settings: Omit<FileSettings, 'width' | 'height'>,
  { signal, onProgress }: Following,
): Promise<Blob> {
  const drawing = await opened(asked, signal);
  const { width, height } = drawing;
  const share = settings.type === 'image/png' ? 1 : DRAWN;
  const file = new PictureFile({ ...settings, width, height });
  let rows = 0;
  try {
    await takeBands(drawing, signal, async (band) => {
      rows += band.length / width / 4;
      await file.write(band);
      onProgress?.((share * rows) / height);
    });
    return await unlessAborted(file.finish(), signal);
  } finally {
    file.dispose();
  }
}

/**
 * Puts a drawing on a canvas, which gets its size.
 *
 * @throws The reason of the signal; Error if the browser cannot draw on a canvas of this size.
 */
export async function drawOn(
  canvas: HTMLCanvasElement,
  asked: Promise<Drawing>,
  signal?: AbortSignal,
): Promise<void> {
  const drawing = await opened(asked, signal);
  const { width, height } = drawing;
  Object.assign(canvas, { width, height });
  let top = 0;
  await takeBands(drawing, signal, async (band) => {
    putRows(canvas, top, band);
    top += band.length / width / 4;
  });
}

/** The requested drawing. One that comes too late is released. */
function opened(asked: Promise<Drawing>, signal: AbortSignal | undefined): Promise<Drawing> {
  asked.then(
    (drawing) => signal?.aborted && drawing.release(),
    () => {},
  );
  return unlessAborted(asked, signal);
}

async function takeBands(
  drawing: Drawing,
  signal: AbortSignal | undefined,
  take: (band: Uint8Array<ArrayBuffer>) => Promise<void>,
): Promise<void> {
  const bands = drawing.bands();
  try {
    for (;;) {
      const { value, done } = await unlessAborted(bands.next(), signal);
      if (done) return;
      await unlessAborted(take(value), signal);
    }
  } finally {
    // Not awaited: a band that is being drawn ends first.
    bands.return().catch(() => {});
  }
}

/** The promise, or the reason of the signal as soon as it is aborted. */
export async function unlessAborted<T>(promise: Promise<T>, signal: AbortSignal | undefined): Promise<T> {
  if (!signal) return promise;
  // Nobody awaits the promise after that.
  promise.catch(() => {});
  signal.throwIfAborted();
  const settled = new AbortController();
  const aborted = new Promise<never>((_, reject) =>
    signal.addEventListener('abort', () => reject(signal.reason), { signal: settled.signal }),
  );
  try {
    return await Promise.race([promise, aborted]);
  } finally {
    settled.abort();
  }
}
