/** Errors of the engine: a stable code for programs, a sentence for people, and the handles that it names. */
import type { Failure } from './messages';

/** Code of an error of the engine itself, not of its input. */
export const ENGINE = 'engine';

export class EngineError extends Error {
  readonly code: string;
  /** Ids of the handles that the message names. */
  readonly handles: readonly string[];

  constructor({ code, message, handles = [] }: Failure, options?: ErrorOptions) {
    super(message, options);
    this.name = 'EngineError';
    this.code = code;
    this.handles = handles;
  }
}

/** Whether the solver itself has failed, such as for want of its files. */
export const isEngineFailure = (error: unknown): boolean =>
  error instanceof EngineError && error.code === ENGINE;

/** The error that rejects a request which a newer one has made pointless. */
export function superseded(): DOMException {
  return new DOMException('superseded', 'AbortError');
}
