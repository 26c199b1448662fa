/** Builds the pages of the site, without the parts that `npm run docs` adds. */
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, relative, sep } from 'node:path';
import { ROOT, step, toolPath } from './steps.mjs';

/**
 * Writes the pages to a folder.
 * @param {string} folder It is emptied first.
 * @param {string} base The path of the site on its server: it begins and ends with a slash.
 */
export function buildPages(folder, base) {
  return step(
    'Pages of the site',
    process.execPath,
    [toolPath('vitepress'), 'build', join(ROOT, 'web/site'), '--outDir', folder, '--base', base],
    'The site does not build. The reason is above.',
  );
}

/**
 * The files of the pages by their names.
 * @param {string} base
 * @returns {Promise<Map<string, Uint8Array>>}
 */
export async function builtPages(base) {
  const folder = await mkdtemp(join(tmpdir(), 'c2warp-site-'));
  try {
    await buildPages(folder, base);
    const entries = await readdir(folder, { recursive: true, withFileTypes: true });
    const files = entries
      .filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath, entry.name));
    const named = files.map(
      async (file) =>
        /** @type {const} */ ([relative(folder, file).split(sep).join('/'), await readFile(file)]),
    );
    return new Map(await Promise.all(named));
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}
