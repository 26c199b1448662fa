/** Strokes of the brush at 12 megapixels: script time per move, and the time until the next frame. */
import { join } from 'node:path';
import { enlarged } from './enlarged.mjs';
import { Hand } from './hand.mjs';
import { quantile, scriptTimes } from './trace.mjs';

const SIZE = /** @type {const} */ ([4000, 3000]);
/** Handles that the brush finds. */
const HANDLES = /** @type {const} */ ([
  [700, 700],
  [3300, 700],
  [700, 2300],
  [3300, 2300],
]);
/** Diameters of the brush in percent of the longer side: the default one and the largest. */
const BRUSHES = [12, 60];
/** Moves of a stroke, which goes twice around the middle of the picture. */
const MOVES = 60;
const WAY = 150;

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @param {string} pictures The folder of pictures.
 * @returns {Promise<string>} A table.
 */
export async function strokes(browser, address, pictures) {
  const buffer = await enlarged(browser, address, join(pictures, 'rocket.jpg'), SIZE);
  const rows = [];
  for (const size of BRUSHES) {
    const hand = await Hand.open(browser, address, { name: 'rocket.jpg', mimeType: 'image/jpeg', buffer });
    await hand.points(...HANDLES);
    await hand.setSwitch('Lock the outline', true);
    await hand.setSwitch('Stop at folds', true);
    await hand.key('f');
    await hand.page.getByRole('slider', { name: 'Brush size' }).fill(String(size));
    // The first strokes compile the code.
    for (let k = 0; k < 3; k++) await stroke(hand);
    let frame = 0;
    const { main, workers } = await scriptTimes(browser, hand.page, async () => {
      frame = await stroke(hand);
    });
    const figures = [quantile(main, 0.5), quantile(main, 0.95), quantile(workers, 0.95), frame];
    rows.push(`| ${size} % | ${figures.map((ms) => ms.toFixed(1)).join(' | ')} |`);
    await hand.close();
  }
  const head = '| brush | script a move, median, ms | 95 %, ms | in workers, 95 %, ms | frame, ms |';
  return [head, '|---|---:|---:|---:|---:|', ...rows].join('\n');
}

/**
 * Draws a stroke, and waits until it is stored.
 * @param {Hand} hand
 * @returns The mean time in milliseconds from a move to the frame after it.
 */
async function stroke(hand) {
  const { x, y } = await hand.screen([SIZE[0] / 2, SIZE[1] / 2]);
  const { mouse } = hand.page;
  await mouse.move(x + WAY, y);
  await mouse.down();
  const start = performance.now();
  for (let k = 1; k <= MOVES; k++) {
    const turn = (4 * Math.PI * k) / MOVES;
    await mouse.move(x + WAY * Math.cos(turn), y + WAY * Math.sin(turn));
    await hand.frames(1);
  }
  const mean = (performance.now() - start) / MOVES;
  await mouse.up();
  await hand.idle();
  return mean;
}
