/**
 * Makes lit-html a private part of the element: it can be imported without a DOM, and does not affect a page's own Lit.
 *
 * lit-html has a build for servers that draws in browsers as well. It adds its version to a global list, and a second
 * Lit then warns of multiple versions. It also reads polyfills from a global, and names a policy of Trusted Types.
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
    if (!code.includes(text)) throw new Error(`lit-html does not contain ${text}`);
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
