#!/usr/bin/env node
/**
 * The command `c2warp` for machines without Rust: the same program as WebAssembly, with access to local files.
 *
 * It starts in about 0.2 s. `web/docs/cli.md` has its limits.
 */
import { readFile } from 'node:fs/promises';
import { parse, relative, sep } from 'node:path';

/** The exit status of a program that failed. */
const FAILED = 1;

const program = new URL(/* @vite-ignore */ './command.wasm', import.meta.url);

/** Node warns that its system interface may change. The warning is of no use at a terminal. */
function muteExperimentalWarnings(): void {
  const emitWarning = process.emitWarning.bind(process) as (...args: unknown[]) => void;
  process.emitWarning = (...args: unknown[]) => {
    if (args[1] !== 'ExperimentalWarning') emitWarning(...args);
  };
}

async function run(): Promise<number> {
  muteExperimentalWarnings();
  const { WASI } = await import('node:wasi');
  const folder = process.cwd();
  const { root } = parse(folder);
  const wasi = new WASI({
    version: 'preview1',
    args: ['c2warp', ...process.argv.slice(2)],
    // The program starts in the root folder, and changes to this one.
    env: { ...process.env, PWD: `/${relative(root, folder).split(sep).join('/')}` },
    preopens: { '/': root },
    returnOnExit: true,
  });
  const module = await WebAssembly.compile(await readFile(program));
  const instance = await WebAssembly.instantiate(module, wasi.getImportObject() as WebAssembly.Imports);
  return wasi.start(instance);
}

try {
  process.exitCode = await run();
} catch (error) {
  // Panics and want of memory end the program by an exit status: this is of another kind, such as an overflow.
  console.error(`c2warp: ${String(error)}`);
  process.exitCode = FAILED;
}
