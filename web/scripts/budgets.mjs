/**
 * Upper bounds for the sizes of downloads, compressed by brotli. The browser tests and the release check the build
 * against them.
 *
 * A page waits for the first two. It loads the others when they are first used.
 */
import { brotliCompressSync } from 'node:zlib';

/** @typedef {{ name: string, files: readonly string[], most: number }} Budget Paths below `web/dist`; most in kB. */

/** @type {readonly Budget[]} */
export const BUDGETS = [
  { name: 'script of the element', files: ['element/c2warp.js'], most: 155 },
  { name: 'element with its solver', files: ['element/c2warp.js', 'element/c2warp_bg.wasm'], most: 540 },
  { name: 'first drawing, fill or suggestion', files: ['element/c2warp_later_bg.wasm'], most: 88 },
  { name: 'another language', files: ['element/fr.js'], most: 16 },
  { name: 'lens and study', files: ['element/study.js'], most: 11 },
  { name: 'timeline', files: ['element/timeline.js'], most: 6 },
  { name: 'comparison', files: ['element/compare.js'], most: 2 },
  { name: 'export panel and first film', files: ['element/pages.js', 'element/filming.js'], most: 6 },
  { name: 'encoders of animated pictures', files: ['element/film_bg.wasm'], most: 98 },
  { name: 'encoders of videos', files: ['element/videos.js'], most: 38 },
  { name: 'encoders of animated pictures, script', files: ['element/animations.js'], most: 5 },
  { name: 'zipped films', files: ['element/zips.js'], most: 11 },
  { name: 'first rig, map or SVG: scripts', files: ['element/rig_file.js', 'element/exporter.js'], most: 10 },
  { name: 'first rig, map or SVG: module', files: ['element/c2warp_export_bg.wasm'], most: 986 },
  { name: 'player', files: ['player/c2warp-player.js'], most: 15 },
  {
    name: 'player that poses in the rigid mode',
    files: ['player/c2warp-player.js', 'player/module_poser.js', 'player/pose_bg.wasm'],
    most: 120,
  },
  { name: 'core in Node, without the solver', files: ['core/node.js'], most: 29 },
  { name: 'core in pages, without the solver', files: ['core/core.js'], most: 19 },
  { name: 'script of the command', files: ['core/command.js'], most: 1 },
];

const IMPORT = /\b(?:from|import) ?"\.\/([\w-]+\.js)"/g;
/** Everything else of the element is loaded after this. */
const FIRST = 'element/c2warp.js';

/**
 * The size of each download in kB, with the scripts that its scripts import at once. Those of the element itself do not
 * count for later ones.
 * @param {(path: string) => Promise<Uint8Array>} read Reads a file below `web/dist`.
 * @returns {Promise<(Budget & { size: number })[]>}
 */
export async function sizesOf(read) {
  /** @type {Map<string, Promise<{ size: number, imports: string[] }>>} */
  const known = new Map();
  const file = (/** @type {string} */ path) => {
    const found = known.get(path) ?? read(path).then((bytes) => measured(path, bytes));
    known.set(path, found);
    return found;
  };
  const closure = async (/** @type {readonly string[]} */ first, /** @type {readonly string[]} */ loaded) => {
    const paths = [...first];
    for (const path of paths)
      for (const name of (await file(path)).imports)
        if (!paths.includes(name) && !loaded.includes(name)) paths.push(name);
    return paths;
  };
  const element = await closure([FIRST], []);
  const sizes = BUDGETS.map(async (budget) => {
    const paths = await closure(budget.files, budget.files.includes(FIRST) ? [] : element);
    const files = await Promise.all(paths.map(file));
    return { ...budget, size: files.reduce((sum, { size }) => sum + size, 0) / 1000 };
  });
  return Promise.all(sizes);
}

/**
 * @param {string} path
 * @param {Uint8Array} bytes
 */
function measured(path, bytes) {
  const text = path.endsWith('.js') ? new TextDecoder().decode(bytes) : '';
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  const imports = [...text.matchAll(IMPORT)].map(([, name]) => `${folder}${name}`);
  return { size: brotliCompressSync(bytes).length, imports };
}
