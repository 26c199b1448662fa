/**
 * `npm run quality`: measures errors of distances, second maxima of weights, jumps of their derivatives, suggested
 * handles, fills compared with the original pictures, drags, and the quality of poses. Poses of every mode are compared
 * with other methods and with the optimum.
 *
 * Prints tables and writes sheets of pictures. The crate `c2warp-quality` measures. `npm run quality -- NAME` runs the
 * parts with NAME in their name: poses, `optimum`, `drags`, `distances`, `maxima`, `continuity`, `suggest` or `fill`.
 * With `photographs`, photographs are edited in the browser, and fills are compared with OpenCV's; with `photographs
 * brush`, only strokes of the brush are measured. The run fails if a part does not build or run, but never because of a
 * result.
 */
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { brush, photographs } from './photographs/photographs.mjs';
import { prepare } from './prepare.mjs';
import { main, ROOT, step } from './steps.mjs';

const OUTPUT = 'tests/output/quality';
const CRATE = ['--release', '--package', 'c2warp-quality'];

await main(async () => {
  const names = process.argv.slice(2);
  await prepare();
  if (names.includes('photographs') && names.includes('brush')) return brush();
  if (names.length === 0) rmSync(join(ROOT, OUTPUT), { recursive: true, force: true });
  await step('Build', 'cargo', ['build', ...CRATE], 'The comparison does not build. The reason is above.');
  if (names.includes('photographs')) {
    await photographs(OUTPUT);
    console.log(`\nPicture sheets are in ${OUTPUT}/photographs.`);
    return;
  }
  await step(
    'Distances, weights, suggestions and poses',
    'cargo',
    ['run', '--quiet', ...CRATE, '--', OUTPUT, ...names],
    'The comparison failed. The reason is above.',
  );
  console.log(`\nPicture sheets are in ${OUTPUT}.`);
});
