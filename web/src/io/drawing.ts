/**
 * SVG drawings as pixels. A worker reads each drawing first, and refuses one that would take too long to draw.
 *
 * The page renders a drawing of few elements and small filters as an image: there, no script runs and no other file is
 * loaded. A browser cannot be stopped once it draws, so the worker draws all others, without texts.
 */
import { C2WarpError } from '../error';
import { startWorker } from '../start_worker';
import { say } from '../texts/wording';
import type {
  DrawingOrder,
  DrawingReplies,
  DrawingReply,
  DrawingRequest,
  PlainDrawing,
} from './drawing_messages';
import { pictureError } from './picture_error';
import drawing from './worker/drawing?worker&url';

const MODULE = new URL('./generated/drawing_bg.wasm', import.meta.url);

/** A drawing, and a picture of it. */
export interface Drawn {
  readonly file: Blob;
  readonly pixels: Blob;
  /** Texts of the drawing are missing in the picture. */
  readonly lacksTexts: boolean;
}

/**
 * The picture of a drawing; null for a compressed file that is none.
 *
 * @param given a drawing, or a compressed file.
 * @throws C2WarpError if the drawing cannot be shown, or the bytes cannot be read. The reason of the signal.
 */
export async function drawnPicture(given: Blob, signal: AbortSignal): Promise<Drawn | null> {
  const read = await asked('picture', given, signal);
  if (!read) return null;
  const { file, pixels, sized, width, height, lacksTexts } = read;
  return { file, pixels: pixels ?? (await rendered(sized, width, height)), lacksTexts };
}

/**
 * A drawing in the form that can be bent.
 *
 * @throws C2WarpError for a drawing that cannot be read. The reason of the signal.
 */
export async function plainDrawing(file: Blob, signal: AbortSignal): Promise<PlainDrawing> {
  const read = await asked('plain', file, signal);
  if (!read) throw pictureError('picture', say('errors.picture.drawingDamaged'));
  return read;
}

/** The answer of a worker that ends with it; of this thread if the page's policy forbids workers. */
async function asked<K extends DrawingRequest['kind']>(
  kind: K,
  file: Blob,
  signal: AbortSignal,
): Promise<DrawingReplies[K]> {
  signal.throwIfAborted();
  const order: DrawingOrder = { request: { kind, file }, module: MODULE.href };
  const worker = permittedWorker();
  if (!worker) {
    const { readDrawing } = await import('./read_drawing');
    const read = readDrawing(order, (rgba, width, height) => {
      const data = new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
      return pngOf(width, height, (context) => context.putImageData(data, 0, 0));
    });
    return read as Promise<DrawingReplies[K]>;
  }
  const ended = new AbortController();
  try {
    return await new Promise<DrawingReplies[K]>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { signal: ended.signal });
      worker.onerror = (cause) =>
        reject(pictureError('engine', say('errors.picture.drawingUnread'), { cause }));
      worker.onmessage = ({ data }: MessageEvent<DrawingReply>) => {
        if ('made' in data) resolve(data.made as DrawingReplies[K]);
        else reject(new C2WarpError(data.code, data.message, { wording: data.wording }));
      };
      worker.postMessage(order);
    });
  } finally {
    ended.abort();
    worker.terminate();
  }
}

function permittedWorker(): Worker | null {
  try {
    return startWorker(drawing);
  } catch {
    return null;
  }
}

async function rendered(file: Blob, width: number, height: number): Promise<Blob> {
  const image = new Image();
  image.src = URL.createObjectURL(file);
  try {
    await image.decode();
    return await pngOf(width, height, (context) => context.drawImage(image, 0, 0, width, height));
  } catch (cause) {
    throw pictureError('picture', say('errors.picture.drawingDamaged'), { cause });
  } finally {
    URL.revokeObjectURL(image.src);
  }
}

async function pngOf(
  width: number,
  height: number,
  draw: (context: CanvasRenderingContext2D) => void,
): Promise<Blob> {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d');
  if (context) draw(context);
  const png = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!png) throw new Error('no memory for the canvas');
  return png;
}
