/**
 * The licences of a build's parts: the npm packages bundled in the page and in its workers, and the crates linked into
 * the WebAssembly modules. They require that their text accompanies every copy.
 */
import { execFile } from 'node:child_process';
import { readdir, readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from './steps.mjs';

/** @typedef {{ name: string, version: string, license: string, folder: string, source?: string }} Package */
/** @typedef {import('vite').Plugin} Plugin */

const FILE = 'LICENSES.md';
const MODULES = ['c2warp-bind', 'c2warp-film-bind', 'c2warp-export-bind'];
const TARGET = 'wasm32-unknown-unknown';

/**
 * Plugins for a build and for its workers. They write `LICENSES.md` beside the files.
 * @param {string[]} [crates] those of the WebAssembly modules
 * @returns {{ plugins: Plugin[], worker: () => Plugin[] }}
 */
export function licences(crates = MODULES) {
  /** @type {Set<string>} */
  const folders = new Set();
  /** @type {Plugin} */
  const collector = {
    name: 'c2warp:bundled-packages',
    renderChunk(_, { moduleIds }) {
      for (const id of moduleIds) {
        const folder = folderOf(id);
        if (folder) folders.add(folder);
      }
      return null;
    },
  };
  /** @type {Plugin} */
  const writer = {
    name: 'c2warp:licences',
    async generateBundle() {
      const source = await licencesOf([...folders], crates);
      this.emitFile({ type: 'asset', fileName: FILE, source });
    },
  };
  return { plugins: [collector, writer], worker: () => [collector] };
}

/**
 * The text of `LICENSES.md`.
 * @param {string[]} folders those of the bundled npm packages
 * @param {string[]} [linked] the crates of the WebAssembly modules
 */
export async function licencesOf(folders, linked = MODULES) {
  const bundled = await Promise.all(folders.map(npmPackage));
  const packages = [...bundled, ...(await crates(linked))].sort((a, b) => (a.name < b.name ? -1 : 1));
  const chapters = await Promise.all(packages.map(chapter));
  const own = await readFile(join(ROOT, 'LICENSE-MIT'), 'utf8');
  return [
    `# c2warp\n\n${own.trim()}\n`,
    'c2warp also holds the following, and the standard library of Rust (MIT or Apache-2.0).\n',
    ...chapters,
  ].join('\n');
}

/** The folder of the npm package that a module belongs to; undefined for c2warp's own. */
const folderOf = (/** @type {string} */ module) =>
  /^\0?(.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+)[\\/]/.exec(module)?.[1];

/**
 * @param {string} folder
 * @returns {Promise<Package>}
 */
async function npmPackage(folder) {
  const { name, version, license, repository } = JSON.parse(
    await readFile(join(folder, 'package.json'), 'utf8'),
  );
  return { name, version, license, folder, source: repository?.url };
}

/**
 * The crates linked into the modules, without those that only run while it is built.
 * @param {string[]} linked
 * @returns {Promise<Package[]>}
 */
async function crates(linked) {
  const { stdout } = await promisify(execFile)(
    process.env.CARGO ?? 'cargo',
    ['metadata', '--format-version', '1', '--locked', '--filter-platform', TARGET],
    { cwd: ROOT, maxBuffer: 64e6 },
  );
  const { packages, resolve } = JSON.parse(stdout);
  const byId = new Map(packages.map((/** @type {{ id: string }} */ one) => [one.id, one]));
  const nodes = new Map(resolve.nodes.map((/** @type {{ id: string }} */ node) => [node.id, node]));
  const modules = packages.filter((/** @type {Package} */ { name }) => linked.includes(name));
  const reached = new Set(modules.map((/** @type {{ id: string }} */ { id }) => id));
  for (const id of reached) {
    for (const { pkg, dep_kinds } of nodes.get(id).deps) {
      const isLinked = dep_kinds.some((/** @type {{ kind: string | null }} */ { kind }) => kind === null);
      const isMacro = byId
        .get(pkg)
        .targets.some((/** @type {{ kind: string[] }} */ { kind }) => kind.includes('proc-macro'));
      if (isLinked && !isMacro) reached.add(pkg);
    }
  }
  return [...reached]
    .map((id) => byId.get(id))
    .filter(({ source }) => source !== null)
    .map(({ name, version, license, manifest_path }) => ({
      name,
      version,
      license,
      folder: dirname(manifest_path),
    }));
}

/** @param {Package} one */
async function chapter({ name, version, license, folder, source }) {
  const files = (await readdir(folder)).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file)).sort();
  // One of several alternatives suffices.
  const mit = files.find((file) => /mit/i.test(file));
  const chosen = mit && /\bMIT\b/.test(license) ? [mit] : files;
  const texts = await Promise.all(chosen.map((file) => readFile(join(folder, file), 'utf8')));
  // This licence asks for the place of the source.
  const place = license.startsWith('MPL') && source ? [`Its source is at ${source}.\n`] : [];
  const title = `## ${name} ${version} (${license})\n`;
  return [title, ...place, ...texts.map((text) => `${text.trim()}\n`)].join('\n');
}
