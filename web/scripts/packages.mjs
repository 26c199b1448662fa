/**
 * `npm run test:packages [-- NAME …]`: packs the package, installs the file in each folder of `web/examples`, and
 * builds and serves it there. It opens the page in Chromium, and drags, scrolls or slides. The table goes to
 * web/docs/element.md.
 *
 * `--tarball FILE` tests a file that is packed already. It needs npm's registry.
 */
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { launchChromium, prepareChromium } from './chromium.mjs';
import { built, exampleNames, installed, linesOf, readExample, served } from './packages/embedding.mjs';
import { secondsToFirstInteraction } from './packages/first_interaction.mjs';
import { builtPackage } from './packing.mjs';
import { heading, main } from './steps.mjs';

/** @typedef {import('./packages/embedding.mjs').Embedding} Embedding */
/** @typedef {import('./packages/embedding.mjs').Example} Example */

await main(async () => {
  const { values, positionals } = parseArgs({
    options: { tarball: { type: 'string' } },
    allowPositionals: true,
  });
  await prepareChromium();
  const work = await mkdtemp(join(tmpdir(), 'c2warp-packages-'));
  const browser = await launchChromium();
  const rows = [];
  try {
    const tarball = values.tarball
      ? resolve(values.tarball)
      : (await builtPackage(join(work, 'package'))).tarball;
    const names = positionals.length > 0 ? positionals : await exampleNames();
    for (const name of names) {
      const example = await readExample(name);
      for (const embedding of example.embeddings) {
        heading(embedding.title);
        rows.push(await row(example, embedding, join(work, String(rows.length)), tarball, browser));
      }
    }
  } finally {
    await browser.close();
    await rm(work, { recursive: true, force: true });
  }
  heading('Result');
  console.log('| embedding | lines | works | seconds to the first drag | kB |\n|---|---|---|---|---|');
  for (const { cells } of rows) console.log(`| ${cells.join(' | ')} |`);
  if (rows.some(({ works }) => !works)) process.exitCode = 1;
});

/**
 * @param {Example} example
 * @param {Embedding} embedding
 * @param {string} folder
 * @param {string} tarball
 * @param {import('@playwright/test').Browser} browser
 */
async function row(example, embedding, folder, tarball, browser) {
  const lines = await linesOf(example.folder);
  try {
    await installed(example, embedding, folder, tarball);
    await built(embedding, folder);
    const server = await served(embedding, folder);
    const page = await browser.newPage({ viewport: { width: 900, height: 700 }, reducedMotion: 'reduce' });
    try {
      const seconds = await secondsToFirstInteraction(page, server.address, example);
      const kilobytes = Math.round(server.bytes() / 1000);
      console.log(`works: ${seconds.toFixed(1)} s, ${kilobytes} kB`);
      return { works: true, cells: [embedding.title, lines, 'yes', seconds.toFixed(1), kilobytes] };
    } finally {
      await page.close();
      server.close();
    }
  } catch (error) {
    console.log(/** @type {Error} */ (error).message);
    return { works: false, cells: [embedding.title, lines, 'no', '', ''] };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}
