/**
 * `npm run test:long`: tests that take too long for `npm test`. These are all random sequences of input while a picture
 * opens, all random edits and attacks, and the tests of the quality tables.
 */
import { prepareChromium } from './chromium.mjs';
import { prepare, prepareRustLints } from './prepare.mjs';
import { heading, main, run, toolPath } from './steps.mjs';

await main(async () => {
  await prepare();
  await prepareRustLints();
  await prepareChromium();
  const inBrowser = (/** @type {string[]} */ ...args) =>
    run(
      process.execPath,
      [toolPath('playwright'), 'test', '--config', 'tests/browser/playwright.config.ts', ...args],
      { env: { LONG_TESTS: '1' } },
    );
  heading('Random sequences');
  const sequences = await inBrowser('editor-early', '--grep', 'random sequences');
  heading('Random edits, and attacks');
  const attacks = await inBrowser('edits', 'attacks');
  heading('Tables of quality');
  const lints = await run('cargo', [
    'clippy',
    '--package',
    'c2warp-quality',
    '--all-targets',
    '--',
    '--deny',
    'warnings',
  ]);
  const quality = await run('cargo', ['test', '--package', 'c2warp-quality']);
  if ([sequences, attacks, lints, quality].some(({ code }) => code !== 0)) process.exitCode = 1;
});
