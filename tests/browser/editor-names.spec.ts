/** Names of handles: on the stage, in the panel, and for programs, which refer to handles by them. */
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { expect, test } from './fixtures';

const beside = ({ x, y }: Position, dx: number, dy: number): Position => ({ x: x + dx, y: y + dy });

const nameField = (editor: Editor) => editor.page.getByRole('textbox', { name: 'Handle name' });
/** The names and numbers on the stage. */
const marks = (editor: Editor) => editor.page.locator('c2-warp .marks .name');

/** Places a point handle on the belly of the sample. */
async function addPoint(editor: Editor): Promise<Position> {
  const at = beside(await editor.position('head'), 0, 130);
  await editor.page.keyboard.press('p');
  await editor.page.mouse.click(at.x, at.y);
  await expect(editor.handle('handle 1')).toBeVisible();
  await editor.page.keyboard.press('v');
  await editor.page.keyboard.press('Escape');
  return at;
}

test('a new handle shows its number, until a double click and a name', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect(marks(editor)).toHaveCount(0);
  const at = await addPoint(editor);
  await page.mouse.move(at.x + 60, at.y - 60);
  await expect(marks(editor)).toHaveText('1');
  await page.mouse.move(at.x, at.y);
  await expect(marks(editor)).toHaveText('Handle 1');
  await page.mouse.dblclick(at.x, at.y);
  await expect(nameField(editor)).toBeFocused();
  await page.keyboard.type('  Middle   button ');
  await page.keyboard.press('Enter');
  await expect(editor.handle('Middle button')).toBeFocused();
  await expect(editor.handle('Middle button')).toHaveAttribute('aria-pressed', 'true');
  await expect(marks(editor)).toHaveText('Middle button');
  await editor.button('Undo: rename handle 1 to Middle button').click();
  await expect(editor.handle('handle 1')).toBeVisible();
  await page.keyboard.press('Control+Shift+z');
  await expect(editor.handle('Middle button')).toBeVisible();
});

test('F2 renames without another solve, Escape keeps the old name', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left foot', { x: -20, y: 10 });
  const pose = await editor.shownPose('left foot');
  const solved = await editor.solved.textContent();
  await editor.handle('left foot').focus();
  await page.keyboard.press('F2');
  await expect(nameField(editor)).toHaveValue('left foot');
  await page.keyboard.type('Boot');
  await page.keyboard.press('Escape');
  await expect(editor.handle('left foot')).toBeFocused();
  await page.keyboard.press('F2');
  await page.keyboard.type('Boot');
  await page.keyboard.press('Enter');
  await expect(editor.handle('Boot')).toBeFocused();
  expect(await editor.shownPose('Boot')).toEqual(pose);
  // The status line still shows the time of the previous solve.
  await expect(editor.solved).toHaveText(solved ?? '');
  await page.keyboard.press('ArrowDown');
  await expect.poll(() => editor.shownPose('Boot')).toMatchObject({ y: pose.y + 1 });
  const map = () => page.locator('c2-warp').evaluate((element) => (element as C2Warp).mapPoint([364, 1116]));
  expect((await map())?.[1]).toBeGreaterThan(1116);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(editor.handle('left foot')).toBeFocused();
  await expect.poll(async () => (await editor.storedWork()).step).toBe('Move left foot');
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(async () => (await editor.storedWork()).step).toBe('Rename left foot to Boot');
  await page.reload();
  await expect(editor.handle('Boot')).toBeVisible();
});

