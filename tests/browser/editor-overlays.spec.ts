/** The overlays of cells and coverage: content, and updates with picture and handles. */
import type { Locator } from '@playwright/test';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const box = (editor: Editor, name: string): Locator => editor.page.getByRole('checkbox', { name });

async function overlay(editor: Editor, name: string): Promise<void> {
  await editor.button(/^Overlays/).click();
  await box(editor, name).click();
  await editor.page.keyboard.press('Escape');
}

/** The line of the borders, without its pale casing. */
const borders = (editor: Editor): Locator => editor.page.locator('.marks path.cells').last();

const line = async (editor: Editor): Promise<string> => (await borders(editor).getAttribute('d')) ?? '';

const pieces = async (editor: Editor): Promise<number> => (await line(editor)).split('M').length - 1;

test('cell borders follow a drag, and change with another handle', async ({ page }) => {
  const editor = await Editor.open(page);
  await overlay(editor, 'Cells');
  await expect(borders(editor)).toBeAttached();
  const before = await line(editor);
  const count = await pieces(editor);
  // Each of a hundred cells has at least some twenty pieces.
  expect(count).toBeGreaterThan(1000);

  const hand = await editor.position('left hand');
  await page.mouse.move(hand.x, hand.y);
  await page.mouse.down();
  await page.mouse.move(hand.x + 20, hand.y - 60, { steps: 4 });
  await editor.waitFrames();
  const dragged = await line(editor);
  expect(dragged).not.toBe(before);
  expect(await pieces(editor)).toBe(count);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await editor.waitFrames();
  expect(await line(editor)).toBe(before);

  await editor.waitForSolve(async () => {
    await page.keyboard.press('p');
    const at = await editor.fromImage('head', [512, 260]);
    const { x, y } = at(512, 640);
    await page.mouse.click(x, y);
  });
  await expect.poll(() => pieces(editor)).toBeGreaterThan(1000);
  expect(await line(editor)).not.toBe(before);

  // The borders of the earlier solution are requested again.
  await editor.waitForSolve(() => editor.button('Undo').click());
  await expect.poll(() => line(editor)).toBe(before);
  await overlay(editor, 'Cells');
  await expect(borders(editor)).toHaveCount(0);
});

test('coverage has a legend, and one heat map replaces the other', async ({ page }) => {
  const editor = await Editor.open(page);
  const plain = await editor.screenshot(await editor.position('head'), 30);
  const legend = page.getByRole('img', { name: /Few points move blue areas/ });
  await overlay(editor, 'Coverage');
  await expect(legend).toBeVisible();
  await editor.waitFrames();
  expect(Buffer.compare(await editor.screenshot(await editor.position('head'), 30), plain)).not.toBe(0);

  await editor.handle('head').click();
  await overlay(editor, 'Reach');
  await expect(legend).toBeHidden();
  await editor.button(/^Overlays/).click();
  await expect(box(editor, 'Coverage')).not.toBeChecked();
  await expect(box(editor, 'Reach')).toBeChecked();
  await box(editor, 'Coverage').click();
  await expect(box(editor, 'Reach')).not.toBeChecked();
  await page.keyboard.press('Escape');
  await expect(legend).toBeVisible();
});
