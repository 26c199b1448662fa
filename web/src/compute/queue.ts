/**
 * One request at a time, in order; whenever the running one pauses, it can look for newer ones.
 *
 * A running wasm call cannot be interrupted; a request in stages can stop between them.
 */
declare const setImmediate: undefined | ((callback: () => void) => void);

export class Queue<Request> {
  readonly #waiting: Request[] = [];
  readonly #handle: (request: Request) => Promise<void>;
  #running = false;

  constructor(handle: (request: Request) => Promise<void>) {
    this.#handle = handle;
  }

  push(request: Request): void {
    this.#waiting.push(request);
    if (!this.#running) void this.#run();
  }

  /** Whether a request of this kind waits behind the running one. */
  waits(kind: (request: Request) => boolean): boolean {
    return this.#waiting.some(kind);
  }

  /** Drops all requests that wait. */
  clear(): void {
    this.#waiting.length = 0;
  }

  async #run(): Promise<void> {
    this.#running = true;
    // Requests posted together arrive one by one: let all of them in before the first starts.
    await nextTask();
    for (let request = this.#waiting.shift(); request !== undefined; request = this.#waiting.shift()) {
      await this.#handle(request);
    }
    this.#running = false;
  }
}

/** Lets messages that have arrived be handled. A timer would be clamped to 4 ms. */
export const nextTask: () => Promise<void> =
  typeof setImmediate === 'undefined' ? nextMessage() : () => new Promise((resolve) => setImmediate(resolve));

/** For browsers. In Node, an open channel would keep the process alive. */
function nextMessage(): () => Promise<void> {
  const channel = new MessageChannel();
  const resumes: (() => void)[] = [];
  channel.port1.onmessage = () => resumes.shift()?.();
  return () =>
    new Promise((resolve) => {
      resumes.push(resolve);
      channel.port2.postMessage(null);
    });
}
