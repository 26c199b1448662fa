/** The service worker of the editor, built with the list of all files that the page needs. */
import { createHash } from 'node:crypto';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const ENTRY = fileURLToPath(new URL('../src/app/service_worker.ts', import.meta.url));
export const FILE = 'service-worker.js';

/** The sources of the drawn samples are not for the page. */
const UNUSED = /^samples\/.*\.svg$/;

/**
 * A plugin that writes `service-worker.js` beside `index.html`.
 * @returns {import('vite').Plugin}
 */
export function serviceWorker() {
  let publicDir = '';
  return {
    name: 'c2warp:service-worker',
    apply: 'build',
    enforce: 'post',
    configResolved(config) {
      publicDir = config.publicDir;
    },
    generateBundle: {
      // The contents are hashed: no other plugin may change them later.
      order: 'post',
      async handler(_, bundle) {
        /** @type {Record<string, string | Uint8Array>} */
        const contents = {};
        for (const file of Object.values(bundle))
          contents[file.fileName] = file.type === 'asset' ? file.source : file.code;
        Object.assign(contents, await publicFiles(publicDir));
        this.emitFile({ type: 'asset', fileName: FILE, source: await workerOf(hashesOf(contents)) });
      },
    },
  };
}

/**
 * The hash of each content by its path. The page has the path "": servers may redirect index.html.
 * @param {Record<string, string | Uint8Array>} contents
 * @returns {Record<string, string>}
 */
export function hashesOf(contents) {
  const entries = Object.entries(contents)
    .filter(([path]) => !UNUSED.test(path))
    .map(([path, content]) => {
      const hash = createHash('sha256').update(content).digest('base64');
      return [path === 'index.html' ? '' : path, `sha256-${hash}`];
    });
  return Object.fromEntries(entries.sort(([a = ''], [b = '']) => (a < b ? -1 : 1)));
}

/**
 * @param {string} folder empty without one
 * @returns {Promise<Record<string, Uint8Array>>} by the path in the folder
 */
async function publicFiles(folder) {
  if (!folder) return {};
  const found = await readdir(folder, { recursive: true, withFileTypes: true });
  const paths = found.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name));
  const read = paths.map(async (path) => [
    path.slice(folder.length + 1).replaceAll('\\', '/'),
    await readFile(path),
  ]);
  return Object.fromEntries(await Promise.all(read));
}

/**
 * The script of the worker. It is a classic script, which all browsers start.
 * @param {Record<string, string>} hashes
 */
async function workerOf(hashes) {
  // Vite loads this file with its configuration, before it is ready itself.
  const { build } = await import('vite');
  const result = await build({
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    define: { FILE_HASHES: JSON.stringify(hashes) },
    build: {
      write: false,
      target: 'es2022',
      rolldownOptions: { input: ENTRY, output: { format: 'iife' } },
    },
  });
  const [output] = [result].flat();
  if (!output || !('output' in output)) throw new Error('The service worker does not build.');
  return output.output[0].code;
}
