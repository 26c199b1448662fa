/** The words of errors for people, where the solver's own words name project keys or ids. */
import { nameOf } from '../document/handle';
import { codeOf, handlesOf, WarpError } from '../error';

/** By the codes of errors whose messages are in words of the solver and of project files. */
const REFUSALS: Readonly<Record<string, (name: string, other: string) => string>> = {
  'handle-outside': (name) => `“${name}” lies outside the shape: place it on the picture.`,
  'on-held-boundary': (name) =>
    `“${name}” stands on the boundary, which is held: move it further inside, or free the boundary.`,
  'bars-overlap': (name, other) =>
    name === other
      ? `“${name}” runs back along itself: its pieces may cross and touch, but not lie on one another.`
      : `“${name}” and “${other}” run along each other: they may cross and touch, but not lie on one another.`,
};

/** An error in words of the editor. */
export function refusalWords(error: Error): string {
  const [id, other = id] = handlesOf(error);
  const words = REFUSALS[codeOf(error)];
  return words && id !== undefined && other !== undefined
    ? words(nameOf({ id }), nameOf({ id: other }))
    : error.message;
}

/** Refusals of a picture without a project, in which the person has set nothing. */
const TEXTS: Readonly<Record<string, string>> = {
  'nothing-opaque': 'nothing in this picture is opaque enough to be warped.',
  domain: 'the outline of this picture has too many corners to be warped: smooth its transparency.',
};

/** The error in words for the editor, with the same `code`; other errors are returned unchanged. */
export function inEditorWords(error: Error, name: string): Error {
  const text = TEXTS[codeOf(error)];
  return text === undefined ? error : new WarpError(codeOf(error), `${name}: ${text}`, { cause: error });
}
