/**
 * Style sheets and shaders without their comments and indentation, and markup without its indentation: they are texts
 * inside of scripts, where minifiers leave everything as it is.
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
    if (/\/ui\/style\/\w+\.ts$/.test(id)) return { code: trimmedSheets(code), map: null };
    return /\/ui\/\w+\.ts$/.test(id) ? { code: trimmedMarkup(code), map: null } : null;
  },
});
