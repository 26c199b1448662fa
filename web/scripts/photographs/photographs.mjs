/**
 * `npm run quality -- photographs`: edits ten photographs in the browser, and compares fills with OpenCV's.
 *
 * Writes a sheet before and after each edit, an overview, and blind sheets of fills with their key. Prints the seam
 * at rest and the times.
 */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { prepareChromium } from '../chromium.mjs';
import { withServedEditor } from '../served_editor.mjs';
import { heading, ROOT, step } from '../steps.mjs';
import { EDITS } from './edits.mjs';
import { Hand } from './hand.mjs';
import { large } from './large.mjs';
import { movingFrame, restingFrame, seam } from './measure.mjs';
import { opencvPython } from './opencv.mjs';
import { sheet } from './sheets.mjs';
import { strokes } from './strokes.mjs';

const PICTURES = join(ROOT, 'tests/quality/photographs/pictures');

/** @param {string} output A folder, relative to the root. */
export async function photographs(output) {
  const folder = join(ROOT, output, 'photographs');
  mkdirSync(folder, { recursive: true });
  await prepareChromium();
  heading('Photographs');
  await withServedEditor((browser, address) => edits(browser, address, folder));
  const files = readdirSync(PICTURES).map((name) => join(PICTURES, name));
  const args = [
    '--release',
    '--package',
    'c2warp-quality',
    '--',
    '--fill',
    folder,
    await opencvPython(),
    ...files,
  ];
  await step('Fills', 'cargo', ['run', '--quiet', ...args], 'The fills failed. The reason is above.');
}

/** Only the strokes of the brush. */
export async function brush() {
  await prepareChromium();
  heading('Brush');
  await withServedEditor(printStrokes);
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 */
async function printStrokes(browser, address) {
  console.log(`\nStrokes of the brush at 12 megapixels:\n\n${await strokes(browser, address, PICTURES)}`);
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @param {string} folder
 */
async function edits(browser, address, folder) {
  console.log('| edit | seam, levels | frame at rest, ms | frame moving, ms |\n|---|---:|---:|---:|');
  for (const { name, picture, grip, choose, edit } of EDITS) {
    const file = join(PICTURES, `${picture}.jpg`);
    const hand = await Hand.open(browser, address, file);
    await choose(hand);
    const [before, rest] = [readFileSync(file), await hand.export()];
    const resting = await restingFrame(hand.page);
    const moving = await movingFrame(hand, grip);
    await hand.idle();
    await edit(hand);
    const after = await hand.export();
    const numbers = [await seam(hand.page, before, rest), resting.toFixed(0), moving.toFixed(0)];
    console.log(`| ${name} | ${numbers.join(' | ')} |`);
    writeFileSync(join(folder, `${picture}.jpg`), await sheet(hand.page, [before, after]));
    writeFileSync(join(folder, `${picture}-after.png`), after);
    await hand.close();
  }
  console.log(`\nA lasso with fill at 12 megapixels: ${await large(browser, address, PICTURES)}`);
  await printStrokes(browser, address);
}
