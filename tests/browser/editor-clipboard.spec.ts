/** Poses, pictures and text through the clipboard, with real keys. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

const clipped = (page: Page) => page.evaluate(() => navigator.clipboard.readText());
const clip = (page: Page, text: string) => page.evaluate((text) => navigator.clipboard.writeText(text), text);
const copy = (page: Page) => page.keyboard.press('Control+c');
const paste = (page: Page) => page.keyboard.press('Control+v');
const posed = async (editor: Editor, id: string) => (await editor.projectHandle(id))?.posed;

test('without a selection all handles are copied; a paste is one step', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  await editor.dragHandle('right foot', { x: 20, y: -10 });
  const pose = await Promise.all([posed(editor, 'left-hand'), posed(editor, 'right-foot')]);
  await page.keyboard.press('Escape');
  await copy(page);
  await expect(page.getByText('Copied the pose of 5 handles')).toBeAttached();
  expect(JSON.parse(await clipped(page))).toMatchObject({ format: 'c2warp-pose/1', handles: { length: 5 } });
  await editor.button('Reset all handles').click();
  await expect.poll(() => posed(editor, 'left-hand')).toEqual([124, 516]);
  await paste(page);
  await expect(page.getByText('Paste the pose of 5 handles')).toBeAttached();
  expect(await Promise.all([posed(editor, 'left-hand'), posed(editor, 'right-foot')])).toEqual(pose);
  await page.keyboard.press('Control+z');
  expect(await posed(editor, 'left-hand')).toEqual([124, 516]);
  expect(await posed(editor, 'right-foot')).toEqual([712, 1126]);
});

test('the pose of one handle is pasted to it, or to the selected ones', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const [x = 0, y = 0] = (await posed(editor, 'left-hand')) as [number, number];
  await copy(page);
  await page.keyboard.press('r');
  await expect.poll(() => posed(editor, 'left-hand')).toEqual([124, 516]);
  await page.keyboard.press('Escape');
  await paste(page);
  expect(await posed(editor, 'left-hand')).toEqual([x, y]);

  const [head, foot] = [await editor.position('head'), await editor.position('left foot')];
  await page.mouse.click(head.x, head.y);
  await page.keyboard.down('Shift');
  await page.mouse.click(foot.x, foot.y);
  await page.keyboard.up('Shift');
  await paste(page);
  expect(await posed(editor, 'head')).toEqual([expect.closeTo(512 + x - 124), expect.closeTo(260 + y - 516)]);
  expect(await posed(editor, 'left-foot')).toEqual([
    expect.closeTo(312 + x - 124),
    expect.closeTo(1126 + y - 516),
  ]);
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');

  // A notice appears if the handle does not exist.
  await page.keyboard.press('Escape');
  await editor.handle('left hand').focus();
  await editor.waitForSolve(() => page.keyboard.press('Delete'));
  await paste(page);
  await expect(page.getByText('No handle here matches the pose of left hand.')).toBeVisible();
});

test('poses are copied and pasted with the focus on a switch', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const moved = await posed(editor, 'left-hand');
  await page.keyboard.press('Escape');
  await editor.switch('Lock the outline').focus();
  await copy(page);
  expect(await clipped(page)).toContain('c2warp-pose/1');
  await page.keyboard.press('Control+z');
  await expect.poll(() => posed(editor, 'left-hand')).toEqual([124, 516]);
  await paste(page);
  await expect.poll(() => posed(editor, 'left-hand')).toEqual(moved);
});

test('an invalid pose is rejected, and other text is ignored', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  for (const text of ['hello', '{"format": "c2warp/1"}']) {
    await clip(page, text);
    await paste(page);
  }
  await editor.waitFrames();
  await expect(page.locator('c2-warp .notice')).toHaveCount(0);
  await clip(
    page,
    '{"format": "c2warp-pose/1", "handles": [{"id": "head", "kind": "point", "rest": "here"}]}',
  );
  await paste(page);
  await expect(editor.notice).toContainText(
    'Could not paste this pose: handle "head", rest: expected a point',
  );
  await expect(editor.button('Undo')).toBeDisabled();
});

test('text in fields and beside the stage is copied and pasted as text', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  await copy(page);
  const pose = await clipped(page);
  await editor.field('x').fill('300');
  await editor.field('x').press('Enter');
  await editor.field('x').selectText();
  await copy(page);
  expect(await clipped(page)).toBe('300');
  await editor.field('y').selectText();
  await paste(page);
  await editor.field('y').press('Enter');
  await expect.poll(() => posed(editor, 'left-hand')).toEqual([300, 300]);
  await clip(page, pose);
  await editor.field('y').selectText();
  await paste(page);
  await page.keyboard.press('Escape');
  expect(await posed(editor, 'left-hand')).toEqual([300, 300]);

  await page.locator('c2-warp .shell').focus();
  await page.getByRole('heading', { name: 'left hand' }).selectText();
  await copy(page);
  expect((await clipped(page)).trim()).toBe('left hand');
  // With the focus on the stage the pose is copied, whatever text is selected.
  await editor.handle('left hand').focus();
  await copy(page);
  expect(await clipped(page)).toContain('c2warp-pose/1');
});

/** Copies a picture of 40 × 30 pixels, as other programs do, with these texts. */
const clipPicture = (page: Page, texts: Readonly<Record<string, string>> = {}) =>
  page.evaluate(async (texts) => {
    const canvas = new OffscreenCanvas(40, 30);
    canvas.getContext('2d')?.fillRect(0, 0, 40, 30);
    const items: Record<string, Blob> = { 'image/png': await canvas.convertToBlob({ type: 'image/png' }) };
    for (const [type, text] of Object.entries(texts)) items[type] = new Blob([text], { type });
    await navigator.clipboard.write([new ClipboardItem(items)]);
  }, texts);

