/// <reference lib="dom" />
/** The rocket at 12 megapixels: how long its fill and its export take. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Hand } from './hand.mjs';

const SIZE = /** @type {const} */ ([4240, 2830]);

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @param {string} pictures The folder of pictures.
 * @returns {Promise<string>} The times in words.
 */
export async function large(browser, address, pictures) {
  const file = join(pictures, 'rocket.jpg');
  const small = await Hand.open(browser, address, file);
  const enlarged = await small.page.evaluate(
    async ([base64, [width, height]]) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:;base64,${base64}`)).blob());
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [width, height];
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0, width, height);
      const address = canvas.toDataURL('image/jpeg', 0.9);
      return address.slice(address.indexOf(',') + 1);
    },
    /** @type {const} */ ([readFileSync(file).toString('base64'), SIZE]),
  );
  await small.close();
  const buffer = Buffer.from(enlarged, 'base64');
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
  const start = performance.now();
  await hand.key('Enter');
  await hand.page.getByText('Filling').first().waitFor();
  await hand.idle();
  const filled = performance.now();
  await hand.export();
  const exported = performance.now();
  await hand.close();
  const seconds = (/** @type {number} */ ms) => `${(ms / 1000).toFixed(1)} s`;
  return `${seconds(filled - start)}, and its export ${seconds(exported - filled)}`;
}
