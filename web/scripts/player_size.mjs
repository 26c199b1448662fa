/** The bound on the download of the player. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { BUDGETS } from './budgets.mjs';
import { ROOT, StepError } from './steps.mjs';

/** Compressed by brotli, all scripts together. */
const MOST_PLAYER_BYTES = 1000 * (BUDGETS.find(({ name }) => name === 'player')?.most ?? 0);

/** @param {Iterable<string | Uint8Array>} scripts */
export function brotliBytes(scripts) {
  return [...scripts].reduce((sum, script) => sum + brotliCompressSync(script).length, 0);
}

/**
 * Prints the size of a built player.
 * @param {string} folder relative to the root of the repository
 * @throws {StepError} above the bound
 */
export function checkPlayerSize(folder) {
  const names = readdirSync(join(ROOT, folder)).filter((name) => name.endsWith('.js'));
  const bytes = brotliBytes(names.map((name) => readFileSync(join(ROOT, folder, name))));
  console.log(`The player takes ${(bytes / 1000).toFixed(1)} kB by brotli.`);
  if (bytes > MOST_PLAYER_BYTES)
    throw new StepError(`The player takes ${bytes} bytes by brotli: more than ${MOST_PLAYER_BYTES}.`);
}
