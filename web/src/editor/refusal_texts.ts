/** Refusals of a picture without a project: the solver's messages name project keys that the person has never set. */
import { codeOf, WarpError } from '../error';

const TEXTS: Readonly<Record<string, string>> = {
  'nothing-opaque': 'nothing in this picture is opaque enough to be warped.',
  domain: 'the outline of this picture has too many corners to be warped: smooth its transparency.',
};

/** The error in words for the editor, with the same `code`; other errors are returned unchanged. */
export function inEditorWords(error: Error, name: string): Error {
  const text = TEXTS[codeOf(error)];
  return text === undefined ? error : new WarpError(codeOf(error), `${name}: ${text}`, { cause: error });
}
