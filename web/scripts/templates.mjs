/**
 * `npm run test:templates [-- NAME …]`: packs the package, installs it beside Vue and Svelte in copies of
 * `tests/types/templates`, and checks the templates there by the frameworks' own compilers. They report errors in the
 * lines that end with `wrong`, and in no others.
 *
 * `--tarball FILE` tests a file that is packed already. It needs npm's registry.
 */
import { spawnSync } from 'node:child_process';
import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { packed } from './packages/packed.mjs';
import { heading, main, ROOT, StepError } from './steps.mjs';

const TEMPLATES = join(ROOT, 'tests/types/templates');
/** `Page.vue(20,3): error`, or `ERROR "Page.svelte" 20:3` of svelte-check. */
const FAULT = /^(?:\d+ )?(?:ERROR "([\w.]+)" (\d+):|([\w.]+)\((\d+),\d+\): error)/gm;

await main(async () => {
  const { values, positionals } = parseArgs({
    options: { tarball: { type: 'string' } },
    allowPositionals: true,
  });
  const work = await mkdtemp(join(tmpdir(), 'c2warp-templates-'));
  try {
    const tarball = values.tarball ? resolve(values.tarball) : await packed(work);
    for (const name of positionals.length > 0 ? positionals : await readdir(TEMPLATES)) {
      heading(`Templates of ${name}`);
      await check(name, join(work, name), tarball);
    }
  } finally {
    await rm(work, { recursive: true, force: true });
  }
});

/**
 * @param {string} name
 * @param {string} folder
 * @param {string} tarball
 */
async function check(name, folder, tarball) {
  await cp(join(TEMPLATES, name), folder, { recursive: true });
  const file = join(folder, 'package.json');
  const { dependencies, c2warp, ...rest } = JSON.parse(await readFile(file, 'utf8'));
  await writeFile(
    file,
    JSON.stringify({ ...rest, dependencies: { ...dependencies, c2warp: `file:${tarball}` } }),
  );
  const installed = shell('npm install --no-audit --no-fund --loglevel=error', folder);
  if (installed.status !== 0) throw new StepError(`npm cannot install: ${installed.output}`);
  const { output } = shell(`npx ${c2warp.check}`, folder);
  const found = [...output.matchAll(FAULT)].map(([, a, b, c, d]) => `${a ?? c}:${b ?? d}`);
  /** @type {string[]} */
  const expected = [];
  for (const page of await readdir(folder)) {
    if (!page.startsWith('Page.')) continue;
    const lines = (await readFile(join(folder, page), 'utf8')).split('\n');
    expected.push(
      ...lines.flatMap((line, at) => (line.endsWith('<!-- wrong -->') ? `${page}:${at + 1}` : [])),
    );
  }
  const missed = expected.filter((place) => !found.includes(place));
  const others = found.filter((place) => !expected.includes(place));
  if (expected.length === 0 || missed.length > 0 || others.length > 0)
    throw new StepError(
      `${output}\nNot reported: ${missed.join(', ') || 'none'}. Wrongly: ${others.join(', ') || 'none'}.`,
    );
  console.log(`${expected.length} wrong lines are reported, and no others`);
}

/** @param {string} command @param {string} cwd */
function shell(command, cwd) {
  const { status, stdout, stderr } = spawnSync(command, { cwd, shell: true, encoding: 'utf8' });
  return { status, output: stdout + stderr };
}
