/**
 * `npm run screenshots`: takes the pictures of the documentation. They show the editor with the bent sample, its lens,
 * the timeline, every sample posed, and one pose by each method that `npm run quality` compares.
 */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { prepareChromium } from './chromium.mjs';
import { drawFigures } from './figures.mjs';
import { prepare } from './prepare.mjs';
import { withServedEditor } from './served_editor.mjs';
import { heading, main, ROOT, step } from './steps.mjs';

const FOLDER = join(ROOT, 'web/screenshots');

/** How the sample is bent: moves of handles from their rest positions, in whole steps on screen. */
const PULLS = /** @type {const} */ ([
  ['left hand', 30, -90],
  ['right hand', 0, 50],
  ['right foot', 20, -16],
]);

await main(async () => {
  await prepare();
  await prepareChromium();
  heading('Screenshots');
  mkdirSync(FOLDER, { recursive: true });
  await withServedEditor(async (browser, address) => {
    await take(browser, address, 'light');
    await take(browser, address, 'dark');
    await drawFigures(browser);
  });
  const drawing = ['--package', 'c2warp-quality', '--', '--overview', join(FOLDER, 'methods.png')];
  await step(
    'Methods',
    'cargo',
    ['run', '--quiet', '--release', ...drawing],
    'The methods were not drawn. The reason is above.',
  );
});

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {'light' | 'dark'} colorScheme
 */
async function take(browser, url, colorScheme) {
  const page = await browser.newPage({
    viewport: { width: 1200, height: 800 },
    deviceScaleFactor: 1.5,
    colorScheme,
  });
  await page.goto(url);
  await page.getByText(/[0-9] mesh points/).waitFor();
  for (const [name, x, y] of PULLS) {
    const handle = page.getByRole('button', { name: `Handle ${name}` });
    const box = await handle.boundingBox();
    if (!box) throw new Error(`the handle ${name} is not on screen`);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + x, box.y + box.height / 2 + y, { steps: 5 });
    await page.mouse.up();
  }
  // Two frames: one to pose, one to draw.
  await page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
  const path = join(FOLDER, `editor-${colorScheme}.png`);
  await page.screenshot({ path });
  console.log(path);
  if (colorScheme === 'light') {
    await takeLens(page);
    await takeTimeline(page);
  }
  await page.close();
}

/**
 * The lens between the raised arm and the belly.
 *
 * @param {import('@playwright/test').Page} page
 */
async function takeLens(page) {
  await page.keyboard.press('Escape');
  await page.keyboard.press('i');
  await page.getByRole('region', { name: 'Lens' }).waitFor();
  const head = await page.getByRole('button', { name: 'Handle head' }).boundingBox();
  if (!head) throw new Error('the handle head is not on screen');
  await page.mouse.click(head.x - 70, head.y + 150);
  await page.getByRole('region', { name: 'Weights' }).getByText('Helper points', { exact: true }).waitFor();
  const path = join(FOLDER, 'lens.png');
  await page.screenshot({ path });
  console.log(path);
}

/**
 * The wave of the sample, between two of its keys.
 *
 * @param {import('@playwright/test').Page} page
 */
async function takeTimeline(page) {
  await page.keyboard.press('Escape');
  await page.keyboard.press('t');
  const timeline = page.getByRole('region', { name: 'Timeline' });
  await timeline.getByRole('button', { name: /^Onion/ }).click();
  await timeline.getByRole('button', { name: /^right hand, key at 0.30/ }).click();
  await timeline.getByRole('slider', { name: 'Playhead' }).focus();
  for (let frame = 0; frame < 2; frame++) await page.keyboard.press('ArrowRight');
  await page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
  const path = join(FOLDER, 'timeline.png');
  await page.screenshot({ path });
  console.log(path);
}
