/** Watches for changes of the system's colour scheme and of the device pixel ratio. */
export interface MediaListener {
  /** The system switched between light and dark colours. */
  schemeChanged(): void;
  pixelRatioChanged(): void;
}

export class MediaWatcher {
  readonly #listener: MediaListener;
  readonly #listening = new AbortController();

  constructor(listener: MediaListener) {
    this.#listener = listener;
    const { signal } = this.#listening;
    const scheme = matchMedia('(prefers-color-scheme: dark)');
    scheme.addEventListener('change', () => listener.schemeChanged(), { signal });
    this.#watchPixelRatio();
  }

  dispose(): void {
    this.#listening.abort();
  }

  /** A query matches only one resolution, so each change needs a new query. */
  #watchPixelRatio(): void {
    const { signal } = this.#listening;
    const changed = () => {
      this.#listener.pixelRatioChanged();
      this.#watchPixelRatio();
    };
    const ratio = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    ratio.addEventListener('change', changed, { signal, once: true });
  }
}
