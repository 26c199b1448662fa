/** Stored work of a newer version, and a clock that is set back: the editor opens, and no work is lost. */
import type { Page } from '@playwright/test';
import { openWithHandle } from './attacks';
import { Editor } from './editor';
import { disc, png } from './files';
import { expect, test } from './fixtures';

const SIDE = 96;

/** Stored documents of a newer version: places, and their values there. */
const NEWER: Readonly<Record<string, Readonly<Record<string, unknown>>>> = {
  'another history': { format: 2, record: { steps: [] } },
  'no history': { format: 2, record: null },
};

/** Opens a picture with a handle, and waits until both are stored. */
async function worked(page: Page): Promise<Editor> {
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'disc.png', SIDE);
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(1);
  return editor;
}

/** Changes the stored document, if asked to. Returns what is stored under these names, as text. */
const storage = (page: Page, change: Readonly<Record<string, unknown>> | null) =>
  page.evaluate(async (change) => {
    const answer = <T>(request: IDBRequest<T>) =>
      new Promise<T>((done, fail) => {
        request.onsuccess = () => done(request.result);
        request.onerror = () => fail(request.error);
      });
    const database = await answer(indexedDB.open('c2warp'));
    const store = database.transaction('kept', 'readwrite').objectStore('kept');
    const before = await answer(store.get('editor/document'));
    if (change) await answer(store.put({ ...before, ...change }, 'editor/document'));
    const [document, picture] = [
      await answer(store.get('editor/document')),
      await answer(store.get('editor/picture')),
    ];
    database.close();
    return { document: JSON.stringify(document), picture: picture.name };
  }, change);

for (const [title, change] of Object.entries(NEWER)) {
  test(`work of a newer version with ${title} stays, and the editor opens`, async ({ page }) => {
    await worked(page);
    const stored = await storage(page, change);
    await page.reload();
    const editor = new Editor(page);
    await editor.ready();
    await editor.dragHandle('left hand', { x: 20, y: -40 });
    await expect(editor.notice).toContainText('newer version of the editor');
    expect(await storage(page, null)).toEqual(stored);
  });
}

test('after the clock is set back, recent work keeps its order', async ({ page }) => {
  await page.clock.install({ time: new Date('2030-06-01T12:00:00Z') });
  await page.clock.resume();
  const editor = await worked(page);
  await editor.chooseFile(png('second.png', disc(SIDE)));
  await expect(page).toHaveTitle('second.png – c2warp');
  await page.clock.setSystemTime(new Date('2026-01-01T00:00:00Z'));
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  await expect(editor.handles).toHaveCount(1);
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(1);
  await editor.chooseFile(png('third.png', disc(SIDE)));
  await expect(page).toHaveTitle('third.png – c2warp');
  await expect.poll(async () => (await editor.storedWork()).picture).toBe('third.png');
  await page.reload();
  await expect(page).toHaveTitle('third.png – c2warp');
  await editor.button('Open recent work').click();
  const works = page
    .getByRole('dialog', { name: 'Open recent work' })
    .getByRole('region', { name: 'Recent work' })
    .getByRole('listitem');
  await expect(works).toHaveText([/second\.png/, /disc\.png/]);
});
