/** The picture is drawn from one mip level while something moves, and in full detail at rest. */
import type { Page } from '@playwright/test';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Records for every drawing whether its picture was read from one mip level: the filter says so. */
async function recordDrawings(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const drawings: string[] = [];
    let last = '';
    const { texParameteri, drawElements } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.texParameteri = function (target, name, value) {
      if (name === this.TEXTURE_MIN_FILTER)
        last = value === this.LINEAR_MIPMAP_NEAREST ? 'one level' : 'full detail';
      texParameteri.call(this, target, name, value);
    };
    WebGL2RenderingContext.prototype.drawElements = function (...given) {
      drawings.push(last);
      drawElements.apply(this, given);
    };
    Object.assign(globalThis, { drawings });
  });
}

/** The drawings since the last call. */
const drawings = (page: Page): Promise<string[]> =>
  page.evaluate(() => (globalThis as unknown as { drawings: string[] }).drawings.splice(0));

const lastDrawing = (page: Page): Promise<string | undefined> =>
  page.evaluate(() => (globalThis as unknown as { drawings: string[] }).drawings.at(-1));

test.beforeEach(async ({ page }) => recordDrawings(page));

test('a drag is drawn from one level, and its end in full detail', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
  const { x, y } = await editor.position('left hand');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y - 10);
  await expect.poll(() => drawings(page)).toContain('one level');
  // Held still.
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
  await page.mouse.move(x + 20, y - 20);
  await page.mouse.up();
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
});

test('a clip is drawn from one level, and full detail returns when it stops', async ({ page }) => {
  await Editor.open(page);
  await page.locator('c2-warp').press('t');
  await drawings(page);
  await page.locator('c2-warp').press('k');
  await expect.poll(() => lastDrawing(page)).toBe('one level');
  await page.locator('c2-warp').press('k');
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
});

test('a zoom is drawn from one level, and rests in full detail', async ({ page }) => {
  const editor = await Editor.open(page);
  const { x, y } = await editor.position('left hand');
  await page.mouse.move(x, y);
  await drawings(page);
  await page.mouse.wheel(0, -100);
  await expect.poll(() => drawings(page)).toContain('one level');
  await page.mouse.wheel(0, -100);
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
});

test('a step without a drag is drawn in full detail at once', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
  await drawings(page);
  await page.locator('c2-warp').press('Control+z');
  await expect.poll(() => lastDrawing(page)).toBe('full detail');
  expect(await drawings(page)).not.toContain('one level');
});
