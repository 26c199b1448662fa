/** What the system may change while the page is open: light or dark colours, and how many device pixels a CSS pixel has. */
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

  /** A query matches one resolution, and tells only that it is left: each is another. */
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
