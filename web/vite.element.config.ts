/**
 * Builds the element for other pages, in dist/element: one module, its workers and the solver. The files have fixed
 * names and relative URLs. They work in plain pages, and bundlers include them as assets.
 */
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './scripts/licences.mjs';
import { litHtml } from './scripts/lit_html.mjs';
import { plainUrlsPlugin } from './scripts/plain_urls.mjs';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

const output = {
  entryFileNames: '[name].js',
  chunkFileNames: '[name].js',
  assetFileNames: '[name][extname]',
};

const { plugins, worker } = licences();

export default defineConfig({
  plugins: [litHtml(), trimmed(), ...plugins, plainUrlsPlugin()],
  root: path('.'),
  base: './',
  publicDir: false,
  cacheDir: path('../node_modules/.vite'),
  worker: { format: 'es', plugins: () => [...worker(), plainUrlsPlugin()], rolldownOptions: { output } },
  build: {
    outDir: 'dist/element',
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: false,
    rolldownOptions: {
      input: { c2warp: path('src/element.ts') },
      // One script stays one script: the study card, loaded when it is first shown, imports from it.
      preserveEntrySignatures: 'allow-extension',
      output,
    },
  },
});
