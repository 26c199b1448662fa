/** Tabs that are killed at random moments, and two tabs on one work. */
import { expect, type Page, test } from '@playwright/test';
import { among } from '../../web/src/editor/random';
import { openWithHandle, randomIn, times } from './attacks';
import { Editor } from './editor';

const KILLS = times(50, 3);
const INTERLEAVINGS = times(200, 6);
/** Wide enough for a step of a pixel after every kill. */
const SIDE = 400;

/** A page without file pickers, so that tests can watch uploads. */
async function prepared(page: Page): Promise<Page> {
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showOpenFilePicker'));
  return page;
}

/** Opens the editor where it has stored work with one handle. */
async function reopened(page: Page): Promise<Editor> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('/');
  const editor = new Editor(page);
  await expect(editor.handle('handle 1')).toBeVisible();
  await expect(editor.solved).toContainText('mesh point');
  return editor;
}

const storedX = async (editor: Editor) => {
  const { handles = [] } = await editor.storedWork();
  const [handle] = handles;
  return handle?.kind === 'point' ? handle.posed[0] : Number.NaN;
};

/** Ends the process of a page. */
async function kill(page: Page): Promise<void> {
  const crashed = page.waitForEvent('crash');
  const devtools = await page.context().newCDPSession(page);
  devtools.send('Page.crash').catch(() => {});
  await crashed;
  await page.close();
}

test('a tab killed at random moments keeps stored work, and stores nothing incomplete', async ({
  context,
}) => {
  test.setTimeout(KILLS * 20_000 + 120_000);
  const random = randomIn('kills');
  let editor = await Editor.open(await prepared(await context.newPage()));
  await openWithHandle(editor, 'disc.png', SIDE);
  for (let count = 0; count < KILLS; count++) {
    const { page } = editor;
    await editor.handle('handle 1').focus();
    await page.keyboard.press('ArrowRight');
    const { x: committed } = await editor.shownPose('handle 1');
    await expect.poll(() => storedX(editor)).toBe(committed);
    const more = Math.floor(random() * 4);
    for (let step = 0; step < more; step++) await page.keyboard.press('ArrowRight');
    if (random() < 0.5) await editor.waitFrames();
    await kill(page);
    editor = await reopened(await prepared(await context.newPage()));
    const { x } = await editor.shownPose('handle 1');
    expect(x, `kill ${count}`).toBeGreaterThanOrEqual(committed);
    expect(x, `kill ${count}`).toBeLessThanOrEqual(committed + more);
    expect(await editor.storedWork()).toMatchObject({ picture: 'disc.png' });
  }
});

/** Focuses the handle, which selects it. After Escape it still has the focus, without being selected. */
async function focusHandle(editor: Editor): Promise<void> {
  const handle = editor.handle('handle 1');
  await handle.blur();
  await handle.focus();
  await expect(handle).toBeFocused();
}

/** The actions of a person in one of two tabs. Each ends once it is shown. */
const ACTIONS: Readonly<Record<string, (editor: Editor) => Promise<void>>> = {
  async moves(editor) {
    const before = await editor.shownPose('handle 1');
    await focusHandle(editor);
    await editor.page.keyboard.press(before.y > SIDE / 2 ? 'ArrowUp' : 'ArrowDown');
    await expect.poll(async () => (await editor.shownPose('handle 1')).y).not.toBe(before.y);
  },
  async undoes(editor) {
    const undo = editor.button('Undo: move handle 1');
    if (!(await undo.isVisible())) return;
    const before = await editor.shownPose('handle 1');
    await undo.click();
    await expect.poll(() => editor.shownPose('handle 1')).not.toEqual(before);
  },
  async selects(editor) {
    await focusHandle(editor);
    await editor.page.keyboard.press('Escape');
  },
  async reloads({ page }) {
    await page.reload();
    await reopened(page);
  },
};

test('two tabs on one work, interleaved at random, lose no version', async ({ context }) => {
  test.setTimeout(INTERLEAVINGS * 20_000 + 120_000);
  const random = randomIn('tabs');
  const first = await Editor.open(await prepared(await context.newPage()));
  await openWithHandle(first, 'disc.png', SIDE);
  await first.page.keyboard.press('ArrowRight');
  await expect.poll(async () => (await first.storedWork()).step).toBe('Move handle 1');
  const tabs = [first, await reopened(await prepared(await context.newPage()))] as const;
  for (let count = 0; count < INTERLEAVINGS; count++) {
    const tab = among(tabs, random);
    const action = among(Object.keys(ACTIONS), random);
    await test.step(`${count}: ${tab === first ? 'first' : 'second'} ${action}`, async () => {
      await tab.page.bringToFront();
      await ACTIONS[action]?.(tab);
      await expect(tab.handles).toHaveCount(1);
      if (action !== 'moves') return;
      // The last change of either tab is what the next one opens.
      const { x, y } = await tab.shownPose('handle 1');
      await expect
        .poll(async () => {
          const [handle] = (await tab.storedWork()).handles ?? [];
          return handle?.kind === 'point' ? handle.posed : null;
        })
        .toEqual([x, y]);
    });
  }
});
