/**
 * Rewrites the addresses of a build's own files to the form that bundlers expect: `new URL("./file", import.meta.url)`.
 *
 * Vite nests two such expressions for assets. Next and webpack replace the inner one with an address on this machine.
 */

/** An inner address that is resolved once more. */
const NESTED =
  /new URL\(\s*(new URL\([^()]*,\s*import\.meta\.url\))\.href,\s*(?:["'`]{2}\s*\+\s*)?import\.meta\.url\s*\)/g;
const ADDRESS = /new URL\((?:\/\*.*?\*\/)?\s*(["'`])([^"'`$]+)\1,\s*import\.meta\.url\)/g;

/** @param {string} code */
export const plainUrls = (code) =>
  code
    .replaceAll(NESTED, '$1')
    .replaceAll(ADDRESS, (_, _quote, file) => `new URL(${JSON.stringify(relative(file))},import.meta.url)`);

const relative = (/** @type {string} */ file) => (/^\.{0,2}\//.test(file) ? file : `./${file}`);

/** @returns {import('vite').Plugin} for builds */
export const plainUrlsPlugin = () => ({
  name: 'c2warp:plain-urls',
  apply: 'build',
  enforce: 'post',
  generateBundle(_, bundle) {
    for (const chunk of Object.values(bundle)) {
      if (chunk.type === 'chunk') chunk.code = plainUrls(chunk.code);
    }
  },
});
