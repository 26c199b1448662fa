/** The words of errors for people, where the solver's own words name project keys or ids. */
import { nameOf } from '../document/handle';
import { C2WarpError, codeOf, handlesOf, TOO_MUCH } from '../error';

/** By the codes of errors whose messages are in words of the solver and of project files. */
const REFUSALS: Readonly<Record<string, (name: string, other: string) => string>> = {
  'handle-outside': (name) => `“${name}” lies outside the shape: place it on the picture.`,
  'handle-far-outside': (name) => `“${name}” would lie far outside this picture: the rig does not fit it.`,
  'on-held-boundary': (name) =>
    `“${name}” stands on the boundary, which is held: move it further inside, or free the boundary.`,
  'bars-overlap': (name, other) =>
    name === other
      ? `“${name}” runs back along itself: its pieces may cross and touch, but not lie on one another.`
      : `“${name}” and “${other}” run along each other: they may cross and touch, but not lie on one another.`,
};

/** The same for errors that name no handle. */
const SENTENCES: Readonly<Record<string, string>> = {
  'too-much-memory': 'This needs more memory than a browser has: use fewer handles, or less detail.',
  'too-many-sites':
    'The handles are too close to one another, or too many: move some apart, or use less detail.',
  'nothing-to-fill-from':
    'Nothing is left around the selection to fill its background from: draw a smaller one, or leave it empty.',
  'held-too-fine': 'This outline has too many corners to be held: draw a simpler one, or let it move.',
};

/** Refusals of exports, which take nothing back. */
const EXPORT_REFUSALS: Readonly<Record<string, string>> = {
  scale: 'The export would be too large or too small: choose another size.',
  canvas: 'All of the picture would be too large: choose a smaller size, or the rectangle of the original.',
  'nothing-drawn': 'Nothing is covered: the picture is transparent everywhere.',
};

/** @param reverted the step that caused the error was taken back. */
export function refusalWords(error: Error, reverted = false): string {
  const refused = EXPORT_REFUSALS[codeOf(error)];
  if (refused !== undefined) return refused;
  const [id, other = id] = handlesOf(error);
  // The message of a broken request is for people already.
  const sentence = codeOf(error) === TOO_MUCH ? error.message : SENTENCES[codeOf(error)];
  if (sentence !== undefined) return reverted ? `${sentence} The step was taken back.` : sentence;
  const words = REFUSALS[codeOf(error)];
  return words && id !== undefined && other !== undefined
    ? words(nameOf({ id }), nameOf({ id: other }))
    : error.message;
}

/** Refusals of a picture without a project, in which the person has set nothing. */
const TEXTS: Readonly<Record<string, string>> = {
  'nothing-opaque': 'nothing in this picture is opaque enough to be warped.',
  'too-much': 'this picture is more than the solver can do in this browser.',
};

/** The error in words for the editor, with the same `code`; other errors are returned unchanged. */
export function inEditorWords(error: Error, name: string): Error {
  const code = codeOf(error);
  const text = TEXTS[code];
  return code && text ? new C2WarpError(code, `${name}: ${text}`, { cause: error }) : error;
}
