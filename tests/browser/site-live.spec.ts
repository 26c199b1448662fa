/** The live pictures of the site: the landing page, and rigs that the playground shares. */
import type { Locator, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { expect, test } from './fixtures';
import { BUILD_MS, openPage } from './site';

test.describe.configure({ timeout: BUILD_MS + 120_000 });

const warpOf = (page: Page): Locator => page.locator('c2-warp');

/** Where a point of the picture is after the warp. */
const mapped = (page: Page, point: readonly [number, number]) =>
  warpOf(page).evaluate((element, point) => (element as C2Warp).mapPoint?.(point) ?? null, point);

const handlesOf = (page: Page) => warpOf(page).evaluate((element) => (element as C2Warp).project.handles);

/** Drags a handle by a real pointer. */
async function drag(page: Page, name: string, [x, y]: readonly [number, number]): Promise<void> {
  const handle = page.getByRole('button', { name: `Handle ${name}, ` });
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.boundingBox();
  if (!box) throw new Error(`the handle ${name} is not on screen`);
  const [fromX, fromY] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(fromX, fromY);
  await page.mouse.down();
  await page.mouse.move(fromX + x, fromY + y, { steps: 4 });
  await page.mouse.up();
}

test('a visitor of the landing page drags the picture', async ({ page }) => {
  await openPage(page, '/site/');
  await expect.poll(() => mapped(page, [900, 516])).not.toBeNull();
  const [hand, foot] = [await mapped(page, [880, 500]), await mapped(page, [312, 1100])];
  await drag(page, 'right hand', [-30, -80]);
  await expect.poll(async () => (await mapped(page, [880, 500]))?.[1]).toBeLessThan((hand?.[1] ?? 0) - 50);
  const moved = await mapped(page, [312, 1100]);
  expect(Math.hypot((moved?.[0] ?? 0) - (foot?.[0] ?? 0), (moved?.[1] ?? 0) - (foot?.[1] ?? 0))).toBeLessThan(
    20,
  );
});

test('the landing page shows its picture from the first paint, and nothing moves', async ({ page }) => {
  await page.setViewportSize({ width: 1300, height: 900 });
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route('**/element/c2warp.js', async (route) => {
    await held;
    await route.continue();
  });
  await openPage(page, '/site/');
  const drawing = page.locator('.warp-picture img');
  await expect(drawing).toBeVisible();
  const shown = () =>
    drawing.evaluate((image: HTMLImageElement) => {
      const { x, y, width, height } = image.getBoundingClientRect();
      const rim = Number.parseFloat(getComputedStyle(image).padding);
      const scale = Math.min(
        (width - 2 * rim) / image.naturalWidth,
        (height - 2 * rim) / image.naturalHeight,
      );
      return { at: [x + width / 2, y + height / 2], size: [width, height], scale };
    });
  await expect.poll(async () => (await shown()).scale).toBeGreaterThan(0.3);
  const { at, size, scale } = await shown();
  const below = await page.getByRole('heading', { name: 'Two lines in your page' }).boundingBox();
  release();
  await expect.poll(() => mapped(page, [512, 640])).not.toBeNull();
  await expect(drawing).toBeHidden();
  const after = await warpOf(page).evaluate((element) => {
    const warp = element as C2Warp;
    const { width, height } = warp.getBoundingClientRect();
    return { at: warp.imageToClient([512, 640]), size: [width, height], scale: warp.zoom };
  });
  expect(after.size).toEqual(size);
  expect(Math.hypot((after.at?.[0] ?? 0) - (at[0] ?? 0), (after.at?.[1] ?? 0) - (at[1] ?? 0))).toBeLessThan(
    1,
  );
  expect(Math.abs(after.scale - scale)).toBeLessThan(0.002);
  expect(await page.getByRole('heading', { name: 'Two lines in your page' }).boundingBox()).toEqual(below);
});

test('the picture of the landing page follows the colours of the site', async ({ page }) => {
  await page.setViewportSize({ width: 1300, height: 800 });
  await openPage(page, '/site/');
  await expect(warpOf(page)).toHaveAttribute('theme', 'light');
  await page.getByRole('banner').getByRole('switch').click();
  await expect(warpOf(page)).toHaveAttribute('theme', 'dark');
});

test('a rig of the playground opens elsewhere with the same handles', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page, '/site/playground/');
  await page.getByRole('combobox', { name: 'Picture' }).selectOption('cat');
  await expect(page.getByRole('textbox', { name: 'Project' })).toHaveValue(/"cat\.png"/);
  await expect.poll(() => mapped(page, [340, 400])).not.toBeNull();
  const rest = await handlesOf(page);
  await drag(page, 'tail', [40, -30]);
  await expect.poll(() => handlesOf(page)).not.toEqual(rest);
  const handles = await handlesOf(page);
  await page.getByRole('button', { name: 'Copy link' }).click();
  await expect(page.getByRole('status').filter({ hasText: 'The link is copied.' })).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toBe(page.url());

  const other = await context.newPage();
  await openPage(other, link);
  await expect.poll(() => mapped(other, [340, 400])).not.toBeNull();
  expect(await handlesOf(other)).toEqual(handles);
  await expect(other.getByRole('combobox', { name: 'Picture' })).toHaveValue('cat');

  // Another address in the same window asks before it takes the place of an edited rig.
  const asked: string[] = [];
  page.once('dialog', (dialog) => {
    asked.push(dialog.message());
    return dialog.dismiss();
  });
  await page.evaluate(() => {
    location.hash = '#rig=AAAA';
  });
  await expect.poll(() => asked).toEqual(['Open the rig of this address in place of yours?']);
  expect(await handlesOf(page)).toEqual(handles);
});

test('the text of the playground bends the picture, and says why it cannot', async ({ page }) => {
  await openPage(page, '/site/playground/');
  await expect.poll(() => mapped(page, [512, 700])).not.toBeNull();
  const text = page.getByRole('textbox', { name: 'Project' });
  const project = await text.inputValue();
  await text.fill(project.replace('"posed": [124, 516]', '"posed": [160, 420]'));
  await expect
    .poll(async () => (await handlesOf(page)).find(({ id }) => id === 'left-hand')?.posed)
    .toEqual([160, 420]);
  const told = page.getByRole('status').first();
  await text.fill(project.replace('"posed": [124, 516]', '"posed": "up"'));
  await expect(told).toContainText('handles[1].posed');
  await text.fill(project.replace('gingerbread.png', 'dog.png'));
  await expect(told).toContainText('image.src names no sample');
  await text.fill(project);
  await expect(told).toHaveText('');
});

test('the playground says that an address is damaged, too long, or of no sample', async ({ page }) => {
  const told = page.getByRole('status').first();
  for (const [hash, sentence] of [
    ['rig=AAAA', 'damaged'],
    [`rig=${'A'.repeat(40_000)}`, 'too long'],
    // {"image":{"src":"dog.png"}}
    ['rig=q1bKzE1MT1WyqlYqLkpWslJKyU_XK8hLV6qtBQA', 'no sample'],
  ] as const) {
    await page.goto('about:blank');
    await openPage(page, `/site/playground/#${hash}`);
    await expect(told).toContainText(sentence);
    await expect.poll(() => mapped(page, [512, 700])).not.toBeNull();
  }
});
