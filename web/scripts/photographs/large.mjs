/// <reference lib="dom" />
/** The rocket at 12 megapixels: how long its fill and its export take. */
import { join } from 'node:path';
import { enlarged } from './enlarged.mjs';
import { Hand } from './hand.mjs';

const SIZE = /** @type {const} */ ([4240, 2830]);
/** After so long without a change of progress, nothing is under way. */
const CALM_MS = 3000;

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @param {string} pictures The folder of pictures.
 * @returns {Promise<string>} The times in words.
 */
export async function large(browser, address, pictures) {
  const file = join(pictures, 'rocket.jpg');
  const buffer = await enlarged(browser, address, file, SIZE);
  const hand = await Hand.open(browser, address, { name: 'rocket.jpg', mimeType: 'image/jpeg', buffer });
  const scale = SIZE[0] / 640;
  const [x, y] = [322 * scale, 122 * scale];
  const [left, right, bottom] = [308 * scale, 337 * scale, 404 * scale];
  await hand.lasso(
    [
      [x, y],
      [left, y + 24 * scale],
      [left, bottom],
      [right, bottom],
    ],
    { snap: false, close: false },
  );
  const calm = await calmTime(hand.page);
  await hand.key('Enter');
  const filled = await calm();
  const start = performance.now();
  await hand.export();
  const exported = performance.now() - start;
  await hand.close();
  const seconds = (/** @type {number} */ ms) => `${(ms / 1000).toFixed(1)} s`;
  return `${seconds(filled)}, and its export ${seconds(exported)}`;
}

/**
 * Watches the progress of the editor from now on. The result waits until it has been calm, and is the time up to its
 * last change in milliseconds. Progress may show for less than a frame of the driver.
 * @param {import('@playwright/test').Page} page
 */
async function calmTime(page) {
  const watch = await page.evaluateHandle((calm) => {
    const root = document.querySelector('c2-warp')?.shadowRoot;
    const start = performance.now();
    const label = () => root?.querySelector('[role=progressbar]')?.getAttribute('aria-label');
    let [shown, changed] = [label(), start];
    const observer = new MutationObserver(() => {
      if (label() !== shown) [shown, changed] = [label(), performance.now()];
    });
    if (root) observer.observe(root, { subtree: true, childList: true, attributes: true });
    return {
      async ended() {
        while (shown !== undefined || performance.now() - changed < calm)
          await new Promise((done) => setTimeout(done, calm / 10));
        observer.disconnect();
        return changed - start;
      },
    };
  }, CALM_MS);
  return () => watch.evaluate((watch) => watch.ended());
}
