/**
 * Turns to open something: the newest wins.
 *
 * Opening takes several steps: fetching, decoding, reading. Once a newer turn begins or the editor is disposed, the
 * older turn is aborted and its late results are dropped.
 */
export class Turn {
  readonly #ending = new AbortController();

  /** Aborts the requests of this turn. */
  get signal(): AbortSignal {
    return this.#ending.signal;
  }

  end(): void {
    this.#ending.abort();
  }

  /** @throws DOMException `AbortError` once the turn is over. */
  check(): void {
    if (this.#ending.signal.aborted) {
      throw new DOMException('something else was opened, or the editor is gone', 'AbortError');
    }
  }

  /** Settles as `work` does while the turn lasts. @throws DOMException `AbortError` once the turn is over. */
  async through<T>(work: Promise<T>): Promise<T> {
    try {
      return await work;
    } finally {
      this.check();
    }
  }
}

/** Hands out one turn at a time; after `close` only ended ones. */
export class Turns {
  #newest = new Turn();
  #closed = false;

  /** Ends the current turn and returns the next. */
  take(): Turn {
    this.#newest.end();
    if (!this.#closed) this.#newest = new Turn();
    return this.#newest;
  }

  close(): void {
    this.#closed = true;
    this.#newest.end();
  }
}
