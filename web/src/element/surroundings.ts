/** Watches for changes of the system's colour scheme and of the device pixel ratio. */
export interface SurroundingsHost {
  coloured(): void;
  scaled(): void;
}

export class Surroundings {
  readonly #host: SurroundingsHost;
  readonly #listening = new AbortController();

  constructor(host: SurroundingsHost) {
    this.#host = host;
    const { signal } = this.#listening;
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => host.coloured(), { signal });
    this.#watchScale();
  }

  release(): void {
    this.#listening.abort();
  }

  /** A query matches only one resolution, so each change needs a new query. */
  #watchScale(): void {
    const { signal } = this.#listening;
    const left = () => {
      this.#host.scaled();
      this.#watchScale();
    };
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', left, {
      signal,
      once: true,
    });
  }
}
