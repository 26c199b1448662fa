/** Builds the packages of a release in a folder: `node web/scripts/release_packages.mjs FOLDER`. */
import { resolve } from 'node:path';
import { crates, npmPackage } from './packing.mjs';
import { main, StepError } from './steps.mjs';

await main(async () => {
  const [folder] = process.argv.slice(2);
  if (!folder) throw new StepError('Name a folder for the packages.');
  const { warnings } = await npmPackage(resolve(folder));
  await crates(resolve(folder));
  for (const warning of warnings) console.log(`! ${warning}`);
});
