/** Builds the player of rigs, in dist/player: one module without workers or other files. */
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

export default defineConfig({
  plugins: [trimmed()],
  root: path('.'),
  base: './',
  publicDir: false,
  cacheDir: path('../node_modules/.vite'),
  build: {
    outDir: 'dist/player',
    target: 'es2022',
    modulePreload: false,
    rolldownOptions: {
      input: { 'c2warp-player': path('src/player.ts') },
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js' },
    },
  },
});
