/** The packages of a release: the npm package and the crates. They are packed and checked as users would get them. */
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { sizesOf } from './budgets.mjs';
import { repositoryOf, withAbsoluteLinks } from './release_notes.mjs';
import { heading, printed, ROOT, run, StepError, step, toolPath } from './steps.mjs';

/** The crates for users, each after those that it depends on. */
export const CRATES = [
  'c2warp',
  'c2warp-export',
  'c2warp-film',
  'c2warp-maps',
  'c2warp-vector',
  'c2warp-cli',
];

export const OF_CRATES = CRATES.flatMap((crate) => ['--package', crate]);

/** npm passes its own path to the scripts that it runs. */
const NPM = process.env.npm_execpath
  ? /** @type {const} */ ([process.execPath, process.env.npm_execpath])
  : /** @type {const} */ (['npm']);

/**
 * Builds and packs the package of npm.
 * @param {string} folder For the tarball. It is emptied first.
 * @returns {Promise<{ tarball: string, warnings: string[] }>}
 */
export async function builtPackage(folder) {
  await step(
    'Build of the package',
    process.execPath,
    ['web/scripts/build.mjs'],
    'It does not build. The reason is above.',
  );
  heading('Package of npm');
  const made = packed(folder);
  console.log(made.tarball);
  return made;
}

/**
 * Builds, packs and checks the package of npm.
 * @param {string} folder For the tarball.
 * @returns {Promise<{ tarball: string, warnings: string[] }>}
 */
export async function npmPackage(folder) {
  const { tarball, warnings } = await builtPackage(folder);
  await step(
    'Types for users and their frameworks',
    process.execPath,
    [toolPath('tsc'), '--project', 'tests/types/tsconfig.json'],
    'Programs of users do not compile. The reason is above.',
  );
  await lint('publint', [toolPath('publint'), 'run', tarball, '--strict']);
  // Node reads ES modules only, and every later resolver knows "exports".
  await lint('Types of the package (attw)', [
    toolPath('attw'),
    tarball,
    '--profile',
    'esm-only',
    '--no-emoji',
  ]);
  await checkSizes();
  return { tarball, warnings };
}

/**
 * @param {string} title
 * @param {string[]} args
 */
async function lint(title, args) {
  heading(title);
  const { code } = await run(process.execPath, args);
  if (code !== 0) throw new StepError(`${title}: the package has an error. It is named above.`);
}

/** @param {string} folder */
function packed(folder) {
  const manifest = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
  const [program, ...first] = NPM;
  const listed = printed(program, [...first, 'pack', '--dry-run', '--json', '--ignore-scripts']);
  if (listed === undefined) throw new StepError('npm cannot pack the package: run `npm pack --dry-run`.');
  const stage = join(folder, 'staged');
  rmSync(folder, { recursive: true, force: true });
  for (const { path } of JSON.parse(listed)[0].files) {
    mkdirSync(dirname(join(stage, path)), { recursive: true });
    cpSync(join(ROOT, path), join(stage, path));
  }
  const warnings = [];
  const repository = repositoryOf(manifest);
  if (repository) {
    const readme = readFileSync(join(ROOT, 'README.md'), 'utf8');
    writeFileSync(join(stage, 'README.md'), withAbsoluteLinks(readme, repository, manifest.version));
  } else {
    warnings.push('package.json has no "repository": links of the packed README lead nowhere');
  }
  if (!printed(program, [...first, 'pack', stage, '--ignore-scripts', '--pack-destination', folder]))
    throw new StepError('npm cannot pack the package: run `npm pack`.');
  rmSync(stage, { recursive: true });
  return { tarball: join(folder, `${manifest.name}-${manifest.version}.tgz`), warnings };
}

/** Prints the downloads that the build makes, and compares them with their budgets. */
async function checkSizes() {
  heading('Downloads, by brotli');
  const sizes = await sizesOf((path) => readFile(join(ROOT, 'web/dist', path)));
  for (const { name, size, most } of sizes)
    console.log(`${size.toFixed(1).padStart(6)} kB of ${String(most).padStart(3)}  ${name}`);
  const over = sizes.filter(({ size, most }) => size > most).map(({ name }) => name);
  if (over.length > 0)
    throw new StepError(`Over the budgets of web/scripts/budgets.mjs: ${over.join(', ')}.`);
}

/**
 * Packs the crates, compiles each from its package, and copies the packages into a folder.
 * @param {string} folder
 */
export async function crates(folder) {
  await step(
    'Crates, packed and compiled',
    'cargo',
    ['package', ...OF_CRATES],
    'A crate does not compile from its package. The reason is above.',
  );
  const built = join(ROOT, process.env.CARGO_TARGET_DIR ?? 'target', 'package');
  mkdirSync(folder, { recursive: true });
  for (const name of readdirSync(built).filter((name) => name.endsWith('.crate')))
    cpSync(join(built, name), join(folder, name));
}
