/**
 * `npm test`: prepares the machine, then runs the checks, the native tests, the unit tests and the browser tests.
 *
 * All of them run, even after failures. The last line sums up.
 */
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { NOT_OF_QUALITY, runChecks } from './checks.mjs';
import { prepareChromium } from './chromium.mjs';
import { buildCommand } from './command.mjs';
import { cargoCounts, playwrightCounts, summary, vitestCounts } from './counts.mjs';
import { npmPackage } from './packing.mjs';
import { prepare, prepareRustLints } from './prepare.mjs';
import { heading, lacksNetwork, main, ROOT, run, StepError, toolPath } from './steps.mjs';

/** @typedef {import('./counts.mjs').Counts} Counts */

const OUTPUT = 'tests/output';
/** Examples of embeddings: without a bundler, with one, and by a framework. `npm run test:packages` has all. */
const EXAMPLES = ['plain', 'vite', 'next'];

await main(async () => {
  await prepare();
  await prepareRustLints();
  // Beside browser tests its build would take minutes longer than on its own.
  await buildCommand();
  await prepareChromium();
  mkdirSync(join(ROOT, OUTPUT), { recursive: true });

  const checks = await runChecks();
  const parts = {
    Checks: { passed: checks.passed, failed: checks.failed.length, skipped: 0 },
    'Native tests': await nativeTests(),
    'Unit tests': await reported(
      'Unit tests',
      [toolPath('vitest'), 'run', '--config', 'web/vite.config.ts', '--reporter=default', '--reporter=json'],
      (report) => ({ args: [`--outputFile.json=${report}`], env: {} }),
      vitestCounts,
    ),
    Packages: await packages(),
    'Browser tests': await reported(
      'Browser tests',
      [
        toolPath('playwright'),
        'test',
        '--config',
        'tests/browser/playwright.config.ts',
        '--reporter=list,json',
      ],
      (report) => ({ args: [], env: { PLAYWRIGHT_JSON_OUTPUT_FILE: report } }),
      playwrightCounts,
    ),
  };

  heading('Result');
  for (const [title, { passed, failed, skipped }] of Object.entries(parts)) {
    console.log(`${title}: ${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`);
  }
  for (const title of checks.failed) console.log(`✗ ${title}`);
  const all = Object.values(parts);
  console.log(`\n${summary(all)}`);
  if (all.some(({ failed }) => failed > 0)) process.exitCode = 1;
});

/** @returns {Promise<Counts>} */
async function packages() {
  try {
    const { tarball } = await npmPackage(join(ROOT, OUTPUT, 'packages'));
    heading(`Examples: ${EXAMPLES.join(', ')}`);
    const { code, output } = await run(process.execPath, [
      'web/scripts/packages.mjs',
      '--tarball',
      tarball,
      ...EXAMPLES,
    ]);
    if (code === 0) return { passed: 2, failed: 0, skipped: 0 };
    // Only this step needs the registry.
    return lacksNetwork(output) ? { passed: 1, failed: 0, skipped: 1 } : { passed: 1, failed: 1, skipped: 0 };
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    console.error(`✗ ${error.message}`);
    return { passed: 0, failed: 1, skipped: 0 };
  }
}

/** @returns {Promise<Counts>} */
async function nativeTests() {
  heading('Native tests');
  const { code, output } = await run('cargo', ['test', '--workspace', ...NOT_OF_QUALITY, '--no-fail-fast']);
  return endedWith(code, cargoCounts(output));
}

/**
 * Runs a test runner that writes a JSON report.
 * @param {string} title
 * @param {string[]} args For Node.
 * @param {(report: string) => { args: string[], env: NodeJS.ProcessEnv }} reportTo Sets the runner's report file.
 * @param {(json: string) => Counts} counts
 * @returns {Promise<Counts>}
 */
async function reported(title, args, reportTo, counts) {
  heading(title);
  const report = join(ROOT, OUTPUT, `${title.toLowerCase().replace(' ', '-')}.json`);
  rmSync(report, { force: true });
  const extra = reportTo(report);
  const { code } = await run(process.execPath, [...args, ...extra.args], { env: extra.env });
  let result = { passed: 0, failed: 0, skipped: 0 };
  try {
    result = counts(readFileSync(report, 'utf8'));
  } catch {
    // The runner ended before it could report; its exit code counts instead.
  }
  return endedWith(code || (result.passed === 0 ? 1 : 0), result);
}

/**
 * Counts a runner that failed without naming a test, for example in compiling, as one failure.
 * @param {number} code
 * @param {Counts} counts
 * @returns {Counts}
 */
function endedWith(code, counts) {
  return code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
}
