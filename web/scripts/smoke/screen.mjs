/** A screen for browsers that need one: the user's screen, or a virtual one by Xvfb. */
import { spawn } from 'node:child_process';
import { once } from 'node:events';

/**
 * @returns {Promise<{ display: string, close: () => void } | null>} Null if there is none.
 */
export async function openScreen() {
  const display = process.env.DISPLAY;
  if (display) return { display, close: () => {} };
  // It chooses a free number, and writes it to its standard output.
  const server = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', '1280x900x24'], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const failed = once(server, 'error').then(() => null);
  const started = once(server.stdout, 'data').then(([line]) => `:${String(line).trim()}`);
  const found = await Promise.race([started, failed]);
  return found === null ? null : { display: found, close: () => server.kill() };
}
