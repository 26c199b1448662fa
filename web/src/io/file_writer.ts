/** A file that a worker writes, on the side of the page. */
import type { Refusal, WriteReply, WriteRequest } from './writing';

export class FileWriter<File> {
  readonly #port: MessagePort;
  readonly #failed: (refusal?: Refusal) => Error;
  readonly #finished = new AbortController();
  /** The worker has failed. */
  #broken = false;
  #reject: (reason: Error) => void = () => {};

  /**
   * @param begin sends the worker a port for this file.
   * @param failed the error for people of a refusal, or of a worker that fails.
   */
  constructor(worker: Worker, begin: (port: MessagePort) => void, failed: (refusal?: Refusal) => Error) {
    this.#failed = failed;
    const fail = () => {
      this.#broken = true;
      this.#reject(failed());
    };
    worker.addEventListener('error', fail, { signal: this.#finished.signal });
    const { port1, port2 } = new MessageChannel();
    this.#port = port1;
    begin(port2);
  }

  /**
   * Writes pixels. Resolves when those before them are written, so that more are drawn while these are encoded.
   *
   * @param rgba Transferred to the worker.
   * @throws Error if the file cannot be written.
   */
  async write(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    await this.#ask({ rgba }, [rgba.buffer]);
  }

  /** @throws the errors of {@link write}. */
  async finish(): Promise<File> {
    const reply = await this.#ask('end');
    if (typeof reply === 'string') throw this.#failed();
    return reply.file;
  }

  /** Ends it. Resolves when an unfinished file has left nothing behind. */
  dispose(): Promise<void> {
    this.#finished.abort();
    if (this.#broken) return Promise.resolve();
    return new Promise((resolve) => {
      this.#port.onmessage = ({ data }: MessageEvent<WriteReply<File>>) => {
        if (data !== 'gone') return;
        this.#port.close();
        resolve();
      };
      this.#port.postMessage('abandon' satisfies WriteRequest);
    });
  }

  #ask(request: WriteRequest, transfer: Transferable[] = []): Promise<Exclude<WriteReply<File>, Refusal>> {
    return new Promise((resolve, reject) => {
      this.#reject = reject;
      if (this.#broken) reject(this.#failed());
      this.#port.onmessage = ({ data }: MessageEvent<WriteReply<File>>) => {
        if (typeof data === 'object' && 'refused' in data) reject(this.#failed(data));
        else resolve(data);
      };
      this.#port.postMessage(request, transfer);
    });
  }
}
