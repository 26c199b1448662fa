/** Pages and workers: the browser decodes pictures. */
import type { Port } from '../compute/link';
import { loadedLater, loadedModule } from '../compute/loading';
import type { Pixels } from '../compute/solution';
import worker from '../compute/worker/worker?worker&url';
import { C2WarpError, ENGINE } from '../error';
import { decodePicture, type Platform } from '../io/decode';
import { pagePlatform } from '../io/page_platform';
import { startWorker } from '../start_worker';
import type { Environment } from './environment';

/** Workers have neither a document nor image elements. */
const isPage = typeof document !== 'undefined';

const workerPlatform: Platform = {
  createContext: () => new OffscreenCanvas(1, 1).getContext('webgl2', { antialias: false, depth: false }),
  imageOf: async () => null,
};

export const browser: Environment = {
  usesWorker: isPage,
  workerAddress: worker,
  loadModule: loadedModule,
  loadLater: loadedLater,

  spawn(): Port {
    try {
      return isPage
        ? startWorker(worker, 'c2warp-core')
        : new Worker(new URL(worker, import.meta.url), { type: 'module' });
    } catch (cause) {
      const message = 'Could not start the solver: this browser or this page does not allow workers.';
      throw new C2WarpError(ENGINE, message, { cause });
    }
  },

  async decode(bytes, signal) {
    const platform = isPage ? pagePlatform : workerPlatform;
    const { bitmap, width, height, rgba } = await decodePicture(new Blob([bytes]), platform, signal);
    bitmap.close();
    return { width, height, rgba };
  },

  drawn(input) {
    if (!isDrawable(input)) return undefined;
    const { width, height } = input;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context)
      throw new C2WarpError('picture', 'This browser has no 2D canvas here. Pass pixels instead.');
    context.drawImage(input, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    return { width, height, rgba: new Uint8Array(data.buffer) };
  },

  image: ({ width, height, rgba }: Pixels) =>
    new ImageData(new Uint8ClampedArray(rgba.buffer), width, height),
};

const isDrawable = (input: unknown): input is ImageBitmap | HTMLCanvasElement | OffscreenCanvas =>
  input instanceof ImageBitmap ||
  (typeof OffscreenCanvas !== 'undefined' && input instanceof OffscreenCanvas) ||
  (isPage && input instanceof HTMLCanvasElement);