test('a name that is taken or empty is refused beside the field', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('left foot').click();
  await editor.button('Rename left foot').click();
  const field = nameField(editor);
  await expect(field).toBeFocused();
  await field.fill('HEAD');
  await expect(field).toHaveAccessibleDescription('Another handle has this name.');
  await page.keyboard.press('Enter');
  await expect(field).toBeFocused();
  await field.fill(' ');
  await expect(field).toHaveAccessibleDescription('A handle needs a name.');
  await field.fill('Shoe');
  await expect(field).toHaveAccessibleDescription('');
  await editor.handle('head').click();
  await expect(editor.handle('Shoe')).toBeVisible();
  await expect(field).toHaveCount(0);
  await editor.handle('Shoe').click();
  await page.keyboard.press('F2');
  await field.fill('left hand');
  await editor.handle('head').click();
  const notice = page.locator('c2-warp .notice');
  await expect(notice).toContainText('Another handle has this name. The name “Shoe” was kept.');
  await expect(editor.handle('Shoe')).toBeVisible();
});

test('the menu renames too, and programs find the new name', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('right foot').focus();
  await page.keyboard.press('ContextMenu');
  await page.getByRole('menuitem', { name: 'Rename' }).click();
  await page.keyboard.type('Left toe');
  await page.keyboard.press('Enter');
  await expect(editor.handle('Left toe')).toBeFocused();
  const selection = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.updateHandle('Left toe', { depth: 2 });
    return warp.selection;
  });
  expect(selection).toEqual(['Left toe']);
  expect(await editor.projectHandle('Left toe')).toMatchObject({ depth: 2 });
  expect(await editor.projectHandle('right-foot')).toBeUndefined();
});

test('names and numbers keep clear of other handles at each zoom', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await addPoint(editor);
  // Where the number of the first one would be.
  await page.keyboard.press('p');
  await page.mouse.click(at.x + 15, at.y - 11);
  await expect(editor.handle('handle 2')).toBeVisible();
  await page.keyboard.press('v');
  await page.keyboard.press('Escape');
  await page.mouse.move(at.x + 200, at.y + 150);
  for (const zoom of ['Zoom in', 'Zoom out', 'Zoom out', 'Zoom out']) {
    await editor.button(zoom).click();
    await expect(marks(editor)).toHaveText(['1', '2']);
    const clear = await page.locator('c2-warp').evaluate(({ shadowRoot }) => {
      const boxes = (of: string) =>
        [...(shadowRoot?.querySelectorAll(of) ?? [])].map((shown) => shown.getBoundingClientRect());
      return boxes('.marks .name').every((text) =>
        boxes('.handle').every((handle) => {
          const [x, y] = [(handle.left + handle.right) / 2, (handle.top + handle.bottom) / 2];
          return x < text.left - 5 || x > text.right + 5 || y < text.top - 5 || y > text.bottom + 5;
        }),
      );
    });
    expect(clear, zoom).toBe(true);
  }
});

test('signs that are not drawn are shown, and long names are cut', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.position('head');
  const refused = await page.locator('c2-warp').evaluate((element) => {
    const add = (id: string, x: number) =>
      (element as C2Warp).addHandle({ kind: 'point', id, rest: [x, 700] });
    add('left\u202ednah\u001b', 400);
    add('wide '.repeat(40), 460);
    try {
      add('x'.repeat(201), 520);
      return null;
    } catch (error) {
      return String(error);
    }
  });
  expect(refused).toContain('id: expected a name of at most 200 characters');
  const shown = String.raw`left\u{202e}dnah\u{1b}`;
  const handle = editor.handle(shown.replaceAll(/[\\{}]/g, String.raw`\$&`));
  await expect(handle).toBeVisible();
  const items = page.locator('c2-warp .item');
  await expect(items.filter({ hasText: shown })).toHaveCount(1);
  const wide = items.filter({ hasText: 'wide' });
  expect((await wide.boundingBox())?.height).toBeLessThan(80);
  await wide.click();
  await page.mouse.move(at.x, at.y);
  expect((await marks(editor).filter({ hasText: 'Wide' }).textContent())?.length).toBe(40);
  await handle.focus();
  await page.keyboard.press('F2');
  await expect(nameField(editor)).toHaveValue(shown);
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: rename')).toHaveCount(0);
  const ids = await page
    .locator('c2-warp')
    .evaluate((element) => (element as C2Warp).project?.handles.map(({ id }) => id));
  expect(ids).toContain('left\u202ednah\u001b');
});
