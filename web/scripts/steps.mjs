/**
 * Steps of a command line job. Each prints its title and the output of its programs. A failed step ends the job with
 * one line of advice. This file uses no npm packages, because it installs them.
 */
import { spawn, spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The folder of package.json. */
export const ROOT = fileURLToPath(new URL('../..', import.meta.url));

const OFFLINE =
  /ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ENETUNREACH|ETIMEDOUT|ECONNRESET|resolve host|could not connect|error sending request|failed to download|spurious network error|temporary failure/i;

/** Whether a program failed because it had no network. @param {string} output */
export const lacksNetwork = (output) => OFFLINE.test(output);

/** Command line tools among the npm packages. Node runs them directly: quicker than npx, and the same on Windows. */
const TOOLS = {
  attw: '@arethetypeswrong/cli/dist/index.js',
  biome: '@biomejs/biome/bin/biome',
  playwright: '@playwright/test/cli.js',
  publint: 'publint/src/cli.js',
  tsc: 'typescript/bin/tsc',
  vite: 'vite/bin/vite.js',
  vitepress: 'vitepress/bin/vitepress.js',
  vitest: 'vitest/vitest.mjs',
};

/**
 * The path of the script with which Node runs a tool.
 * @param {keyof typeof TOOLS} name
 */
export const toolPath = (name) => join(ROOT, 'node_modules', TOOLS[name]);

/** A failed step, with advice as its message. */
export class StepError extends Error {}

/** @typedef {{ code: number, output: string }} Ended A program's exit code, and the end of its output. */

/**
 * Runs a program, passing on its output.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv }} [options]
 * @returns {Promise<Ended>}
 */
export function run(program, args, { env = {} } = {}) {
  const colour = process.stdout.isTTY ? { FORCE_COLOR: '1', CARGO_TERM_COLOR: 'always' } : {};
  return new Promise((resolve) => {
    const child = spawn(program, args, {
      cwd: ROOT,
      env: { ...process.env, ...colour, ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    let output = '';
    const tee = (/** @type {NodeJS.WriteStream} */ to) => (/** @type {Buffer} */ chunk) => {
      to.write(chunk);
      output = (output + chunk.toString()).slice(-200_000);
    };
    child.stdout.on('data', tee(process.stdout));
    child.stderr.on('data', tee(process.stderr));
    child.on('error', (error) => resolve({ code: 127, output: String(error) }));
    child.on('close', (code) => resolve({ code: code ?? 1, output }));
  });
}

/**
 * Runs a program that has to succeed.
 * @param {string} title The name of the step.
 * @param {string} program
 * @param {string[]} args
 * @param {string} hint Advice for failures other than a missing network.
 */
export async function step(title, program, args, hint) {
  heading(title);
  const { code, output } = await run(program, args);
  if (code === 0) return;
  throw new StepError(
    lacksNetwork(output) ? `${title}: no network. Connect this machine and run the command again.` : hint,
  );
}

/** @param {string} title */
export function heading(title) {
  console.log(process.stdout.isTTY ? `\x1b[1m▸ ${title}\x1b[0m` : `▸ ${title}`);
}

/**
 * The output of a program, or undefined if it is missing or fails.
 * @param {string} program
 * @param {string[]} args
 * @returns {string | undefined}
 */
export function printed(program, args) {
  const { status, stdout } = spawnSync(program, args, { cwd: ROOT, encoding: 'utf8' });
  return status === 0 ? stdout.trim() : undefined;
}

/**
 * Runs a whole job; a failed step ends the job with its message.
 * @param {() => Promise<void>} job
 */
export async function main(job) {
  try {
    await job();
  } catch (error) {
    if (!(error instanceof StepError)) throw error;
    console.error(`\n✗ ${error.message}`);
    process.exitCode = 1;
  }
}
