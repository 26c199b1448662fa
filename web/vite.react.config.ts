/** Builds the component for React, in dist/react. It imports the element, in dist/element, and the page's React. */
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { reactTables } from './scripts/manifest/react_tables.mjs';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

export default defineConfig({
  plugins: [reactTables(), trimmed()],
  root: path('.'),
  base: './',
  publicDir: false,
  cacheDir: path('../node_modules/.vite'),
  build: {
    outDir: 'dist/react',
    target: 'es2022',
    lib: { entry: path('src/react.ts'), formats: ['es'], fileName: () => 'c2warp-react.js' },
    rolldownOptions: {
      external: ['react'],
      // Next compiles it for the browser. The element defines its tag.
      output: { banner: "'use client';\nimport '../element/c2warp.js';" },
    },
  },
});
