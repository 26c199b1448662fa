/**
 * Whose turn it is to open something: the newest's.
 *
 * Files are fetched, decoded and read one after the other. Whatever of an older turn comes in after a newer one has begun, or
 * after the editor has gone, is given up.
 */
export class Turn {
  readonly #ending = new AbortController();

  /** Ends a request that is under way. */
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

  /** What comes of `work`, good or bad, if the turn lasts. @throws DOMException `AbortError` if not. */
  async through<T>(work: Promise<T>): Promise<T> {
    try {
      return await work;
    } finally {
      this.check();
    }
  }
}

/** One turn at a time; none after the last has been ended. */
export class Turns {
  #newest = new Turn();
  #closed = false;

  /** The next turn; the one before it is over. */
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
