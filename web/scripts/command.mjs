/** The command line as WebAssembly, for machines without Rust. */
import { join } from 'node:path';
import { prepareTarget } from './prepare.mjs';
import { ROOT, step } from './steps.mjs';

const TARGET = 'wasm32-wasip1';
/** A profile of Cargo.toml. */
const PROFILE = 'portable';

/** Builds the program. Returns its path. */
export async function buildCommand() {
  await prepareTarget(TARGET);
  await step(
    'Command (Rust → WebAssembly)',
    'cargo',
    ['build', '--package', 'c2warp-cli', '--target', TARGET, '--profile', PROFILE],
    'The command does not build. The reason is above.',
  );
  return join(ROOT, process.env.CARGO_TARGET_DIR ?? 'target', TARGET, PROFILE, 'c2warp.wasm');
}
