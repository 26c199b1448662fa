/**
 * `npm run docs [-- --base /PATH/]`: writes the site to web/dist-site, as static files.
 *
 * It holds the pages of web/docs and web/site, the element, the player and the core beside them, and the documentation
 * of the Rust library. Without `--base`, the site is for the root of a server.
 */
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildPart } from './build_part.mjs';
import { prepare } from './prepare.mjs';
import { buildPages } from './site.mjs';
import { heading, main, ROOT, StepError, step } from './steps.mjs';

const SITE = join(ROOT, 'web/dist-site');

/** Parts of the build that the pages load, and that their readers may try. */
const PARTS = ['element', 'player', 'core'];

await main(async () => {
  const base = requestedBase();
  await prepare();
  await buildPages(SITE, base);
  for (const part of PARTS) {
    await buildPart(`For the pages: ${part}`, `web/vite.${part}.config.ts`);
    cpSync(join(ROOT, 'web/dist', part), join(SITE, part), { recursive: true });
  }
  await step(
    'Documentation of the library',
    'cargo',
    ['doc', '--package', 'c2warp', '--no-deps', '--all-features'],
    'The documentation does not build. The reason is above.',
  );
  const target = join(ROOT, process.env.CARGO_TARGET_DIR ?? 'target');
  cpSync(join(target, 'doc'), join(SITE, 'rustdoc'), { recursive: true });
  heading('Site');
  console.log(`The site is in ${SITE}, for a server that serves it at ${base}`);
});

/** @returns {string} */
function requestedBase() {
  let base = '/';
  try {
    base = parseArgs({ options: { base: { type: 'string', default: '/' } } }).values.base;
  } catch (error) {
    throw new StepError(
      `${error instanceof Error ? error.message : error}. Usage: npm run docs [-- --base /PATH/]`,
    );
  }
  if (!/^\/(?:.*\/)?$/.test(base))
    throw new StepError(`--base: expected a path that begins and ends with a slash, found "${base}".`);
  return base;
}
