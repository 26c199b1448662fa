/** The films of `npm run bench`: frames a second of `c2warp animate`. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT, StepError } from './steps.mjs';

const SAMPLES = join(ROOT, 'web/public/samples');
/** The cat is 760 pixels wide and high; its clip lasts three seconds. */
const ANIMATE = `--clip breathe --fps 30 --scale ${1024 / 760}`.split(' ');
const FRAMES = 90;
const RUNS = 2;

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
