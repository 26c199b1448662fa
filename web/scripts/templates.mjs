/**
 * `npm run test:templates [-- NAME …]`: packs the package, installs it beside Vue and Svelte in copies of
 * `tests/types/templates`, and checks the templates there by the frameworks' own compilers. They report errors in the
 * lines that end with `wrong`, and in no others.
 *
 * `--tarball FILE` tests a file that is packed already. It needs npm's registry.
 */
import { spawnSync } from 'node:child_process';
import { cp, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { install } from './packages/embedding.mjs';
import { builtPackage } from './packing.mjs';
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
    const tarball = values.tarball
      ? resolve(values.tarball)
      : (await builtPackage(join(work, 'package'))).tarball;
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
  await install(folder, tarball);
  const { c2warp } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  const { stdout, stderr } = spawnSync(`npx ${c2warp.check}`, { cwd: folder, shell: true, encoding: 'utf8' });
  const output = stdout + stderr;
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
      `${output}\nNot reported: ${missed.join(', ') || 'none'}. Reported wrongly: ${others.join(', ') || 'none'}.`,
    );
  console.log(`all ${expected.length} wrong lines are reported, and no others`);
}
