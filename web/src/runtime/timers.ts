/** Timers by name: starting one again restarts it. */
import type { Timer } from '../editor/timer';

export class Timers {
  readonly #elapsed: (timer: Timer) => void;
  readonly #running = new Map<Timer, ReturnType<typeof setTimeout>>();

  constructor(elapsed: (timer: Timer) => void) {
    this.#elapsed = elapsed;
  }

  start(timer: Timer, ms: number): void {
    this.stop(timer);
    const elapse = () => {
      this.#running.delete(timer);
      this.#elapsed(timer);
    };
    this.#running.set(timer, setTimeout(elapse, ms));
  }

  stop(timer: Timer): void {
    clearTimeout(this.#running.get(timer));
    this.#running.delete(timer);
  }

  dispose(): void {
    for (const timer of [...this.#running.keys()]) this.stop(timer);
  }
}
