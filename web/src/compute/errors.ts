/** Errors of the engine: a stable code for programs, a sentence for people, and the handles that it names. */
import type { Failure } from './messages';

/** Code of an error that is the engine's own fault, not the input's. */
export const ENGINE = 'engine';

export class EngineError extends Error {
  readonly code: string;
  /** Ids. */
  readonly handles: readonly string[];

  constructor({ code, message, handles = [] }: Failure, options?: ErrorOptions) {
    super(message, options);
    this.name = 'EngineError';
    this.code = code;
    this.handles = handles;
  }
}

/** What a request rejects with that a newer one has made pointless. */
export function superseded(): DOMException {
  return new DOMException('superseded', 'AbortError');
}
