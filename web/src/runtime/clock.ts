/** A clock that reports each frame of the screen while it runs. */

/** Of a longer pause, such as in a hidden tab, only this much counts. Seconds. */
const MOST = 0.25;

export class Clock {
  readonly #ticked: (seconds: number) => void;
  #request = 0;
  #last: number | null = null;

  constructor(ticked: (seconds: number) => void) {
    this.#ticked = ticked;
  }

  run(on: boolean): void {
    cancelAnimationFrame(this.#request);
    this.#last = null;
    this.#request = on ? requestAnimationFrame((now) => this.#frame(now)) : 0;
  }

  #frame(now: number): void {
    const seconds = this.#last === null ? 0 : Math.min((now - this.#last) / 1000, MOST);
    this.#last = now;
    this.#request = requestAnimationFrame((next) => this.#frame(next));
    if (seconds > 0) this.#ticked(seconds);
  }
}
