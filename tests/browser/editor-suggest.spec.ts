/** Suggested handles: by button, key and menu, beside existing handles, and for photographs. */
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Opens the sample without its handles. */
async function bare(editor: Editor): Promise<void> {
  await editor.handle('left hand').focus();
  await editor.page.keyboard.press('Control+a');
  await editor.waitForSolve(() => editor.page.keyboard.press('Delete'));
  await expect(editor.handles).toHaveCount(0);
}

const over = (editor: Editor) =>
  editor.page.locator('c2-warp .hint').getByRole('button', { name: 'Suggest handles' });
const notices = (editor: Editor) => editor.page.locator('c2-warp .notice');
const project = (editor: Editor) =>
  editor.page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

test('a press on the button places named handles, and undo removes all of them', async ({ page }) => {
  const editor = await Editor.open(page);
  await bare(editor);
  await editor.waitForSolve(() => over(editor).click());
  await expect(notices(editor)).toContainText(/Placed \d+ handles\. Drag one to bend the picture\./);
  const { handles } = await project(editor);
  expect(handles.length).toBeGreaterThanOrEqual(5);
  expect(handles.length).toBeLessThanOrEqual(12);
  await expect(editor.handles).toHaveCount(handles.length);
  await expect(over(editor)).toBeHidden();
  // The list names them, and so does the stage under the pointer.
  const name = 'left arm, end';
  await expect(page.locator('c2-warp .list').getByRole('button', { name })).toBeVisible();
  const at = await editor.position(name);
  await page.mouse.move(at.x, at.y);
  await expect(page.locator('c2-warp .marks').getByText(/^left arm, end$/i)).toBeVisible();
  // The next press drags one.
  await editor.dragHandle(name, { x: 30, y: 0 });
  await expect.poll(async () => (await editor.position(name)).x).toBeCloseTo(at.x + 30, 0);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(0);
  await expect(page.getByText(`Undone: Suggest ${handles.length} handles`)).toBeAttached();
});

test('N keeps the handles that are there, and adds those that are missing', async ({ page }) => {
  const editor = await Editor.open(page);
  const before = await project(editor);
  await editor.handle('head').focus();
  await page.keyboard.press('n');
  await expect(notices(editor)).toContainText(/Added \d+ handles?\. The 5 existing handles stay\./);
  const { handles } = await project(editor);
  expect(handles.slice(0, 5)).toEqual(before.handles);
  const names = handles.map(({ id }) => id);
  expect(new Set(names).size).toBe(names.length);
  // All places have one now.
  await page.keyboard.press('n');
  await expect(notices(editor)).toContainText('No handles were added');
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(5);
});

test('N before a picture is open waits, and a photograph gets even rows', async ({ page }) => {
  const editor = await Editor.open(page);
  const chooser = page.waitForEvent('filechooser');
  await editor.button('Open a picture or project').click();
  const bytes = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(4000, 3000);
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
    context.fillStyle = '#6a8';
    context.fillRect(0, 0, 4000, 3000);
    const blob = await canvas.convertToBlob({ type: 'image/jpeg' });
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
  await (await chooser).setFiles({ name: 'lawn.jpg', mimeType: 'image/jpeg', buffer: Buffer.from(bytes) });
  await page.keyboard.press('n');
  await expect(editor.handles).toHaveCount(9);
  expect((await project(editor)).image.src).toBe('lawn.jpg');
  await expect(
    page.locator('c2-warp').getByText(/even rows, because the picture has no outline/),
  ).toBeVisible();
});

test('the menu of the picture suggests handles', async ({ page }) => {
  const editor = await Editor.open(page);
  await bare(editor);
  const stage = await editor.centre(page.locator('c2-warp .stage'));
  await page.mouse.click(stage.x, stage.y, { button: 'right' });
  await page.getByRole('menuitem', { name: 'Suggest handles' }).click();
  await expect(editor.handles).not.toHaveCount(0);
});
