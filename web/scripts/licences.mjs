/**
 * Collects the licences of a build: of the npm packages bundled in the page and in its workers, and of the crates
 * linked into the WebAssembly modules. These licences require that their text accompanies every copy.
 */
import { execFile } from 'node:child_process';
import { readdir, readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from './steps.mjs';

/**
 * @typedef {object} Package
 * @property {string} name
 * @property {string} version
 * @property {string} license by its SPDX expression
 * @property {string} folder
 * @property {string | null} [source] the address of its source
 * @property {string[]} [authors]
 */
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
  const chapters = await Promise.all(packages.map((one) => chapter(one, packages)));
  const own = await readFile(join(ROOT, 'LICENSE-MIT'), 'utf8');
  return [
    `# c2warp\n\n${own.trim()}\n`,
    'c2warp also includes the following, and the standard library of Rust (MIT or Apache-2.0).\n',
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
  if (linked.length === 0) return [];
  // Only the tree has the features that these modules use: the metadata has those of the whole workspace.
  const parts = linked.flatMap((module) => ['--package', module]);
  const kinds = ['--edges', 'normal,no-proc-macro', '--target', TARGET];
  const [tree, metadata] = await Promise.all([
    cargo(['tree', ...parts, ...kinds, '--prefix', 'none', '--format', '{p}']),
    cargo(['metadata', '--format-version', '1', '--filter-platform', TARGET]),
  ]);
  const reached = new Set(tree.split('\n').map((line) => line.split(' ', 2).join(' ')));
  /** @type {{ packages: (Package & { manifest_path: string, repository: string | null })[] }} */
  const { packages } = JSON.parse(metadata);
  return packages
    .filter(({ name, version, source }) => source !== null && reached.has(`${name} v${version}`))
    .map(({ name, version, license, authors = [], manifest_path, repository }) => {
      return { name, version, license, authors, folder: dirname(manifest_path), source: repository };
    });
}

/**
 * What a command of Cargo prints.
 * @param {string[]} args
 */
async function cargo(args) {
  const options = { cwd: ROOT, maxBuffer: 64e6 };
  const { stdout } = await promisify(execFile)(process.env.CARGO ?? 'cargo', [...args, '--locked'], options);
  return stdout;
}

/**
 * @param {Package} one
 * @param {readonly Package[]} all
 */
async function chapter(one, all) {
  const { name, version, license, source } = one;
  const texts = await licenceTexts(one, all);
  // This licence asks for the place of the source.
  const place = license.startsWith('MPL') && source ? [`Its source is at ${source}.\n`] : [];
  const title = `## ${name} ${version} (${license})\n`;
  return [title, ...place, ...texts.map((text) => `${text.trim()}\n`)].join('\n');
}

/**
 * @param {Package} one
 * @param {readonly Package[]} all
 */
async function licenceTexts({ name, license, folder, authors }, all) {
  const files = await licenceFiles(folder);
  // One of several alternatives suffices.
  const mit = files.find((file) => /mit/i.test(file));
  const chosen = mit && /\bMIT\b/.test(license) ? [mit] : files;
  if (chosen.length > 0) {
    return Promise.all(chosen.map((file) => readFile(join(folder, file), 'utf8')));
  }
  // This text does not name holders, so the text of another package is the same.
  for (const other of license === 'MPL-2.0' ? all.filter((other) => other.license === license) : []) {
    const [file] = await licenceFiles(other.folder);
    if (file) return [await readFile(join(other.folder, file), 'utf8')];
  }
  if (!/\bMIT\b/.test(license)) throw new Error(`${name} (${license}) comes without the text of its licence`);
  // Some crates give only the name of the licence. Its text is the same for all but the holders.
  const holders = authors?.length ? authors.join(', ') : `the authors of ${name}`;
  const own = await readFile(join(ROOT, 'LICENSE-MIT'), 'utf8');
  return [own.replace(/^Copyright .*$/m, () => `Copyright (c) ${holders}`)];
}

const licenceFiles = async (/** @type {string} */ folder) =>
  (await readdir(folder)).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file)).sort();
