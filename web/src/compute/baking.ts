/**
 * Bakes rigs in a worker and a WebAssembly module of their own. Both end with the bake: solves go on meanwhile, and a
 * cancel stops it at once.
 */
import type { Project } from '../document/project';
import { ENGINE, TOO_MUCH, WarpError } from '../error';
import { startWorker } from '../start_worker';
import type { BakeReply, BakeRequest } from './baking_messages';
import { compiled } from './module';
import type { PixelSource } from './solution';
import baker from './worker/baker?worker&url';

const NOT_STARTED = 'The export could not be started: are its files there, and does the page allow workers?';
const BROKE = 'The clips are more than a rig can hold in this browser: shorten them.';

/**
 * The rig of a project's clips.
 *
 * @param file A PNG, WebP or JPEG file of the picture.
 * @param onProgress Called with the part that is done, from 0 to 1.
 * @throws The reason of the signal; WarpError for clips that no rig can hold.
 */
export async function bakedRig(
  project: Project,
  source: PixelSource,
  file: Uint8Array<ArrayBuffer>,
  signal: AbortSignal,
  onProgress: (part: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const module = await compiled(new URL('./generated/c2warp_export_bg.wasm', import.meta.url)).catch(
    (cause) => {
      throw new WarpError(ENGINE, NOT_STARTED, { cause });
    },
  );
  signal.throwIfAborted();
  const worker = startWorker(baker);
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.onerror = (cause) => reject(new WarpError(ENGINE, NOT_STARTED, { cause }));
      worker.onmessage = ({ data }: MessageEvent<BakeReply>) => {
        if ('part' in data) onProgress(data.part);
        else if ('rig' in data) resolve(data.rig);
        else reject(new WarpError(data.refused === null ? TOO_MUCH : 'rig', sentence(data.refused ?? BROKE)));
      };
      const { port1, port2: pixels } = new MessageChannel();
      const { width, height } = source;
      const request = { module, project: JSON.stringify(project), width, height, pixels, file };
      worker.postMessage(request satisfies BakeRequest, [pixels]);
      source.sendTo(port1);
    });
  } finally {
    worker.terminate();
  }
}

/** The words of the command, as a sentence. */
const sentence = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}${words.endsWith('.') ? '' : '.'}`;
