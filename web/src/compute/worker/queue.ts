/**
 * One request at a time, in order, with a look at what else has come whenever the one in work pauses.
 *
 * A running wasm call cannot be interrupted; a request in stages can give up between them.
 */
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

  /** Whether a request of this kind waits behind the one in work. */
  waits(kind: (request: Request) => boolean): boolean {
    return this.#waiting.some(kind);
  }

  async #run(): Promise<void> {
    this.#running = true;
    // Requests posted together arrive one by one: let all of them in before the first is begun.
    await nextTask();
    for (let request = this.#waiting.shift(); request !== undefined; request = this.#waiting.shift()) {
      await this.#handle(request);
    }
    this.#running = false;
  }
}

const channel = new MessageChannel();
const resumes: (() => void)[] = [];
channel.port1.onmessage = () => resumes.shift()?.();

/** Lets messages in that have arrived. Timers would be slowed down to 4 ms each. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    resumes.push(resolve);
    channel.port2.postMessage(null);
  });
}
