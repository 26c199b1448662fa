/** Opens a page with `<c2-warp>` in a browser, bends the picture as a reader would, and compares it. */

/** @typedef {import('@playwright/test').Page} Page */

/**
 * Drags a handle with the mouse, scrolls the page to its end, or sets the first slider to its end.
 * @typedef {'drag' | 'scroll' | 'slide'} Interaction
 */

const OPENS_MS = 60_000;
/** Pixels of the window, towards the middle of the picture and up. */
const BY_PX = { x: 25, y: -60 };
/** Colours differ if a channel differs by more than this. */
const CHANNEL = 16;
/** At least this fraction of the picture must look different afterwards. */
const LEAST_CHANGE = 0.002;
/** Browsers request it on their own. */
const ICON = '/favicon.ico';

/**
 * @param {Page} page
 * @param {string} address
 * @param {{ interaction?: Interaction, handle?: string }} example
 * @returns {Promise<number>} Seconds from the navigation until the picture could be bent.
 * @throws Error that states the failure.
 */
export async function secondsToFirstInteraction(
  page,
  address,
  { interaction = 'drag', handle = 'left hand' },
) {
  const problems = problemsOf(page);
  try {
    const start = performance.now();
    await page.goto(address);
    await page.waitForFunction(isLoaded, undefined, { timeout: OPENS_MS });
    const dragged = page.getByRole('button', { name: new RegExp(`^handle ${handle}, `, 'i') });
    if (interaction === 'drag') await dragged.waitFor({ timeout: OPENS_MS });
    const seconds = (performance.now() - start) / 1000;

    const before = await pixels(page);
    if (interaction === 'drag') await drag(page, dragged);
    else if (interaction === 'slide') await page.getByRole('slider').first().press('End');
    else await page.keyboard.press('End');
    const after = interaction === 'scroll' ? await scrolled(page) : await pixels(page);
    const change = changedPart(before, after);
    if (change < LEAST_CHANGE)
      throw new Error(`the interaction changed ${(change * 100).toFixed(2)} % of the picture`);
    if (problems.length > 0) throw new Error('the page has errors');
    return seconds;
  } catch (error) {
    const alert = await page
      .getByRole('alert')
      .first()
      .textContent({ timeout: 100 })
      .catch(() => null);
    const [message] = String(error instanceof Error ? error.message : error).split('\n');
    throw new Error([message, ...(alert ? [`notice: ${alert.trim()}`] : []), ...problems].join('\n  '));
  }
}

/** Whether a picture is open and solved. It runs in the page. */
async function isLoaded() {
  await customElements.whenDefined('c2-warp');
  const warp = /** @type {{ loaded?: Promise<void> } | null} */ (
    /** @type {unknown} */ (document.querySelector('c2-warp'))
  );
  await warp?.loaded;
  return warp !== null;
}

/** The picture at the end of the page. Browsers scroll there step by step. @param {Page} page */
async function scrolled(page) {
  await page.waitForFunction(() => {
    const { scrollTop, scrollHeight, clientHeight } = document.documentElement;
    return scrollTop > 0 && scrollTop + clientHeight > scrollHeight - 1;
  });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return pixels(page);
}

/**
 * Collects errors, failed requests and warnings of the page as they occur.
 * @param {Page} page
 */
function problemsOf(page) {
  /** @type {string[]} */
  const problems = [];
  page.on('pageerror', ({ message }) => problems.push(`error: ${message}`));
  page.on('requestfailed', (request) => problems.push(`failed: ${request.url()}`));
  page.on('response', (response) => {
    if (response.status() >= 400 && !response.url().endsWith(ICON))
      problems.push(`${response.status()}: ${response.url()}`);
  });
  page.on('console', (message) => {
    if (/multiple versions of lit/i.test(message.text())) problems.push(`warning: ${message.text()}`);
  });
  return problems;
}

/**
 * @param {Page} page
 * @param {import('@playwright/test').Locator} handle
 */
async function drag(page, handle) {
  const box = await handle.boundingBox();
  if (!box) throw new Error('the handle is not visible');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + BY_PX.x, y + BY_PX.y, { steps: 5 });
  await page.mouse.up();
}

/** The warped picture at a quarter of its size. @param {Page} page @returns {Promise<number[]>} */
const pixels = (page) =>
  page.locator('c2-warp').evaluate(async (element) => {
    const warp = /** @type {{ toCanvas(options: { scale: number }): Promise<HTMLCanvasElement> }} */ (
      /** @type {unknown} */ (element)
    );
    const canvas = await warp.toCanvas({ scale: 0.25 });
    const context = canvas.getContext('2d');
    if (!context) throw new Error('no canvas');
    return [...context.getImageData(0, 0, canvas.width, canvas.height).data];
  });

/**
 * @param {readonly number[]} before
 * @param {readonly number[]} after
 */
function changedPart(before, after) {
  if (before.length !== after.length) throw new Error('the size of the picture has changed');
  let changed = 0;
  for (let pixel = 0; pixel < before.length; pixel += 4) {
    const differs = [0, 1, 2, 3].some(
      (channel) => Math.abs(Number(before[pixel + channel]) - Number(after[pixel + channel])) > CHANNEL,
    );
    if (differs) changed += 1;
  }
  return changed / (before.length / 4);
}
