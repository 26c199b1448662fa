/**
 * Prepares a machine with rustup, Node and npm: checks versions, installs missing parts, and builds the solver.
 * Finished parts are skipped.
 */
import { existsSync, readFileSync, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { printed, ROOT, StepError, step } from './steps.mjs';

const WASM_TARGET = 'wasm32-unknown-unknown';

/** Everything up to the solver's module in web/src/compute/generated. */
export async function prepare() {
  checkNode();
  await prepareRust();
  await prepareNpm();
  await step(
    'Solver (Rust → WebAssembly)',
    'cargo',
    ['run', '--package', 'xtask', '--', 'bindgen'],
    'The solver does not build. The reason is above.',
  );
}

/** Installs the parts of the Rust toolchain that lint and format. */
export async function prepareRustLints() {
  if (printed('cargo', ['clippy', '--version']) && printed('cargo', ['fmt', '--version'])) return;
  await step(
    'clippy and rustfmt',
    'rustup',
    ['component', 'add', 'clippy', 'rustfmt'],
    'clippy or rustfmt is missing, and rustup could not add it: run `rustup component add clippy rustfmt`.',
  );
}

function checkNode() {
  const [major = 0, minor = 0] = process.versions.node.split('.').map(Number);
  const supported = major > 22 || (major === 22 && minor >= 12) || (major === 20 && minor >= 19);
  if (!supported) {
    throw new StepError(`Node ${process.versions.node} is too old: install Node 20.19, 22.12 or later.`);
  }
}

async function prepareRust() {
  // rustup adds itself to PATH only at the next login.
  const bin = join(process.env.CARGO_HOME ?? join(homedir(), '.cargo'), 'bin');
  if (!process.env.PATH?.split(delimiter).includes(bin)) process.env.PATH += delimiter + bin;

  const rustup = printed('rustup', ['--version']) !== undefined;
  if (rustup && printed('rustc', ['--version']) === undefined) {
    await step(
      'Rust toolchain',
      'rustup',
      ['toolchain', 'install', 'stable', '--profile', 'default'],
      'rustup has no toolchain and could not install one: run `rustup default stable`.',
    );
  }
  const version = printed('rustc', ['--version']);
  if (version === undefined || printed('cargo', ['--version']) === undefined) {
    throw new StepError('Rust is missing: install rustup from https://rustup.rs and run the command again.');
  }
  checkRustVersion(version);
  await prepareTarget(WASM_TARGET);
}

/**
 * Installs the standard library of a target.
 * @param {string} target
 */
export async function prepareTarget(target) {
  const library = printed('rustc', ['--print', 'target-libdir', '--target', target]);
  if (library !== undefined && existsSync(library)) return;
  if (printed('rustup', ['--version']) === undefined) {
    throw new StepError(
      `This Rust cannot build for ${target}: install rustup from https://rustup.rs and run the command again.`,
    );
  }
  await step(
    `Rust target ${target}`,
    'rustup',
    ['target', 'add', target],
    `rustup could not add the target: run \`rustup target add ${target}\` to see why.`,
  );
}

/** @param {string} version The output of `rustc --version`. */
function checkRustVersion(version) {
  const least = /^rust-version = "(\d+)\.(\d+)"/m.exec(readFileSync(join(ROOT, 'Cargo.toml'), 'utf8'));
  const here = /^rustc (\d+)\.(\d+)/.exec(version);
  if (!least || !here) return;
  const number = (/** @type {RegExpExecArray} */ match) => Number(match[1]) * 1000 + Number(match[2]);
  if (number(here) < number(least)) {
    throw new StepError(
      `Rust ${here[1]}.${here[2]} is too old, ${least[1]}.${least[2]} is needed: run \`rustup update stable\`.`,
    );
  }
}

/** npm writes node_modules/.package-lock.json last: its age is that of a complete installation. */
async function prepareNpm() {
  const installed = join(ROOT, 'node_modules/.package-lock.json');
  const lock = join(ROOT, 'package-lock.json');
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(lock).mtimeMs) return;
  // npm passes its own path to the scripts that it runs.
  const npm = process.env.npm_execpath;
  await step(
    'npm packages',
    npm ? process.execPath : 'npm',
    [...(npm ? [npm] : []), 'ci', '--loglevel=error'],
    'npm could not install the packages: run `npm ci` to see why.',
  );
}
