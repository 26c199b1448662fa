/**
 * Makes exports with a solver, in a worker and a WebAssembly module of their own. Both end with the export: solves
 * continue meanwhile, and a cancellation takes effect immediately.
 */
import type { Project } from '../document/project';
import { C2WarpError, codeOf, ENGINE, TOO_MUCH } from '../error';
import { startWorker } from '../start_worker';
import { say } from '../texts/wording';
import { engineError, tooMuchError } from './engine_error';
import type {
  DrawnPicture,
  ExportReply,
  ExportRequest,
  Exports,
  PictureOrder,
  PictureRequest,
} from './exporting_messages';
import { compiled, whyOf } from './loading';
import type { PixelSource } from './solution';
import exporter from './worker/exporter?worker&url';

/** By kinds of exports, when memory runs out. */
const TOO_LARGE = {
  'web-rig': 'rig',
  'engine-rig': 'rig',
  map: 'map',
  drawing: 'drawing',
} as const satisfies Record<keyof Exports, string>;

/**
 * Carries out an order for a project and its picture.
 *
 * @param onProgress Called with the part that is done, from 0 to 1.
 * @throws The reason of the signal; C2WarpError for a project that the export cannot hold.
 */
export async function solvedExport<K extends keyof Exports>(
  order: Exports[K]['order'] & { readonly kind: K },
  project: Project,
  source: PixelSource,
  signal: AbortSignal,
  onProgress: (part: number) => void,
): Promise<Exports[K]['made']> {
  const kind: keyof Exports = order.kind;
  const post = (worker: Worker, module: WebAssembly.Module) => {
    const { port1, port2: pixels } = new MessageChannel();
    const { width, height } = source;
    const request = { module, project: JSON.stringify(project), width, height, pixels, order };
    worker.postMessage(request satisfies ExportRequest, [pixels]);
    source.sendTo(port1);
  };
  const wording = (detail: string) => say('errors.exportRefused', detail);
  const refused = (detail: string) => new C2WarpError('export', detail, { wording: wording(detail) });
  // The worker answers an order with a result of the same kind.
  return (await made(post, kind, refused, signal, onProgress)) as Exports[K]['made'];
}

/**
 * Draws a drawing in the worker, unless a browser draws it quickly.
 *
 * @throws The reason of the signal; C2WarpError for a drawing that cannot be read, or takes too long to draw.
 */
export async function drawnApart(order: PictureOrder, signal: AbortSignal): Promise<DrawnPicture> {
  const post = (worker: Worker, module: WebAssembly.Module) =>
    worker.postMessage({ module, order } satisfies PictureRequest);
  const wording = (detail: string) => say('errors.picture.drawingRefused', detail);
  const refused = (detail: string) => new C2WarpError('picture', detail, { wording: wording(detail) });
  try {
    return (await made(post, 'drawing', refused, signal, () => {})) as DrawnPicture;
  } catch (cause) {
    if (codeOf(cause) !== ENGINE) throw cause;
    throw engineError(ENGINE, say('errors.engine.drawingNotChecked'), { cause });
  }
}

/** What a worker answers to the message that `post` sends. */
async function made(
  post: (worker: Worker, module: WebAssembly.Module) => void,
  kind: keyof Exports,
  refused: (sentence: string) => C2WarpError,
  signal: AbortSignal,
  onProgress: (part: number) => void,
): Promise<Exports[keyof Exports]['made'] | DrawnPicture> {
  const address = new URL('./generated/c2warp_export_bg.wasm', import.meta.url);
  const module = await compiled(address).catch((cause: Error) => {
    throw engineError(ENGINE, say('errors.engine.exportNotLoaded', whyOf(cause)), { cause });
  });
  signal.throwIfAborted();
  const worker = startWorker(exporter);
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.onerror = (cause) => {
        reject(engineError(ENGINE, say('errors.engine.exportNotStarted', exporter), { cause }));
      };
      worker.onmessage = ({ data }: MessageEvent<ExportReply>) => {
        if ('part' in data) onProgress(data.part);
        else if ('made' in data) resolve(data.made);
        else if (data.refused === null)
          reject(tooMuchError(TOO_MUCH, say(`errors.tooMuch.${TOO_LARGE[kind]}`)));
        else reject(refused(sentence(data.refused)));
      };
      post(worker, module);
    });
  } finally {
    worker.terminate();
  }
}

/** The command's message, as a sentence. */
export const sentence = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}${words.endsWith('.') ? '' : '.'}`;
