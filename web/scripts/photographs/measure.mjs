/// <reference lib="dom" />
/** Measures an edit: its seam at rest, and the times of frames. */

/** Frames that are timed. */
const FRAMES = 20;
/** How far the pointer goes around a place while frames are timed, in pixels of the screen. */
const SWING = 8;

/**
 * The largest difference of a colour between a picture and its export at rest, in levels: 0 if no seam shows.
 * @param {import('@playwright/test').Page} page
 * @param {Buffer} before
 * @param {Buffer} rest
 */
export function seam(page, before, rest) {
  return page.evaluate(
    async (pictures) => {
      const [a, b] = await Promise.all(
        pictures.map(async (base64) => {
          const blob = await (await fetch(`data:;base64,${base64}`)).blob();
          const bitmap = await createImageBitmap(blob);
          const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
          pen?.drawImage(bitmap, 0, 0);
          return pen?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? new Uint8ClampedArray();
        }),
      );
      if (!a || !b || a.length !== b.length) return Number.NaN;
      return a.reduce((most, value, at) => Math.max(most, Math.abs(value - (b[at] ?? 0))), 0);
    },
    [before.toString('base64'), rest.toString('base64')],
  );
}

/**
 * The mean time between frames in milliseconds, while nothing moves.
 * @param {import('@playwright/test').Page} page
 */
export const restingFrame = (page) =>
  page.evaluate(async (count) => {
    const frame = () => new Promise((done) => requestAnimationFrame(done));
    await frame();
    const start = performance.now();
    for (let k = 0; k < count; k++) await frame();
    return (performance.now() - start) / count;
  }, FRAMES);

/**
 * The mean time in milliseconds from a move of the pointer to the frame after it, while a press moves something. This
 * is the latency of a handle, and of a brush alike. The press ends where it began.
 * @param {import('./hand.mjs').Hand} hand
 * @param {import('./hand.mjs').Place} place The place of the press.
 */
export async function movingFrame({ page }, place) {
  const [x, y] = await page.evaluate(
    (place) => /** @type {any} */ (document.querySelector('c2-warp')).imageToClient(place),
    place,
  );
  await page.mouse.move(x, y);
  await page.mouse.down();
  const start = performance.now();
  for (let k = 1; k <= FRAMES; k++) {
    await page.mouse.move(x + SWING * Math.sin(k), y + SWING * Math.cos(k));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => done(undefined))));
  }
  const mean = (performance.now() - start) / FRAMES;
  await page.keyboard.press('Escape');
  await page.mouse.up();
  return mean;
}
