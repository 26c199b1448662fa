/**
 * The films of `npm run bench`: frames a second of `c2warp animate`, and milliseconds of CPU a frame while players and
 * the editor's timeline play in Chromium.
 *
 * Chromium draws on the CPU, in another process. So only the work on the page's main thread is counted.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { withServedEditor } from './served_editor.mjs';
import { ROOT, StepError } from './steps.mjs';

const SAMPLES = join(ROOT, 'web/public/samples');
/** The cat is 760 pixels wide and high; its clip lasts three seconds. */
const ANIMATE = `--clip breathe --fps 30 --scale ${1024 / 760}`.split(' ');
const FRAMES = 90;
const RUNS = 2;

/** Numbers of players, and frames to measure: a hundred take seconds a frame where Chromium draws on the CPU. */
const PLAYERS = /** @type {const} */ ([
  [1, 60],
  [10, 20],
  [100, 4],
]);
const EDITOR_FRAMES = 60;
/** In the first round of a clip, each pose is found for the first time. */
const EDITOR_FRAMES_BEFORE = 120;
const FRAMES_BEFORE = 3;
/** Holds all players: those out of sight do not play. */
const VIEWPORT = { width: 700, height: 1000 };
const PAGE = `<!doctype html><title>Players</title>
  <style>body { display: grid; grid-template-columns: repeat(10, 64px); margin: 0 }</style>
  <script type="module" src="/src/player.ts"></script>`;

/** @param {string[]} args */
function command(args) {
  const cargo = ['run', '--quiet', '--release', '--package', 'c2warp-cli', '--', ...args];
  const { status, stderr } = spawnSync('cargo', cargo, { cwd: ROOT, encoding: 'utf8' });
  if (status !== 0) throw new StepError(`The command failed: ${stderr}`);
}

/**
 * Runs with a folder that is removed afterwards.
 * @template T
 * @param {(folder: string) => T} run
 */
function inFolder(run) {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-bench-'));
  try {
    return run(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** @returns {string} A table in Markdown. */
export function animateTable() {
  // Builds the command.
  command(['--version']);
  const rows = ['gif', 'png', 'webp'].map((type) => {
    const seconds = inFolder((folder) => {
      const project = join(SAMPLES, 'cat.c2warp.json');
      const runs = Array.from({ length: RUNS }, () => {
        const start = performance.now();
        command(['animate', project, ...ANIMATE, '-o', join(folder, `film.${type}`)]);
        return (performance.now() - start) / 1000;
      });
      return Math.min(...runs);
    });
    return `| ${type} | ${seconds.toFixed(1)} | ${(FRAMES / seconds).toFixed(1)} |`;
  });
  return [
    `## Films of ${FRAMES} frames of 1024 × 1024 pixels by the command`,
    '',
    `With solving, on ${availableParallelism()} cores.`,
    '',
    '| format | s | frames a second |',
    '|---|---:|---:|',
    ...rows,
  ].join('\n');
}

/** @returns {Promise<string>} A table in Markdown. */
export async function playingTable() {
  const rig = inFolder((folder) => {
    const file = join(folder, 'sample.c2rig');
    command(['bake', join(SAMPLES, 'gingerbread.c2warp.json'), '-o', file]);
    return readFileSync(file);
  });
  return withServedEditor(async (browser, address) => {
    const rows = [];
    for (const [count, frames] of PLAYERS) {
      const page = await browser.newPage({ viewport: VIEWPORT });
      await page.route('**/players', (route) => route.fulfill({ body: PAGE, contentType: 'text/html' }));
      await page.route('**/sample.c2rig', (route) => route.fulfill({ body: rig }));
      await page.goto(`${address}players`);
      await called(page, 'players.js', count);
      rows.push(await row(count === 1 ? 'one player' : `${count} players`, page, frames));
      await page.close();
    }
    const page = await browser.newPage();
    await page.goto(address);
    await page.locator('c2-warp .solved', { hasText: 'mesh point' }).waitFor({ timeout: 120_000 });
    await page.locator('c2-warp').press('t');
    await page.locator('c2-warp').press('k');
    rows.push(
      await row('the editor with the sample, 100 virtual sites', page, EDITOR_FRAMES, EDITOR_FRAMES_BEFORE),
    );
    return [
      '## Playing in Chromium',
      '',
      'Milliseconds of the main thread per frame. Drawing in the graphics process takes extra time.',
      '',
      '| | script | all |',
      '|---|---:|---:|',
      ...rows,
    ].join('\n');
  });
}

/**
 * Calls the function of a file in a page.
 * @param {import('@playwright/test').Page} page
 * @param {'players.js' | 'frames.js'} file
 * @param {number} count
 */
const called = (page, file, count) => {
  const text = readFileSync(join(ROOT, 'tests/bench', file), 'utf8')
    .trim()
    .replace(/;$/, '');
  return page.evaluate(`(${text})(${count})`);
};

/**
 * Measures the frames of a page that plays.
 * @param {string} name
 * @param {import('@playwright/test').Page} page
 * @param {number} frames
 * @param {number} [before] frames that play first
 */
async function row(name, page, frames, before = FRAMES_BEFORE) {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable');
  const seconds = async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return ['ScriptDuration', 'TaskDuration'].map(
      (name) => metrics.find((one) => one.name === name)?.value ?? 0,
    );
  };
  await called(page, 'frames.js', before);
  const start = await seconds();
  await called(page, 'frames.js', frames);
  const after = await seconds();
  const ms = after.map((end, at) => (((end - (start[at] ?? 0)) * 1000) / frames).toFixed(2));
  return `| ${name} | ${ms.join(' | ')} |`;
}
