/**
 * `npm run sizes`: the composition of the downloads in kB, as the tables of `web/docs/versions.md`. The solver and the
 * poser of rigs by groups of functions, and the script that a page waits for by folders.
 */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { build } from 'vite';
import { moduleGroups } from './module_groups.mjs';
import { prepare } from './prepare.mjs';
import { main, ROOT, step } from './steps.mjs';

const OUTPUT = 'target/sizes';
const CONFIG = 'web/vite.element.config.ts';
const SCRIPT = 'c2warp.js';

/** Smaller folders share the last row. */
const LEAST = 1000;

await main(async () => {
  await prepare();
  await step(
    'Solver and poser with names',
    'cargo',
    ['run', '--quiet', '--package', 'xtask', '--', 'bindgen', '--named', OUTPUT],
    'It does not build. The reason is above.',
  );
  const module = (/** @type {string} */ name) => moduleGroups(readFileSync(join(ROOT, OUTPUT, name)));
  print('Solver: the part that every page loads', module('c2warp_bg.wasm'));
  print('Solver: the later part', module('c2warp_later_bg.wasm'));
  print('Poser: loaded for rigs whose handles can be posed', module('pose_bg.wasm'));
  print('Script of the element', await folders());
});

/**
 * @param {string} title
 * @param {import('./module_groups.mjs').Group[]} groups
 */
function print(title, groups) {
  const kilobytes = (/** @type {number} */ bytes) => (bytes / 1000).toFixed(1);
  const small = groups.filter(({ brotli }) => brotli < LEAST);
  const rest = sum('the rest', small);
  const rows = [...groups.filter((group) => !small.includes(group)), rest, sum('**all**', groups)];
  console.log(`\n${title}\n\n| part | raw | brotli |\n|---|---|---|`);
  for (const { name, raw, brotli } of rows)
    console.log(`| ${name} | ${kilobytes(raw)} | ${kilobytes(brotli)} |`);
}

/**
 * @param {string} name
 * @param {import('./module_groups.mjs').Group[]} groups
 */
function sum(name, groups) {
  const total = (/** @type {'raw' | 'brotli'} */ kind) => groups.reduce((sum, group) => sum + group[kind], 0);
  return { name, raw: total('raw'), brotli: total('brotli') };
}

/**
 * The folders of the script, as it is bundled and not yet minified. Their compressed sizes are scaled to that of the
 * script.
 * @returns {Promise<import('./module_groups.mjs').Group[]>}
 */
async function folders() {
  const built = [
    await build({ configFile: join(ROOT, CONFIG), logLevel: 'error', build: { write: false } }),
  ].flat();
  const files = built.flatMap((bundle) => ('output' in bundle ? bundle.output : []));
  const script = files.find((file) => file.fileName === SCRIPT);
  if (script?.type !== 'chunk') throw new Error(`There is no ${SCRIPT}`);
  /** @type {Map<string, string[]>} */
  const texts = new Map();
  for (const [id, { code }] of Object.entries(script.modules)) {
    const folder = folderOf(id);
    texts.set(folder, [...(texts.get(folder) ?? []), code ?? '']);
  }
  const sizes = [...texts].map(([name, codes]) => ({ name, bytes: Buffer.from(codes.join('\n')) }));
  const alone = sizes.map(({ name, bytes }) => ({
    name,
    raw: bytes.length,
    brotli: brotliCompressSync(bytes).length,
  }));
  const { raw, brotli } = sum('all', alone);
  const whole = Buffer.from(script.code);
  const scaled = alone.map((one) => ({
    name: one.name,
    raw: (one.raw * whole.length) / raw,
    brotli: (one.brotli * brotliCompressSync(whole).length) / brotli,
  }));
  return scaled.sort((one, other) => other.brotli - one.brotli);
}

/** @param {string} id of a module */
function folderOf(id) {
  const path = id.replaceAll('\\', '/').split('/web/src/')[1];
  if (path) return path.includes('/') ? path.split('/').slice(0, -1).slice(0, 2).join('/') : path;
  return id.split('/node_modules/').at(-1)?.split('/')[0] ?? id;
}
