/** One folder of `web/examples`, installed with the packed package, built and served as its `package.json` says. */
import { spawn } from 'node:child_process';
import { cp, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { delimiter, join } from 'node:path';
import { ROOT, StepError } from '../steps.mjs';
import { forwardingServer, staticServer } from './counting_server.mjs';

/**
 * A way to build an example.
 *
 * @typedef {object} Embedding
 * @property {string} title
 * @property {string} [build] A command.
 * @property {string} [serve] The folder of static files that the build writes.
 * @property {string} [start] A command that serves instead, at the port `{port}`.
 * @property {Record<string, string>} [with] Versions of packages instead of those in `package.json`.
 */

/**
 * @typedef {object} Example
 * @property {string} folder
 * @property {string} pictures The folder for the samples.
 * @property {string[]} [samples] Their names.
 * @property {import('./first_interaction.mjs').Interaction} [interaction] The interaction that bends the picture.
 * @property {string} [handle] The handle that is dragged.
 * @property {Embedding[]} embeddings
 */

const EXAMPLES = join(ROOT, 'web/examples');
const SAMPLES = join(ROOT, 'web/public/samples');
const SAMPLE = 'gingerbread';
const STARTS_MS = 60_000;
const POLL_MS = 100;

/** Names of all examples. */
export const exampleNames = async () =>
  (await readdir(EXAMPLES, { withFileTypes: true }))
    .filter((one) => one.isDirectory())
    .map(({ name }) => name);

/** @param {string} name @returns {Promise<Example>} */
export async function readExample(name) {
  const folder = join(EXAMPLES, name);
  const { c2warp } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  return { folder, ...c2warp };
}

/**
 * The lines of an example that a person writes: all but those of `package.json`, and empty ones.
 * @param {string} folder
 */
export async function linesOf(folder) {
  let lines = 0;
  for (const entry of await readdir(folder, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile() || entry.name === 'package.json') continue;
    const text = await readFile(join(entry.parentPath ?? entry.path, entry.name), 'utf8');
    lines += text.split('\n').filter((line) => line.trim() !== '').length;
  }
  return lines;
}

/**
 * Copies an example to another folder, with a picture, and installs it with the package.
 * @param {Example} example
 * @param {Embedding} embedding
 * @param {string} folder
 * @param {string} tarball
 */
export async function installed(example, embedding, folder, tarball) {
  await cp(example.folder, folder, { recursive: true });
  await mkdir(join(folder, example.pictures), { recursive: true });
  const files = (example.samples ?? [SAMPLE]).flatMap((name) => [`${name}.png`, `${name}.c2warp.json`]);
  for (const file of files) await cp(join(SAMPLES, file), join(folder, example.pictures, file));
  await install(folder, tarball, embedding.with);
}

/**
 * Installs the packed package beside the dependencies of a folder's `package.json`.
 * @param {string} folder
 * @param {string} tarball
 * @param {Record<string, string>} [versions] In place of those in the file.
 */
export async function install(folder, tarball, versions = {}) {
  const file = join(folder, 'package.json');
  const given = JSON.parse(await readFile(file, 'utf8'));
  const dependencies = { ...given.dependencies, ...versions, c2warp: `file:${tarball}` };
  await writeFile(file, JSON.stringify({ ...given, dependencies }));
  await command('npm install --no-audit --no-fund --loglevel=error', folder);
}

/** @param {Embedding} embedding @param {string} folder */
export async function built({ build }, folder) {
  if (build) await command(build, folder);
}

/**
 * Serves a built example.
 * @param {Embedding} embedding
 * @param {string} folder
 */
export async function served({ serve, start }, folder) {
  if (serve !== undefined) return staticServer(join(folder, serve));
  if (start === undefined) throw new Error('package.json names neither a folder to serve nor a command');
  const port = await freePort();
  const process = started(start.replace('{port}', String(port)), folder);
  try {
    await answering(port);
    const server = await forwardingServer(port);
    return {
      ...server,
      close: () => {
        server.close();
        process.stop();
      },
    };
  } catch (error) {
    process.stop();
    throw new Error(`${/** @type {Error} */ (error).message}\n${process.output()}`);
  }
}

/** Runs a command of an example. @param {string} line @param {string} folder */
async function command(line, folder) {
  const { ended, output } = started(line, folder);
  if ((await ended) !== 0) throw new StepError(`${line} failed:\n${output()}`);
}

/** @param {string} line @param {string} folder */
function started(line, folder) {
  const isWindows = process.platform === 'win32';
  const child = spawn(line, {
    cwd: folder,
    shell: true,
    // A separate group, so that it ends with the processes that it starts.
    detached: !isWindows,
    env: {
      ...process.env,
      PATH: [join(folder, 'node_modules/.bin'), process.env.PATH].join(delimiter),
      CI: '1',
      NEXT_TELEMETRY_DISABLED: '1',
      ASTRO_TELEMETRY_DISABLED: '1',
      NUXT_TELEMETRY_DISABLED: '1',
    },
  });
  let text = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (part) => (text += part));
  /** @type {Promise<number | null>} */
  const ended = new Promise((resolve) => {
    child.on('close', resolve);
    child.on('error', () => resolve(null));
  });
  return {
    ended,
    output: () => text.slice(-2000),
    stop: () => {
      if (isWindows || child.pid === undefined) child.kill();
      else process.kill(-child.pid);
    },
  };
}

/** @returns {Promise<number>} */
const freePort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, 'localhost', () => {
      const address = server.address();
      server.close(() => resolve(typeof address === 'object' && address ? address.port : 0));
    });
  });

/** @param {number} port */
async function answering(port) {
  for (let waited = 0; waited < STARTS_MS; waited += POLL_MS) {
    const response = await fetch(`http://localhost:${port}/`).catch(() => null);
    if (response?.ok) return;
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
  throw new Error('the server does not answer');
}
