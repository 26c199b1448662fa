/** Errors of the engine: a stable code for programs, a sentence for people. */
import type { Failure } from './messages';

/** Code of an error that is the engine's own fault, not the input's. */
export const ENGINE = 'engine';

export class EngineError extends Error {
  readonly code: string;

  constructor({ code, message }: Failure, options?: ErrorOptions) {
    super(message, options);
    this.name = 'EngineError';
    this.code = code;
  }
}

/** What a request rejects with that a newer one has made pointless. */
export function superseded(): DOMException {
  return new DOMException('superseded', 'AbortError');
}
