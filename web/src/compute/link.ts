/**
 * The page's end of the connection to the worker: requests with their promises, and a new worker to replace one that
 * died.
 *
 * Requests that are pending when a worker dies are sent again to its successor, after the picture; a request that was
 * pending at two deaths is rejected.
 */
import { ENGINE, TOO_MUCH } from '../error';
import { say } from '../texts/wording';
import { engineError, tooMuchError } from './engine_error';
import { failureError, superseded } from './errors';
import type { Boot, Extension, Messages, Name, ProgressOf, Reply, Request, SentPicture } from './messages';
import type { PixelSource } from './solution';

/** The part of a Worker that is used here. */
export interface Port {
  postMessage(message: Boot | Extension | Request, transfer?: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** A request before it is sent. */
interface Asked<N extends Name = Name> {
  readonly id: number;
  readonly name: N;
  readonly body: Messages[N][0];
}

interface Pending {
  readonly request: Asked;
  readonly resolve: (body: Messages[Name][1]) => void;
  readonly reject: (reason: unknown) => void;
  readonly onProgress: ((stage: ProgressOf<Name>) => void) | undefined;
  /** When it was sent, in milliseconds. */
  readonly since: number;
  deaths: number;
}

const DEATHS_ALLOWED = 1;

/**
 * A worker that has solved for so long is ended by a newer request, in milliseconds. To wait for its next pause could
 * take longer than a new worker, which has to find the outline again.
 */
const PATIENCE = 1000;

/** The id of the picture that a new worker gets first. Nobody waits for its answer. */
const PICTURE_AGAIN = 0;

/** Why a request broke the solver: nearly always because memory ran out. */
const BROKE = {
  picture: 'picture',
  fit: 'pictures',
  suggest: 'suggest',
  solve: 'solve',
  fill: 'fill',
  draw: 'draw',
  rows: 'draw',
  release: 'draw',
  film: 'film',
  include: 'film',
  frame: 'film',
  'at-rest': 'film',
  'release-film': 'film',
  stop: 'solve',
  map: 'points',
  inverse: 'points',
  'posed-mesh': 'solve',
  'next-pose': 'solve',
  'clip-poses': 'solve',
  weights: 'points',
  distances: 'points',
  path: 'solve',
  cells: 'cells',
  study: 'study',
  lens: 'lens',
} as const satisfies Record<Name, string>;

export class Link {
  readonly #spawn: () => Port;
  readonly #module: WebAssembly.Module;
  readonly #loadLater: () => Promise<WebAssembly.Module>;
  /** The later part, once a request has needed it. */
  #later: WebAssembly.Module | undefined;
  readonly #address: string;
  /** By id, in the order of sending. */
  readonly #pending = new Map<number, Pending>();
  /** Undefined after a worker died with no request pending. */
  #port: Port | undefined;
  #lastId = 0;
  #disposed = false;
  #picture: Messages['picture'][0] | undefined;

  /**
   * @param loadLater loads the later part of the module.
   * @param address of the worker, for the error of one that does not start.
   */
  constructor(
    spawn: () => Port,
    module: WebAssembly.Module,
    loadLater: () => Promise<WebAssembly.Module>,
    address = 'its script',
  ) {
    this.#spawn = spawn;
    this.#module = module;
    this.#loadLater = loadLater;
    this.#address = address;
    this.#start();
  }

  /** Gives the solver the later part of its module. Requests that need it are sent after that. @throws C2WarpError */
  async extend(): Promise<void> {
    if (this.#later) return;
    const later = await this.#loadLater();
    if (this.#later) return;
    this.#later = later;
    this.#port?.postMessage({ later });
  }

  send<N extends Name>(
    name: N,
    body: Messages[N][0],
    onProgress?: (stage: ProgressOf<N>) => void,
  ): Promise<Messages[N][1]> {
    if (this.#disposed) return Promise.reject(superseded());
    const port = this.#port ?? this.#start(name !== 'picture');
    return new Promise((resolve, reject) => {
      const id = ++this.#lastId;
      const request = { id, name, body };
      // Before all else: a body that cannot be sent is an answer.
      post(port, request);
      if (name === 'picture') this.#picture = body as Messages['picture'][0];
      this.#pending.set(id, {
        request,
        resolve: (answer) => resolve(answer as Messages[N][1]),
        reject,
        onProgress: onProgress as Pending['onProgress'],
        since: performance.now(),
        deaths: 0,
      });
    });
  }

  /**
   * Rejects every pending request of this name. The worker drops it at a pause, for the newer request. If it has
   * worked on it for long, and nobody waits for anything else, it is ended at once.
   */
  abandon(name: Name): void {
    let since = Number.POSITIVE_INFINITY;
    for (const [id, pending] of this.#pending) {
      if (pending.request.name !== name) continue;
      this.#pending.delete(id);
      since = Math.min(since, pending.since);
      pending.reject(superseded());
    }
    if (this.#pending.size === 0 && performance.now() - since > PATIENCE) this.#stop();
  }

  dispose(): void {
    this.#disposed = true;
    this.#stop();
    for (const pending of this.#pending.values()) pending.reject(superseded());
    this.#pending.clear();
  }

  /**
   * Starts a worker, and sends it the module, the picture, and the pending requests.
   *
   * @param again Whether the last picture is needed.
   */
  #start(again = true): Port {
    const port = this.#spawn();
    this.#port = port;
    port.onmessage = ({ data }) => this.#receive(data);
    // The worker script threw outside of a request, or did not load.
    port.onerror = (event) => this.#replace(false, event.message);
    port.postMessage({ module: this.#module });
    if (this.#later) port.postMessage({ later: this.#later });
    const requests = [...this.#pending.values()].map(({ request }) => request);
    if (again && this.#picture && !requests.some(({ name }) => name === 'picture')) {
      post(port, { id: PICTURE_AGAIN, name: 'picture', body: this.#picture });
    }
    for (const request of requests) post(port, request);
    return port;
  }

  #stop(): void {
    if (!this.#port) return;
    this.#port.onmessage = null;
    this.#port.onerror = null;
    this.#port.terminate();
    this.#port = undefined;
  }

  #receive(reply: Reply): void {
    if (reply.kind === 'died') {
      this.#replace(reply.started, reply.message);
      return;
    }
    if (reply.id === PICTURE_AGAIN && reply.kind === 'failed') {
      this.#losePicture(failureError(reply.failure));
      return;
    }
    const pending = this.#pending.get(reply.id);
    // Replies to abandoned requests are dropped.
    if (!pending) return;
    if (reply.kind === 'progress') {
      pending.onProgress?.(reply.stage);
      return;
    }
    this.#pending.delete(reply.id);
    if (reply.kind === 'done') pending.resolve(reply.body);
    else pending.reject(reply.kind === 'superseded' ? superseded() : failureError(reply.failure));
  }

  /** Rejects all requests about a picture whose pixels are gone: those up to the next picture. */
  #losePicture(reason: unknown): void {
    for (const [id, { request, reject }] of this.#pending) {
      if (request.name === 'picture') return;
      this.#pending.delete(id);
      reject(reason);
    }
    // Without a picture, it would answer later requests wrongly.
    this.#stop();
  }

  /** @param started the worker had started, so that a request is to blame. */
  #replace(started: boolean, cause: string): void {
    this.#stop();
    for (const [id, pending] of this.#pending) {
      pending.deaths += 1;
      if (pending.deaths <= DEATHS_ALLOWED) continue;
      this.#pending.delete(id);
      if (pending.request.name === 'picture') this.#picture = undefined;
      pending.reject(
        started
          ? tooMuchError(TOO_MUCH, say(`errors.tooMuch.${BROKE[pending.request.name]}`), { cause })
          : engineError(ENGINE, say('errors.engine.notStarted', this.#address), { cause }),
      );
    }
    // A successor without requests could die of the same picture again and again.
    if (this.#pending.size > 0) this.#start();
  }
}

/** Sends a request. The pixels of a picture come from another worker, so that the page never copies them. */
function post(port: Port, { id, name, body }: Asked): void {
  if (name === 'picture') {
    sendWith(port, body as PixelSource, (picture) => ({ id, name, body: picture }));
  } else if (name === 'fit') {
    const { project, own } = body as Messages['fit'][0];
    if (own) sendWith(port, own, (picture) => ({ id, name, body: { project, own: picture } }));
    else port.postMessage({ id, name, body: { project, own } });
  } else port.postMessage({ id, name, body } as Request);
}

/** Sends a request with a picture, whose pixels follow at a port of their own. */
function sendWith(port: Port, source: PixelSource, request: (picture: SentPicture) => Request): void {
  const { width, height } = source;
  const { port1, port2 } = new MessageChannel();
  port.postMessage(request({ width, height, pixels: port2 }), [port2]);
  source.sendTo(port1);
}
