/** Writes films, frame by frame, in a worker that all editors of a page share. */
import { sharedWorker } from '../start_worker';
import type { BeginFilm, FilmFault, FilmReply, FilmRequest, FilmSettings, FilmTarget } from './filming';
import writer from './worker/film?worker&url';

/** Starts the worker, also ahead of time. */
const prepareFilmWriter = sharedWorker(writer);

const FAULTS: Readonly<Record<FilmFault, string>> = {
  encoder: 'The film could not be encoded',
  storage: 'The film could not be saved',
};

/** A film that is being written. Dispose of it at the end. */
export class FilmFile {
  readonly #port: MessagePort;
  readonly #finished = new AbortController();
  /** The worker has failed. */
  #broken = false;
  #reject: (reason: Error) => void = () => {};

  /** @param picture see `BeginFilm`. Transferred to the worker. */
  constructor(settings: FilmSettings, picture: Uint8Array<ArrayBuffer> | null, target: FilmTarget) {
    const worker = prepareFilmWriter();
    const fail = () => {
      this.#broken = true;
      this.#reject(failed('the encoder stopped or did not load. Reload the page.'));
    };
    worker.addEventListener('error', fail, { signal: this.#finished.signal });
    const { port1, port2: port } = new MessageChannel();
    this.#port = port1;
    const transfer = picture ? [port, picture.buffer] : [port];
    worker.postMessage({ settings, picture, target, port } satisfies BeginFilm, transfer);
  }

  /**
   * Adds a frame. Resolves when the frames before it are written, so that one is drawn while another is encoded.
   *
   * @param rgba Straight alpha. Transferred to the worker.
   * @throws Error that names what failed.
   */
  async add(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    await this.#ask({ rgba }, [rgba.buffer]);
  }

  /** The whole film; null if it is in the picked file. @throws as {@link add}. */
  async finish(): Promise<Blob | null> {
    const reply = await this.#ask('end');
    if (typeof reply === 'string') throw failed('the encoder answered out of turn.');
    return reply.film;
  }

  /** Ends it. Resolves when an unfinished film has left nothing behind. */
  dispose(): Promise<void> {
    this.#finished.abort();
    if (this.#broken) return Promise.resolve();
    return new Promise((resolve) => {
      this.#port.onmessage = ({ data }: MessageEvent<FilmReply>) => {
        if (data !== 'gone') return;
        this.#port.close();
        resolve();
      };
      const abandon: FilmRequest = 'abandon';
      this.#port.postMessage(abandon);
    });
  }

  #ask(
    request: FilmRequest,
    transfer: Transferable[] = [],
  ): Promise<Exclude<FilmReply, { readonly refused: string }>> {
    return new Promise((resolve, reject) => {
      this.#reject = reject;
      if (this.#broken) this.#reject(failed('the encoder stopped or did not load. Reload the page.'));
      this.#port.onmessage = ({ data }: MessageEvent<FilmReply>) => {
        if (typeof data === 'object' && 'refused' in data) reject(failed(data.refused, data.fault));
        else resolve(data);
      };
      this.#port.postMessage(request, transfer);
    });
  }
}

const failed = (reason: string, fault: FilmFault = 'encoder'): Error =>
  new Error(`${FAULTS[fault]}: ${reason}`);
