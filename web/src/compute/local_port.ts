/** A solver without a worker: it runs on its owner's thread, stage by stage. */
import type { Port } from './link';
import type { Boot, Extension, Reply, Request } from './messages';
import { SolverService } from './solver_service';

export class LocalPort implements Port {
  onmessage: Port['onmessage'] = null;
  onerror: Port['onerror'] = null;
  readonly #service = new SolverService((data) => this.#deliver(data), { warmUp: false });

  postMessage(message: Boot | Extension | Request): void {
    this.#service.push(message);
  }

  terminate(): void {
    this.#service.dispose();
  }

  /** Later, so that errors of the owner are not those of the solver. */
  #deliver(data: Reply): void {
    queueMicrotask(() => this.onmessage?.({ data } as MessageEvent<Reply>));
  }
}
