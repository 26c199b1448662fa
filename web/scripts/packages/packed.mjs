/** Packs the package of this checkout. */
import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { StepError, step } from '../steps.mjs';

/** Builds and packs the package. @param {string} folder @returns {Promise<string>} The file. */
export async function packed(folder) {
  const npm = process.env.npm_execpath;
  await step(
    'Package',
    npm ? process.execPath : 'npm',
    [...(npm ? [npm] : []), 'pack', '--pack-destination', folder],
    'The package cannot be packed. The reason is above.',
  );
  const name = (await readdir(folder)).find((file) => file.endsWith('.tgz'));
  if (name === undefined) throw new StepError('npm packed nothing: run `npm pack` to see why.');
  return join(folder, name);
}
