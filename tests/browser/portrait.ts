/** The portrait of the samples, an opaque photograph, and rings in it. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { ImageRef } from '../../web/src/document/project';

type Place = readonly [number, number];

export const PORTRAIT = fileURLToPath(new URL('../../web/public/samples/portrait.png', import.meta.url));
const { width, height } = decode(readFileSync(PORTRAIT));
export const PORTRAIT_IMAGE: ImageRef = { src: 'portrait.png', width, height };

/** A ring of 24 corners around a place, a fifth of the portrait wide each way. */
export const ringAround = ([x, y]: Place): readonly Place[] =>
  Array.from(
    { length: 24 },
    (_, k): Place => [
      Math.round(x + (width / 5) * Math.cos((Math.PI * k) / 12)),
      Math.round(y + (width / 5) * Math.sin((Math.PI * k) / 12)),
    ],
  );

/** Opens the portrait without handles. */
export async function loadPortrait(page: Page): Promise<void> {
  await page.evaluate(async (image) => {
    const element = document.querySelector('c2-warp');
    await element?.load('/samples/portrait.png', { format: 'c2warp/1', image, handles: [] });
  }, PORTRAIT_IMAGE);
}
