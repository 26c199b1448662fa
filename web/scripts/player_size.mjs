/** Checks the sizes of the player's downloads. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { BUDGETS } from './budgets.mjs';
import { ROOT, StepError } from './steps.mjs';

const OF_PLAYER = BUDGETS.filter(({ files }) => files.every((file) => file.startsWith('player/')));

/**
 * Prints the sizes of a built player.
 * @param {string} folder that has the folder of the player, relative to the root of the repository
 * @throws {StepError} above a bound
 */
export function checkPlayerSize(folder) {
  for (const { name, files, most } of OF_PLAYER) {
    const sizes = files.map((file) => brotliCompressSync(readFileSync(join(ROOT, folder, file))).length);
    const size = sizes.reduce((sum, bytes) => sum + bytes, 0) / 1000;
    console.log(`${name}: ${size.toFixed(1)} kB by brotli`);
    if (size > most) throw new StepError(`${name}: ${size} kB by brotli, more than ${most}`);
  }
}
