/** `npm start [-- --port N]`: prepares the machine, builds the solver, serves the editor and prints its address. */
import { createServer } from 'node:net';
import { parseArgs } from 'node:util';
import { prepare } from './prepare.mjs';
import { heading, main, ROOT, StepError } from './steps.mjs';

const DEFAULT_PORT = 5173;

await main(async () => {
  const wanted = requestedPort();
  if (wanted !== undefined && !(await free(wanted))) {
    throw new StepError(`Port ${wanted} is taken: choose another with \`npm start -- --port N\`.`);
  }
  await prepare();
  heading('Editor');
  // As in a build. In development mode, Lit prints a warning.
  process.env.NODE_ENV ??= 'production';
  // Imported only here: it may have just been installed.
  const { createServer: createVite } = await import('vite');
  const server = await createVite({
    configFile: `${ROOT}/web/vite.config.ts`,
    server: { port: wanted ?? DEFAULT_PORT, strictPort: wanted !== undefined },
    clearScreen: false,
  });
  await server.listen();
  console.log(`\n  c2warp is at ${server.resolvedUrls?.local[0]}   (Ctrl-C ends it)\n`);
});

/** @returns {number | undefined} */
function requestedPort() {
  let text;
  try {
    text = parseArgs({ options: { port: { type: 'string' } } }).values.port;
  } catch (error) {
    throw new StepError(`${error instanceof Error ? error.message : error}. Usage: npm start [-- --port N]`);
  }
  if (text === undefined) return undefined;
  const port = Number(text);
  if (!Number.isInteger(port) || port < 1 || port > 65_535) {
    throw new StepError(`--port: expected a number from 1 to 65535, found "${text}".`);
  }
  return port;
}

/**
 * @param {number} port
 * @returns {Promise<boolean>}
 */
function free(port) {
  return new Promise((resolve) => {
    const probe = createServer();
    probe.once('error', () => resolve(false));
    probe.listen(port, 'localhost', () => probe.close(() => resolve(true)));
  });
}
