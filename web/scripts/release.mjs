/**
 * `npm run release -- VERSION`: builds everything that a release uploads, from a clean clone, and stops before the
 * upload.
 *
 * The clone, the packages and the notes are then in a temporary folder.
 */
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { CRATES } from './packing.mjs';
import { notesOf, otherVersions } from './release_notes.mjs';
import { main, printed, ROOT, StepError, step } from './steps.mjs';

await main(async () => {
  const [version = ''] = process.argv.slice(2);
  if (!/^\d+\.\d+\.\d+(-[\w.]+)?$/.test(version))
    throw new StepError('Name the version: npm run release -- 1.2.3');
  const { date, notes } = checked(version);

  const folder = mkdtempSync(join(tmpdir(), `c2warp-${version}-`));
  const source = join(folder, 'source');
  const packages = join(folder, 'packages');
  await step('Clone', 'git', ['clone', '--quiet', ROOT, source], 'git cannot clone this repository.');
  await step(
    'npm packages of the clone',
    'npm',
    ['ci', '--prefix', source, '--loglevel=error'],
    'npm could not install the packages: run `npm ci` to see why.',
  );
  await step('Checks', 'npm', ['test', '--prefix', source], 'A check fails. It is named above.');
  await step(
    'Packages',
    process.execPath,
    [join(source, 'web/scripts/release_packages.mjs'), packages],
    'A package cannot be built. The reason is above.',
  );
  writeFileSync(join(folder, 'notes.md'), `${notes}\n`);

  console.log(`\nEverything for ${version} is in ${folder}. Nothing is uploaded.`);
  if (!date) console.log(`! CHANGELOG.md has no date for ${version}`);
  console.log('To upload:\n');
  console.log(
    `  cargo publish --manifest-path ${source}/Cargo.toml ${CRATES.map((name) => `-p ${name}`).join(' ')}`,
  );
  console.log(`  npm publish ${packages}/c2warp-${version}.tgz`);
});

/**
 * Refuses a release whose files are not ready. Returns its notes.
 * @param {string} version
 */
function checked(version) {
  const text = (/** @type {string} */ file) => readFileSync(join(ROOT, file), 'utf8');
  const missing = otherVersions(version, {
    package: text('package.json'),
    lock: text('package-lock.json'),
    cargo: text('Cargo.toml'),
  });
  const changes = printed('git', ['status', '--porcelain']);
  if (changes === undefined) missing.push('git cannot read this repository');
  else if (changes !== '') missing.push(`files are not committed:\n${changes}`);
  const notes = notesOf(text('CHANGELOG.md'), version);
  if (!notes) missing.push(`CHANGELOG.md has no notes under "## [${version}]"`);
  if (missing.length > 0 || !notes)
    throw new StepError(`${version} is not ready:\n${missing.map((line) => `  - ${line}`).join('\n')}`);
  return notes;
}
