/// <reference lib="dom" />
/** A photograph at 12 megapixels. */
import { readFileSync } from 'node:fs';
import { Hand } from './hand.mjs';

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @param {string} file
 * @param {readonly [width: number, height: number]} size
 * @returns {Promise<Buffer>} A JPEG.
 */
export async function enlarged(browser, address, file, size) {
  const hand = await Hand.open(browser, address, file);
  const base64 = await hand.page.evaluate(
    async ([base64, [width, height]]) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:;base64,${base64}`)).blob());
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [width, height];
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0, width, height);
      const address = canvas.toDataURL('image/jpeg', 0.9);
      return address.slice(address.indexOf(',') + 1);
    },
    /** @type {const} */ ([readFileSync(file).toString('base64'), size]),
  );
  await hand.close();
  return Buffer.from(base64, 'base64');
}
