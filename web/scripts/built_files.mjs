/** Builds in memory, so that concurrent runs do not disturb each other. */
import { build } from 'vite';

/**
 * The files of a build by their names.
 * @param {import('vite').InlineConfig} config
 * @returns {Promise<Map<string, string | Uint8Array>>}
 */
export async function builtFiles(config) {
  const files = new Map();
  const built = await build({ ...config, build: { write: false } });
  for (const bundle of [built].flat()) {
    if (!('output' in bundle)) continue;
    for (const file of bundle.output)
      files.set(file.fileName, file.type === 'asset' ? file.source : file.code);
  }
  return files;
}
