/**
 * Removes comments and indentation from style sheets and shaders, and indentation from markup. Minifiers do not change
 * these, because they are strings in scripts. Also lets bundlers drop unused classes of the WebAssembly glue.
 */

/** A style sheet in a template. Its expressions contain no templates. */
const SHEET = /\bcss`[^`]*`/g;

/** @param {string} code a script with style sheets */
export const trimmedSheets = (code) =>
  code.replaceAll(SHEET, (sheet) => sheet.replaceAll(/\s*\/\*.*?\*\//gs, '').replaceAll(/\n\s+/g, '\n'));

/** @param {string} code a script whose templates are markup, in which a newline equals any space */
export const trimmedMarkup = (code) => code.replaceAll(/\n\s+/g, '\n');

/** @param {string} shader */
export const trimmedShader = (shader) => shader.replaceAll(/\n\s*\/\/.*/g, '').replaceAll(/\n\s+/g, '\n');

/**
 * Removes the code by which unused classes count as used.
 * @param {string} glue by wasm-bindgen
 */
export const trimmedGlue = (glue) =>
  glue
    .replaceAll(/^if \(Symbol\.dispose\) .*\n/gm, '')
    .replaceAll('new FinalizationRegistry', '/* @__PURE__ */ new FinalizationRegistry');

/** @returns {import('vite').Plugin} for builds */
export const trimmed = () => ({
  name: 'trimmed',
  apply: 'build',
  enforce: 'pre',
  transform(code, id) {
    if (id.endsWith('.glsl?raw')) {
      const shader = JSON.parse(code.slice(code.indexOf('"'), code.lastIndexOf('"') + 1));
      return { code: `export default ${JSON.stringify(trimmedShader(shader))}`, map: null };
    }
    if (/\/generated\/(c2warp|c2warp_export|film|pose)\.js$/.test(id))
      return { code: trimmedGlue(code), map: null };
    if (/\/ui\/style\/\w+\.ts$/.test(id)) return { code: trimmedSheets(code), map: null };
    return /\/ui\/(export\/)?\w+\.ts$/.test(id) ? { code: trimmedMarkup(code), map: null } : null;
  },
});
