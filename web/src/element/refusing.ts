/** Refusals of a picture without a project: the solver's messages name project keys that the person has never set. */

const WORDS: Readonly<Record<string, string>> = {
  'nothing-opaque': 'nothing in this picture is opaque enough to be warped.',
  domain: 'the outline of this picture has too many corners to be warped: smooth its transparency.',
};

/** The error in words for the editor, with the same `code`; other errors are returned unchanged. */
export function inEditorsWords(error: Error & { readonly code?: unknown }, name: string): Error {
  const words = WORDS[String(error.code)];
  if (words === undefined) return error;
  return Object.assign(new Error(`${name}: ${words}`, { cause: error }), { code: error.code });
}
