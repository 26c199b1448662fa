/**
 * `npm run test:start`: runs `npm start`, waits until the editor's page is served, and stops the server.
 *
 * Fails if the server exits first, or after 30 minutes. The first start compiles the solver.
 */
import { spawn } from 'node:child_process';
import { ROOT } from './steps.mjs';

const PATIENCE_MS = 30 * 60_000;

const child = spawn(process.execPath, ['web/scripts/start.mjs'], {
  cwd: ROOT,
  stdio: ['ignore', 'pipe', 'inherit'],
});
child.on('exit', (code) => end(`\`npm start\` exited with status ${code} before it served the editor.`));
setTimeout(() => end('`npm start` did not serve the editor in time.'), PATIENCE_MS).unref();

let output = '';
let asked = false;
child.stdout.on('data', (/** @type {Buffer} */ chunk) => {
  process.stdout.write(chunk);
  output += chunk;
  const address = /c2warp is at (http\S+)/.exec(output)?.[1];
  if (!address || asked) return;
  asked = true;
  void ask(address);
});

/** @param {string} address */
async function ask(address) {
  const response = await fetch(address).catch((error) => end(`${address}: ${error}`));
  const page = await response.text();
  end(
    response.ok && page.includes('<c2-warp')
      ? ''
      : `${address} answered with status ${response.status}: ${page.slice(0, 200)}`,
  );
}

/**
 * Ends both programs.
 * @param {string} failure empty after an answer
 * @returns {never}
 */
function end(failure) {
  if (failure) console.error(`✗ ${failure}`);
  child.removeAllListeners('exit');
  child.kill();
  process.exit(failure ? 1 : 0);
}
