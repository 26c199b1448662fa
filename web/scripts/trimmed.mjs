/**
 * Style sheets and shaders without their comments and indentation, and markup without its indentation: they are texts
 * inside of scripts, where minifiers leave everything as it is. The glue of WebAssembly without what holds classes that the
 * page does not use.
 */

/** A style sheet in a template; expressions in it hold no template of their own. */
const SHEET = /\bcss`[^`]*`/g;

/** @param {string} code a script with style sheets */
export const trimmedSheets = (code) =>
  code.replaceAll(SHEET, (sheet) => sheet.replaceAll(/\s*\/\*.*?\*\//gs, '').replaceAll(/\n\s+/g, '\n'));

/** @param {string} code a script whose templates are markup, where a newline is as good as more space */
export const trimmedMarkup = (code) => code.replaceAll(/\n\s+/g, '\n');

/** @param {string} shader */
export const trimmedShader = (shader) => shader.replaceAll(/\n\s*\/\/.*/g, '').replaceAll(/\n\s+/g, '\n');

/**
 * @param {string} glue by wasm-bindgen: bundlers leave out a class of it that nothing uses only where nothing else names the
 * class, and where its registry does nothing
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
    if (id.endsWith('/compute/generated/c2warp.js')) return { code: trimmedGlue(code), map: null };
    if (/\/ui\/style\/\w+\.ts$/.test(id)) return { code: trimmedSheets(code), map: null };
    return /\/ui\/\w+\.ts$/.test(id) ? { code: trimmedMarkup(code), map: null } : null;
  },
});
