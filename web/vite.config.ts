import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { licences } from './scripts/licences.mjs';
import { litHtml } from './scripts/lit_html.mjs';
import { reactTables } from './scripts/manifest/react_tables.mjs';
import { serviceWorker } from './scripts/service_worker.mjs';
import { trimmed } from './scripts/trimmed.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

const { plugins, worker } = licences();

export default defineConfig({
  plugins: [litHtml(), trimmed(), ...plugins, reactTables(), serviceWorker()],
  root: path('.'),
  // Relative, so that the built page works at any address.
  base: './',
  cacheDir: path('../node_modules/.vite'),
  server: { fs: { allow: [path('..')] } },
  // The pages of web/examples import a package that is installed there alone.
  optimizeDeps: { entries: ['index.html'] },
  worker: { format: 'es', plugins: worker },
  build: {
    target: 'es2022',
    // The wasm stays a separate file, so that browsers compile it while it streams.
    assetsInlineLimit: 0,
  },
  test: {
    include: ['src/**/*.test.ts', 'site/**/*.test.ts', 'scripts/**/*.test.mjs'],
    environment: 'node',
    // Tests pass on a busy machine, too.
    testTimeout: 60_000,
  },
});
