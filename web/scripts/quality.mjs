/**
 * `npm run quality`: errors of distances, second maxima of weights, jumps of their derivatives, suggested handles,
 * fills of pictures whose truth is known, and the quality of poses by every mode and by other methods, beside the
 * optimum too.
 *
 * Prints tables and writes sheets of pictures. The crate `c2warp-quality` measures. `npm run quality -- NAME` runs the
 * parts with NAME in their name: poses, `optimum`, `distances`, `maxima`, `continuity`, `suggest` or `fill`. With
 * `photographs`, photographs are edited in the browser, and fills are compared with OpenCV's; with `photographs brush`,
 * only strokes of the brush are measured. The run fails if a part does not build or run, never because of a figure.
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
    console.log(`\nSheets of pictures are in ${OUTPUT}/photographs.`);
    return;
  }
  await step(
    'Distances, weights, suggestions and poses',
    'cargo',
    ['run', '--quiet', ...CRATE, '--', OUTPUT, ...names],
    'The comparison failed. The reason is above.',
  );
  console.log(`\nSheets of pictures are in ${OUTPUT}.`);
});
