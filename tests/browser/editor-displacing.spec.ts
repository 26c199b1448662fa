/** The brush that moves the picture: its kinds, undo, the keyboard, Alt, and the file. */
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';

const isDisplaced = ({ page }: Editor): Promise<boolean> =>
  page.evaluate(() => document.querySelector('c2-warp')?.project.displacement !== undefined);

test('a push moves the picture at once, and undo takes strokes back one by one', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const before = await editor.mapped(512, 640);
  await page.keyboard.press('f');
  await expect(editor.button('Push')).toHaveAttribute('aria-pressed', 'true');
  await editor.drag(at(512, 640), { x: 30, y: 0 });
  await expect(editor.button('Undo: push')).toBeEnabled();
  const moved = await editor.settled(() => editor.mapped(512, 640));
  expect(moved?.[0]).toBeGreaterThan(530);
  await editor.button('Bloat').click();
  await editor.drag(at(512, 800), { x: 20, y: 0 });
  await expect(editor.button('Undo: bloat')).toBeEnabled();
  const buffer = await bytes(await editor.download('Save the project file'));
  await editor.button('Undo: bloat').click();
  await editor.button('Undo: push').click();
  expect(await isDisplaced(editor)).toBe(false);
  await expect.poll(() => editor.mappedDistance([512, 640], before ?? [0, 0])).toBeLessThan(1e-6);
  await editor.chooseFile({ name: 'gingerbread.c2warp.json', mimeType: 'application/json', buffer });
  await expect.poll(() => isDisplaced(editor)).toBe(true);
});

test('keys hold and push the picture; Alt restores; the bin clears', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('f');
  await page.keyboard.press('Enter');
  for (let k = 0; k < 8; k++) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: push')).toBeEnabled();
  expect(await isDisplaced(editor)).toBe(true);
  await editor.button('Clear the strokes of the brush').click();
  expect(await isDisplaced(editor)).toBe(false);
  await page.keyboard.down('Alt');
  await editor.drag(at(512, 640), { x: 10, y: 0 });
  await page.keyboard.up('Alt');
  expect(await isDisplaced(editor)).toBe(false);
});
