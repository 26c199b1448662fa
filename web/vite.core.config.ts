/**
 * Builds the solver without a screen, in dist/core: one module for pages and workers, one for Node, and the command.
 * They use the solver and the worker of the element, in dist/element.
 */
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { licences } from './scripts/licences.mjs';
import { plainUrlsPlugin } from './scripts/plain_urls.mjs';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

/** An expression that bundlers find files by. It is no file of this build. */
const ofElement = (file: string) => `new URL(/* @vite-ignore */ '../element/${file}', import.meta.url)`;

/** The parts of the solver. */
const FILES = ['c2warp_bg.wasm', 'c2warp_later_bg.wasm'];

const WORKER = './worker/worker?worker&url';

const filesOfElement: Plugin = {
  name: 'c2warp:files-of-element',
  enforce: 'pre',
  resolveId: (id) => (id.endsWith(WORKER.slice(1)) ? `\0${WORKER}` : null),
  load: (id) => (id === `\0${WORKER}` ? `export default ${ofElement('worker.js')}.href` : null),
  transform(code, id) {
    if (!id.endsWith('/compute/loading.ts')) return null;
    let named = code;
    for (const file of FILES) {
      const before = named;
      named = before.replace(`new URL('./generated/${file}', import.meta.url)`, ofElement(file));
      if (named === before) throw new Error(`loading.ts does not name ${file} as expected`);
    }
    return { code: named, map: null };
  },
};

const { plugins } = licences(['c2warp-bind', 'c2warp-cli']);

export default defineConfig({
  plugins: [filesOfElement, trimmed(), ...plugins, plainUrlsPlugin()],
  root: path('.'),
  base: './',
  publicDir: false,
  cacheDir: path('../node_modules/.vite'),
  build: {
    outDir: 'dist/core',
    target: 'es2022',
    // Without the code by which pages load style sheets.
    lib: {
      entry: { core: path('src/core.ts'), node: path('src/core_node.ts'), command: path('src/command.ts') },
      formats: ['es'],
    },
    rolldownOptions: {
      external: /^node:/,
      output: { entryFileNames: '[name].js', chunkFileNames: '[name].js' },
    },
  },
});
