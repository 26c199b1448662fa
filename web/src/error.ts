/** The one error class of the editor: a stable code for programs, a sentence for people, and the handles it names. */

/** The code of a failure of the solver itself, not of its input. */
export const ENGINE = 'engine';

/** The code of a request that the solver broke at, for example for want of memory. Its input is to blame. */
export const TOO_MUCH = 'too-much';

/** The words of a solve that is too much. */
export const TOO_MUCH_TO_SOLVE = 'This is more than the solver can do with the memory that there is.';

export interface WarpErrorOptions extends ErrorOptions {
  /** Ids of the handles that the message names. */
  readonly handles?: readonly string[];
}

export class WarpError extends Error {
  readonly code: string;
  readonly handles: readonly string[];

  constructor(code: string, message: string, { handles = [], ...options }: WarpErrorOptions = {}) {
    super(message, options);
    this.name = 'WarpError';
    this.code = code;
    this.handles = handles;
  }
}

/** The code of an error; empty if it has none. */
export const codeOf = (error: unknown): string => String((error as { code?: unknown } | null)?.code ?? '');

/** The ids of the handles that an error names. */
export const handlesOf = (error: unknown): readonly string[] =>
  error instanceof WarpError ? error.handles : [];

/** Whether the solver itself failed, for example because its files are missing. */
export const isEngineFailure = (error: unknown): boolean => codeOf(error) === ENGINE;

/** Whether an error only says that a newer request replaced this one. */
export const isAbort = (error: unknown): boolean => (error as Error | null)?.name === 'AbortError';

export const asError = (thrown: unknown): Error =>
  thrown instanceof Error ? thrown : new Error(String(thrown));
