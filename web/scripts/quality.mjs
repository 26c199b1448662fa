/**
 * `npm run quality`: how exact distances are, beside the geodesic, how often weights have a second maximum, and how well
 * pictures bend on standard poses, in every mode and by two other methods for comparison. Prints tables and writes a sheet of
 * pictures for each pose. The crate `c2warp-quality` defines and measures them.
 *
 * `npm run quality -- NAME` runs only what has a name that contains NAME: poses, `distances` or `maxima`. Fails if something
 * does not build or run, never because of a figure.
 */
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { prepare } from './prepare.mjs';
import { main, ROOT, step } from './steps.mjs';

const OUTPUT = 'tests/output/quality';
const CRATE = ['--release', '--package', 'c2warp-quality'];

await main(async () => {
  const names = process.argv.slice(2);
  await prepare();
  if (names.length === 0) rmSync(join(ROOT, OUTPUT), { recursive: true, force: true });
  await step(
    'Build',
    'cargo',
    ['build', ...CRATE],
    'The comparison does not build; the reason stands above.',
  );
  await step(
    'Distances, weights and poses',
    'cargo',
    ['run', '--quiet', ...CRATE, '--', OUTPUT, ...names],
    'The comparison failed; the reason stands above.',
  );
  console.log(`\nSheets for eyes are in ${OUTPUT}.`);
});
