/**
 * Makes exports with a solver, in a worker and a WebAssembly module of their own. Both end with the export: solves go
 * on meanwhile, and a cancel stops it at once.
 */
import type { Project } from '../document/project';
import { C2WarpError, ENGINE, TOO_MUCH } from '../error';
import { startWorker } from '../start_worker';
import type { ExportReply, ExportRequest, Exports } from './exporting_messages';
import { compiled } from './loading';
import type { PixelSource } from './solution';
import exporter from './worker/exporter?worker&url';

const NOT_STARTED = 'The export could not be started';
/** By kinds of exports, for want of memory. */
const TOO_LARGE: Readonly<Record<keyof Exports, string>> = {
  'web-rig': 'The clips are more than a rig can hold in this browser: shorten them.',
  'engine-rig': 'The clips are more than a rig can hold in this browser: shorten them.',
  map: 'The file is more than this browser can hold: the command line writes it.',
  drawing: 'The drawing is more than this browser can bend: simplify it.',
};

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
  const address = new URL('./generated/c2warp_export_bg.wasm', import.meta.url);
  const module = await compiled(address).catch((cause: Error) => {
    throw new C2WarpError(ENGINE, `${NOT_STARTED}: ${cause.message}`, { cause });
  });
  signal.throwIfAborted();
  const worker = startWorker(exporter);
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.onerror = (cause) => {
        const message = `${NOT_STARTED}: is ${exporter} there, and does the page allow workers?`;
        reject(new C2WarpError(ENGINE, message, { cause }));
      };
      worker.onmessage = ({ data }: MessageEvent<ExportReply>) => {
        if ('part' in data) onProgress(data.part);
        // The worker answers an order of this kind.
        else if ('made' in data) resolve(data.made as Exports[K]['made']);
        else if (data.refused === null) reject(new C2WarpError(TOO_MUCH, TOO_LARGE[order.kind]));
        else reject(new C2WarpError('export', sentence(data.refused)));
      };
      const { port1, port2: pixels } = new MessageChannel();
      const { width, height } = source;
      const request = { module, project: JSON.stringify(project), width, height, pixels, order };
      worker.postMessage(request satisfies ExportRequest, [pixels]);
      source.sendTo(port1);
    });
  } finally {
    worker.terminate();
  }
}

/** The words of the command, as a sentence. */
export const sentence = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}${words.endsWith('.') ? '' : '.'}`;
