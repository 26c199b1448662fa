/**
 * Errors for people. An error of the editor has its wording. A refusal of the solver has one by its code, since the
 * solver's own words name keys of project files. Other errors are shown with their own English message.
 */
import { nameWords } from '../document/names';
import { C2WarpError, codeOf, handlesOf, type SolverErrorCode, TOO_MUCH, wordingOf } from '../error';
import { en } from '../texts/en';
import { say, type Wording, worded } from '../texts/wording';

/** Errors of a step that is too much: people do not see by the sentence that it was taken back. */
const ENDS_STEP: readonly string[] = [
  TOO_MUCH,
  'too-much-memory',
  'too-much-work',
  'too-many-sites',
  'nothing-to-fill-from',
  'held-too-fine',
  'handles-crowded',
  'outline-too-long',
];

const isRefusal = (code: string): code is SolverErrorCode => code in en.errors.refusals;

/** @param reverted the step that caused the error was taken back. */
export function errorWords(error: Error, reverted = false): Wording {
  const words = sentenceOf(error);
  return reverted && ENDS_STEP.includes(codeOf(error))
    ? say('names.sentences', [words, say('errors.takenBack')])
    : words;
}

function sentenceOf(error: Error): Wording {
  const wording = wordingOf(error);
  if (wording) return wording;
  const code = codeOf(error);
  if (!isRefusal(code)) return say('errors.other', error.message);
  const [id = '', other = id] = handlesOf(error);
  return say(`errors.refusals.${code}`, error.message, nameWords({ id }), nameWords({ id: other }));
}

/** Refusals of a picture without a project, in which the person has set nothing. */
const FRESH = { 'nothing-opaque': 'errors.nothingOpaque', 'too-much': 'errors.pictureTooMuch' } as const;

/** The error of a picture that was just opened, with the same `code`; other errors are returned unchanged. */
export function ofFreshPicture(error: Error, picture: string): Error {
  const code = codeOf(error);
  if (code !== 'nothing-opaque' && code !== 'too-much') return error;
  const wording = say(FRESH[code], picture);
  return new C2WarpError(code, worded(en, wording), { cause: error, wording });
}
