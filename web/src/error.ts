/** The error class of the editor, the player and the core: a stable code, a sentence for people, and named handles. */
import type { ErrorCode } from './document/generated/error_code';
import type { PartialTexts } from './texts/texts';
import { type TextKey, type Wording, worded } from './texts/wording';

/** The code of a failure of the solver itself, not of its input. */
export const ENGINE = 'engine';

/** The code of a request on which the solver failed, for example for lack of memory, because of its input. */
export const TOO_MUCH = 'too-much';

/**
 * Why something failed, for programs. The codes of `SolverErrorCode` come from the solver.
 *
 * | code | |
 * |---|---|
 * | `attribute` | an invalid value of `tool`, `theme`, `features`, `crossorigin` or `submits` |
 * | `address` | the file does not exist, or the network is not available |
 * | `file` | a folder, or a file that no longer exists |
 * | `picture` | not a picture, an unreadable picture, or a picture of an unsupported size |
 * | `project` | an invalid project; the message names the key |
 * | `image-size` | the project is for a picture of another size |
 * | `engine` | the solver could not be loaded or started, or was disposed of |
 * | `webgl` | the browser has no WebGL2 |
 * | `too-much` | the solver failed, nearly always for lack of memory |
 * | `export` | an export format that does not support this project |
 * | `rig` | not a rig, a damaged rig, or a rig that cannot be posed |
 * | `clip` | the clip or the time does not exist |
 * | `points` | a list of points that is not a list of pairs |
 * | `no-picture` | no picture is open |
 * | `disconnected` | the element is not on a page |
 * | `failed` | any other failure, such as full storage; the message gives the reason |
 */
export type C2WarpErrorCode =
  | 'attribute'
  | 'address'
  | 'file'
  | 'picture'
  | 'project'
  | 'image-size'
  | typeof ENGINE
  | 'webgl'
  | typeof TOO_MUCH
  | 'export'
  | 'rig'
  | 'clip'
  | 'points'
  | 'no-picture'
  | 'disconnected'
  | 'failed'
  | SolverErrorCode;

/** The codes with which the solver rejects its input. */
export type SolverErrorCode = ErrorCode;

export interface C2WarpErrorOptions extends ErrorOptions {
  /** Ids of the handles that the message names. */
  readonly handles?: readonly string[];
  /** The message for people, in any language. @internal */
  readonly wording?: Wording | undefined;
}

/** Why something failed. Its `message` is a sentence in English. */
export class C2WarpError extends Error {
  /** The reason, for programs. */
  readonly code: C2WarpErrorCode;
  /** Ids of the handles that the message names. */
  readonly handles: readonly string[];
  /** The message for people, in any language. @internal */
  readonly wording: Wording | undefined;

  constructor(code: C2WarpErrorCode, message: string, options: C2WarpErrorOptions = {}) {
    const { handles = [], wording, ...cause } = options;
    super(message, cause);
    this.name = 'C2WarpError';
    this.code = code;
    this.handles = handles;
    this.wording = wording;
  }
}

/** An error of the WebAssembly module: it has the same fields, but not the class. */
type Coded = Partial<Pick<C2WarpError, 'code' | 'handles' | 'wording'>>;

/** The code of an error; empty without one. */
export function codeOf(error: unknown): C2WarpErrorCode | '' {
  const code = (error as Coded | null)?.code;
  return typeof code === 'string' ? code : '';
}

/** The ids of the handles that an error names. */
export const handlesOf = (error: unknown): readonly string[] => (error as Coded | null)?.handles ?? [];

/** The message of an error for people, in any language; undefined if only its English message exists. */
export const wordingOf = (error: unknown): Wording | undefined => (error as Coded | null)?.wording;

/**
 * Makes errors with the sentences of one area of the table. Only that area is loaded, in English, for the messages.
 *
 * @param english a table with this area.
 */
export const errorsIn =
  <Area extends string>(english: PartialTexts) =>
  (
    code: C2WarpErrorCode,
    wording: Wording<Extract<TextKey, `${Area}.${string}`>>,
    options: C2WarpErrorOptions = {},
  ): C2WarpError =>
    new C2WarpError(code, worded(english, wording), { ...options, wording });

/** Whether the solver itself failed, for example because its files are missing. */
export const isEngineFailure = (error: unknown): boolean => codeOf(error) === ENGINE;

/** Whether an error only says that a newer request replaced this one. */
export const isAbort = (error: unknown): boolean => (error as Error | null)?.name === 'AbortError';

export const asError = (thrown: unknown): Error =>
  thrown instanceof Error ? thrown : new Error(String(thrown));

/** The error that a page receives. An error without a code gets `failed`. */
export function asC2WarpError(thrown: unknown): C2WarpError {
  if (thrown instanceof C2WarpError) return thrown;
  const handles = handlesOf(thrown);
  return new C2WarpError(codeOf(thrown) || 'failed', asError(thrown).message, {
    handles,
    wording: wordingOf(thrown),
    cause: thrown,
  });
}
