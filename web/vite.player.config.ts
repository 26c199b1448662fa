/** Builds the player of rigs, in dist/player: one module without workers. The solver is loaded later. */
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './scripts/licences.mjs';
import { plainUrlsPlugin } from './scripts/plain_urls.mjs';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

const { plugins } = licences(['c2warp-pose-bind']);

export default defineConfig({
  plugins: [trimmed(), ...plugins, plainUrlsPlugin()],
  root: path('.'),
  base: './',
  publicDir: false,
  cacheDir: path('../node_modules/.vite'),
  build: {
    outDir: 'dist/player',
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: false,
    rolldownOptions: {
      input: { 'c2warp-player': path('src/player.ts') },
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js', chunkFileNames: '[name].js', assetFileNames: '[name][extname]' },
    },
  },
});
