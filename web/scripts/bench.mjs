/**
 * `npm run bench`: measures exports, films and playback, and the solver, natively and in Chromium's WebAssembly, in the
 * form of the paper's tables.
 *
 * The crate `c2warp-bench` defines the cases of the solver and measures them. The run fails if a part does not build or
 * run, but never because of slow times.
 */
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { exportTable } from './bench_exports.mjs';
import { animateTable, playingTable } from './bench_films.mjs';
import { launchChromium, prepareChromium } from './chromium.mjs';
import { prepare } from './prepare.mjs';
import { heading, main, ROOT, step } from './steps.mjs';

const OUTPUT = 'tests/output/bench';
const MODULE = ['c2warp.js', 'c2warp_bg.wasm'];

/** Rounds of native and WebAssembly runs in turn: a machine that is slow for a while slows both. */
const ROUNDS = 2;

/** No network request is made: the page's files are routed. A page on localhost may be cross-origin isolated. */
const ORIGIN = 'http://localhost';

const cargo = (/** @type {string} */ binary, /** @type {string[]} */ args) => [
  ...['run', '--quiet', '--release', '--package', 'c2warp-bench', '--bin', binary, '--'],
  ...args,
];

await main(async () => {
  // Read before the builds add to the load.
  const load = loadavg()[0] ?? 0;
  await prepare();
  await prepareChromium();
  const output = join(ROOT, OUTPUT);
  rmSync(output, { recursive: true, force: true });
  mkdirSync(output, { recursive: true });

  await step(
    'Build (native)',
    'cargo',
    ['build', '--release', '--package', 'c2warp-bench'],
    'The benchmark does not build. The reason is above.',
  );
  await step(
    'Build (WebAssembly)',
    'cargo',
    ['run', '--package', 'xtask', '--', 'bindgen', '--package', 'c2warp-bench', '--out', OUTPUT],
    'The benchmark does not build. The reason is above.',
  );
  const failed = 'The benchmark failed. The reason is above.';
  const native = join(output, 'native.json');
  const wasm = join(output, 'wasm.json');
  /** @type {unknown[]} */
  const natives = [];
  /** @type {unknown[]} */
  const wasms = [];
  for (let round = 1; round <= ROUNDS; round++) {
    await step(`Native, ${round} of ${ROUNDS}`, 'cargo', cargo('c2warp-bench', ['--json', native]), failed);
    natives.push(JSON.parse(readFileSync(native, 'utf8')));
    heading(`WebAssembly, ${round} of ${ROUNDS}`);
    wasms.push(JSON.parse(await ranInChromium(output)));
  }
  writeFileSync(native, JSON.stringify(natives.reduce(least)));
  writeFileSync(wasm, JSON.stringify(wasms.reduce(least)));
  await step('Memory', 'cargo', cargo('c2warp-bench-memory', [join(output, 'memory.json')]), failed);

  await step('Tables', 'cargo', cargo('c2warp-bench', ['--tables', output]), failed);
  await step('Growth', 'cargo', cargo('c2warp-bench-growth', []), failed);
  heading('Exports in Chromium');
  console.log(`\n${await exportTable()}`);
  heading('Films by the command');
  console.log(`\n${animateTable()}`);
  heading('Playing in Chromium');
  console.log(`\n${await playingTable()}`);
  const [cpu] = cpus();
  console.log(
    `\n${cpus().length} × ${cpu?.model.trim() ?? 'unknown'}, load ${load.toFixed(1)} at the start.`,
  );
  if (load > cpus().length / 2)
    console.log('Other programs were running, so times are longer and less certain.');
});

/**
 * The smaller of each number in two runs of the same cases; numbers of sites and samples are equal in both.
 * @param {unknown} a
 * @param {unknown} b
 * @returns {unknown}
 */
function least(a, b) {
  if (typeof a === 'number') return Math.min(a, Number(b));
  if (Array.isArray(a) && Array.isArray(b)) return a.map((value, at) => least(value, b[at]));
  const other = new Map(Object.entries(Object(b)));
  return Object.fromEntries(
    Object.entries(Object(a)).map(([key, value]) => [key, least(value, other.get(key))]),
  );
}

/**
 * Runs the module's cases in a page.
 * @param {string} folder The folder of the module.
 * @returns {Promise<string>} The measurements, as JSON.
 */
async function ranInChromium(folder) {
  const browser = await launchChromium();
  try {
    const page = await browser.newPage();
    await page.route(`${ORIGIN}/**`, (route) => {
      const name = new URL(route.request().url()).pathname.slice(1);
      const body = MODULE.includes(name)
        ? readFileSync(join(folder, name))
        : '<!doctype html><title>Benchmark</title>';
      const contentType = name.endsWith('.js') ? 'text/javascript' : name ? 'application/wasm' : 'text/html';
      // Isolated pages have a finer clock.
      const headers = {
        'Cross-Origin-Opener-Policy': 'same-origin',
        'Cross-Origin-Embedder-Policy': 'require-corp',
      };
      return route.fulfill({ body, contentType, headers });
    });
    await page.goto(`${ORIGIN}/`);
    if (!(await page.evaluate('crossOriginIsolated')))
      console.log('  not isolated: times in steps of 0.1 ms');
    return await page.evaluate(`import('/c2warp.js').then(async (module) => {
      await module.default({ module_or_path: '/c2warp_bg.wasm' });
      return module.run();
    })`);
  } finally {
    await browser.close();
  }
}
