/** Runs the command `c2warp` of this workspace. */
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** Builds the command, and returns the path of its binary. */
export function builtCommand(): string {
  const args = ['build', '--quiet', '--package', 'c2warp-cli', '--message-format', 'json'];
  const { stdout, stderr } = spawnSync('cargo', args, { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 28 });
  const messages = stdout.split('\n').filter((line) => line.startsWith('{'));
  const { executable } = messages.map((line) => JSON.parse(line)).find((message) => message.executable) ?? {};
  if (!executable) throw new Error(`The command was not built: ${stderr}`);
  return executable;
}
