/** Why the solver refuses a picture that came without a project: nobody who opens one has set the keys that its own words name. */

const WORDS: Readonly<Record<string, string>> = {
  'nothing-opaque': 'nothing in this picture is opaque enough to be warped.',
  domain: 'the outline of this picture has too many corners to be warped: smooth its transparency.',
};

/** The same error, led by the file's name. */
export function inEditorsWords(error: Error & { readonly code?: unknown }, name: string): Error {
  const words = WORDS[String(error.code)];
  if (words === undefined) return error;
  return Object.assign(new Error(`${name}: ${words}`, { cause: error }), { code: error.code });
}
