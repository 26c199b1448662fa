/** Runs the command `c2warp` of this workspace. */
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** Builds the command as the native tests do, and returns the path of its binary. */
export const builtCommand = (): string => built('--workspace', '--bin', 'c2warp');

/** Builds the program that solves lines of projects, as the native tests do, and returns the path of its binary. */
export const builtSolutions = (): string => built('--workspace', '--bin', 'c2warp-solutions');

/** Builds the command of the package, and returns the path of its WebAssembly file. */
export const builtWasmCommand = (): string =>
  built('--package', 'c2warp-cli', '--target', 'wasm32-wasip1', '--profile', 'portable');

function built(...options: readonly string[]): string {
  const args = ['build', '--quiet', '--message-format', 'json', ...options];
  const { stdout, stderr } = spawnSync('cargo', args, { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 28 });
  const messages = stdout.split('\n').filter((line) => line.startsWith('{'));
  const { executable } = messages.map((line) => JSON.parse(line)).find((message) => message.executable) ?? {};
  if (!executable) throw new Error(`The command was not built: ${stderr}`);
  return executable;
}
