/**
 * Makes lit-html a private part of the element: it imports without a DOM, and a page's own Lit does not hear of it.
 *
 * lit-html has a build for servers that draws in browsers as well. It tells a global list of its version, with which a
 * second Lit warns of several. It also asks a global for polyfills, and names a policy of Trusted Types.
 */
import { readFile } from 'node:fs/promises';

/** @type {readonly (readonly [text: string, instead: string])[]} */
const PARTS = [
  ['(t.litHtmlVersions??=[]).push("3.3.3");', ''],
  ['j=t.litHtmlPolyfillSupport;j?.(S,R),', 'j=0;'],
  ['createPolicy("lit-html",', 'createPolicy("c2warp-html",'],
];

/**
 * The server's build without its traces in the page.
 * @param {string} script
 */
export function privateLit(script) {
  return PARTS.reduce((code, [text, instead]) => {
    if (!code.includes(text)) throw new Error(`lit-html does not hold ${text}`);
    return code.replace(text, instead);
  }, script);
}

/** @returns {import('vite').Plugin} */
export const litHtml = () => ({
  name: 'c2warp:lit-html',
  enforce: 'pre',
  async load(id) {
    if (!/\/lit-html\/lit-html\.js$/.test(id)) return null;
    const file = id.replace('lit-html.js', 'node/lit-html.js');
    return { code: privateLit(await readFile(file, 'utf8')), map: null };
  },
});