for (const [name, focus] of [
  ['a number of a handle', async (editor: Editor) => editor.field('x').click()],
  [
    'a number that was typed',
    async (editor: Editor) => {
      await editor.field('x').fill('300');
      await editor.field('x').press('Enter');
    },
  ],
  ['a name', async (editor: Editor) => editor.page.keyboard.press('F2')],
  [
    'the field of an address',
    async (editor: Editor) => {
      await editor.button('Open recent work').click();
      await editor.page.getByRole('textbox', { name: 'Address' }).click();
    },
  ],
  [
    'a number of an export',
    async (editor: Editor) => {
      await editor.button('Export as …').click();
      await editor.page
        .getByRole('dialog', { name: 'Export' })
        .getByRole('button', { name: 'Engine' })
        .click();
      await editor.page.getByRole('spinbutton', { name: 'Bones (' }).click();
    },
  ],
] as const) {
  test(`a picture that is pasted into ${name} opens, and a text stays there`, async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.handle('head').focus();
    await focus(editor);
    // Spreadsheets copy a picture of the text with it.
    await clipPicture(page, { 'text/plain': '41' });
    await page.keyboard.press('Control+a');
    await paste(page);
    const typed = await page.locator('c2-warp').evaluate(({ shadowRoot }) => {
      const field = shadowRoot?.activeElement;
      return field instanceof HTMLInputElement && field.value;
    });
    expect(typed).toBe('41');
    await expect(editor.handles).toHaveCount(5);
    await clipPicture(page);
    await paste(page);
    await expect(editor.status.getByText('40 × 30 px')).toBeAttached();
  });
}

test('a picture in HTML, and a project file, open from a number field too', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await editor.field('x').click();
  const project = { ...(await page.locator('c2-warp').evaluate((element) => (element as C2Warp).project)) };
  // No program of the test can put a file on the clipboard.
  await page.locator('c2-warp').evaluate(
    ({ shadowRoot }, text) => {
      const clipboardData = new DataTransfer();
      clipboardData.items.add(new File([text], 'a.c2warp.json', { type: 'application/json' }));
      const event = new ClipboardEvent('paste', {
        clipboardData,
        bubbles: true,
        composed: true,
        cancelable: true,
      });
      shadowRoot?.activeElement?.dispatchEvent(event);
    },
    JSON.stringify({ ...project, clips: [], handles: project.handles.slice(0, 2) }),
  );
  await expect(editor.handles).toHaveCount(2);

  await editor.handle('head').focus();
  await editor.field('x').click();
  await page.evaluate(async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 20, height: 30 });
    canvas.getContext('2d')?.fillRect(0, 0, 20, 30);
    const html = new Blob([`<img src="${canvas.toDataURL()}">`], { type: 'text/html' });
    await navigator.clipboard.write([new ClipboardItem({ 'text/html': html })]);
  });
  await paste(page);
  await expect(editor.status.getByText('20 × 30 px')).toBeAttached();
});

test('Control C copies the selected handle after Tab has gone through number fields', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await editor.field('depth').focus();
  await editor.field('depth').selectText();
  await page.keyboard.press('Tab');
  await copy(page);
  expect(await clipped(page)).toContain('c2warp-pose/1');
});

test('on other pages the element uses the clipboard only while focused', async ({ page }) => {
  await page.goto('/plain/');
  const editor = new Editor(page);
  await editor.ready();
  await page.evaluate(() => {
    const words = Object.assign(document.createElement('p'), { textContent: 'words', tabIndex: 0 });
    document.body.prepend(words);
  });
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const moved = await posed(editor, 'left-hand');
  await copy(page);
  await page.keyboard.press('Control+z');
  await page.getByText('words', { exact: true }).focus();
  await paste(page);
  await editor.waitFrames();
  expect(await posed(editor, 'left-hand')).toEqual([124, 516]);
  await page.getByText('words', { exact: true }).selectText();
  await editor.handle('left hand').focus();
  await paste(page);
  expect(await posed(editor, 'left-hand')).toEqual(moved);
  await page.getByText('words', { exact: true }).focus();
  await page.getByText('words', { exact: true }).selectText();
  await copy(page);
  expect(await clipped(page)).toBe('words');

  // A readonly editor pastes nothing, and leaves the paste event to the page.
  await editor.handle('left hand').focus();
  await copy(page);
  expect(await clipped(page)).toContain('c2warp-pose/1');
  await page.keyboard.press('Control+z');
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  await paste(page);
  await editor.waitFrames();
  expect(await posed(editor, 'left-hand')).toEqual([124, 516]);
  await page.locator('c2-warp').evaluate((element) => element.removeAttribute('readonly'));

  await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(40, 30);
    canvas.getContext('2d')?.fillRect(0, 0, 40, 30);
    const blob = await canvas.convertToBlob({ type: 'image/png' });
    await navigator.clipboard.write([new ClipboardItem({ 'image/png': blob })]);
  });
  await editor.handle('left hand').focus();
  await paste(page);
  await expect(editor.status.getByText('40 × 30 px')).toBeAttached();
});
