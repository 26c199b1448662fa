/**
 * Writes picture files, row by row, in a worker that all editors of a page share.
 *
 * A PNG file holds exactly the bytes that the solver returns, in straight alpha.
 */
import { sharedWorker } from '../start_worker';
import type { BeginFile, FileReply, FileRequest, FileSettings, PictureType } from './encoding';
import encoder from './worker/encoder?worker&url';

export type { FileSettings, PictureType, PngChunk } from './encoding';

export const TYPE_NAMES = {
  'image/png': 'PNG',
  'image/jpeg': 'JPEG',
  'image/webp': 'WebP',
} as const satisfies Record<PictureType, string>;

/** Starts the worker, also ahead of time, so that a later export needs no network. */
export const prepareEncoder = sharedWorker(encoder);

/** A file that is being written. Dispose of it at the end. */
export class PictureFile {
  readonly #port: MessagePort;
  readonly #finished = new AbortController();
  readonly #name: string;
  /** The worker has failed. */
  #broken = false;
  #reject: (reason: Error) => void = () => {};

  constructor(settings: FileSettings) {
    this.#name = TYPE_NAMES[settings.type];
    const worker = prepareEncoder();
    const fail = () => {
      this.#broken = true;
      this.#reject(this.#failed());
    };
    worker.addEventListener('error', fail, { signal: this.#finished.signal });
    const { port1, port2: port } = new MessageChannel();
    this.#port = port1;
    worker.postMessage({ settings, port } satisfies BeginFile, [port]);
  }

  /**
   * Writes rows from top to bottom. Resolves when the rows before these are written.
   *
   * @param rgba Straight alpha. Transferred to the worker: pass a copy to keep the original.
   * @throws Error if the file cannot be written.
   */
  async write(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    await this.#ask({ rgba }, [rgba.buffer]);
  }

  /** @throws Error if the file cannot be written. */
  async finish(): Promise<Blob> {
    const reply = await this.#ask('end');
    if (reply === 'taken') throw this.#failed();
    return reply.file;
  }

  dispose(): void {
    this.#finished.abort();
    const abandon: FileRequest = 'abandon';
    this.#port.postMessage(abandon);
    this.#port.close();
  }

  #ask(
    request: FileRequest,
    transfer: Transferable[] = [],
  ): Promise<Exclude<FileReply, { readonly refused: string }>> {
    return new Promise((resolve, reject) => {
      this.#reject = reject;
      if (this.#broken) reject(this.#failed());
      this.#port.onmessage = ({ data }: MessageEvent<FileReply>) => {
        if (typeof data === 'object' && 'refused' in data) reject(this.#failed(data.refused));
        else resolve(data);
      };
      this.#port.postMessage(request, transfer);
    });
  }

  #failed(reason = 'the encoder failed or did not load. Reload the page.'): Error {
    return new Error(`The ${this.#name} could not be written: ${reason}`);
  }
}
