/**
 * Requests of which only the latest counts, such as those to open something: fetching, decoding and reading take time.
 *
 * Each has a signal, which is aborted once a newer one begins or the editor is disposed. Its late results are dropped.
 */
export class LatestRequest {
  #newest = new AbortController();
  #closed = false;

  /** Aborts the request before, and returns the signal of the next; after `close` only aborted ones. */
  next(): AbortSignal {
    this.#abort();
    if (!this.#closed) this.#newest = new AbortController();
    return this.#newest.signal;
  }

  close(): void {
    this.#closed = true;
    this.#abort();
  }

  #abort(): void {
    this.#newest.abort(new DOMException('something else was opened, or the editor is gone', 'AbortError'));
  }
}

/** Whether an error says that something newer took the place of what was asked for. */
export const isAbort = (error: unknown): boolean =>
  error instanceof DOMException && error.name === 'AbortError';

/** Settles as `work` does until the signal is aborted. @throws the signal's reason once it is. */
export async function unlessAborted<T>(signal: AbortSignal, work: Promise<T>): Promise<T> {
  try {
    return await work;
  } finally {
    signal.throwIfAborted();
  }
}
