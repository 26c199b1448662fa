/** Unsaved changes, recent work, and the work of two tabs. */
import type { Page } from '@playwright/test';
import { Editor } from './editor';
import { bring, disc, png, project } from './files';
import { expect, test } from './fixtures';

const title = (page: Page) => page.locator('c2-warp .title');
const menu = (page: Page) =>
  page.getByRole('dialog', { name: 'Open recent work' }).getByRole('region', { name: 'Recent work' });

/** The names of the recent works in storage, oldest first. */
const storedRecent = (page: Page) =>
  page.evaluate(async () => {
    const answer = <T>(request: IDBRequest<T>) =>
      new Promise<T>((done) => request.addEventListener('success', () => done(request.result)));
    const database = await answer(indexedDB.open('c2warp'));
    const range = IDBKeyRange.bound('editor/recent/', 'editor/recent/~');
    const works = await answer(database.transaction('kept').objectStore('kept').getAll(range));
    database.close();
    return works.sort((a, b) => a.kept - b.kept).map(({ name }) => name);
  });

test('an edit marks the title as unsaved until a file holds it', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect(page).toHaveTitle('gingerbread.png – c2warp');
  await expect(title(page)).toHaveText('gingerbread.png');
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await expect(title(page)).toContainText('Unsaved, kept in this browser');
  await expect(page).toHaveTitle('• gingerbread.png – c2warp');
  // Undo returns to the saved project.
  await page.keyboard.press('Control+z');
  await expect(title(page)).toHaveText('gingerbread.png');
  await page.keyboard.press('Control+y');
  await expect(title(page)).toContainText('Unsaved, kept in this browser');
  await page.reload();
  await expect(page).toHaveTitle('• gingerbread.png – c2warp');
  await editor.ready();
  await editor.download('Save the project file');
  await expect(page).toHaveTitle('gingerbread.png – c2warp');
  await expect(title(page)).toHaveText('gingerbread.png');
  await expect.poll(async () => (await editor.storedWork()).saved).toBe(true);
  await page.reload();
  await editor.ready();
  await expect(page).toHaveTitle('gingerbread.png – c2warp');
  await page.keyboard.press('Control+z');
  await expect(page).toHaveTitle('• gingerbread.png – c2warp');
});

test('work that the browser cannot keep is only called unsaved', async ({ page }) => {
  await page.addInitScript(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('no room', 'QuotaExceededError');
    };
  });
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await expect(editor.notice).toContainText('This browser cannot store your work');
  await expect(title(page)).toHaveText(/^\s*gingerbread.png\s*Unsaved\s*$/);
});

test('a project from a file counts as saved', async ({ page }) => {
  const editor = await Editor.open(page);
  const handles = [{ id: 'middle', kind: 'point', rest: [32, 32], posed: [36, 30] }];
  const image = { src: 'disc.png', width: 64, height: 64 };
  await bring(editor, 'drop', png('disc.png', disc(64)), project({ format: 'c2warp/1', image, handles }));
  await expect(editor.handle('middle')).toBeVisible();
  await expect(page).toHaveTitle('disc.png – c2warp');
  await bring(editor, 'drop', project({ format: 'c2warp/1', image, handles: [] }));
  await expect(editor.handles).toHaveCount(0);
  await expect(page).toHaveTitle('disc.png – c2warp');
});

test('recent work is listed with thumbnails, and reopens after a reload', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  for (const name of ['one.png', 'two.png', 'three.png']) {
    await bring(editor, 'drop', png(name, disc(64)));
    await expect(page).toHaveTitle(`${name} – c2warp`);
    await page.locator('c2-warp .stage').focus();
    await page.keyboard.press('Enter');
    await expect(editor.handles).toHaveCount(1);
  }
  await expect.poll(() => storedRecent(page)).toEqual(['gingerbread.png', 'one.png', 'two.png']);
  await expect.poll(() => editor.storedWork()).toMatchObject({ picture: 'three.png', step: 'Add handle' });
  await page.reload();
  await expect(page).toHaveTitle('• three.png – c2warp');
  await editor.button('Open recent work').click();
  const works = menu(page).getByRole('listitem');
  await expect(works).toHaveText([/two\.png\s+1 step/, /one\.png\s+1 step/, /gingerbread\.png\s+1 step/]);
  const drawn = menu(page)
    .locator('img')
    .evaluateAll((images) => images.map((image) => (image as HTMLImageElement).naturalWidth));
  expect(await drawn).toEqual([64, 64, 77]);
  await menu(page).getByRole('button', { name: 'gingerbread.png' }).first().click();
  await expect(menu(page)).toBeHidden();
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await expect.poll(() => storedRecent(page)).toEqual(['one.png', 'two.png', 'three.png']);
});

test('recent work is removed, each and all, and can be put back', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await bring(editor, 'drop', png('disc.png', disc(64)));
  await expect(page).toHaveTitle('disc.png – c2warp');
  await page.locator('c2-warp .stage').focus();
  await page.keyboard.press('Enter');
  await bring(editor, 'drop', png('last.png', disc(64)));
  await expect.poll(() => storedRecent(page)).toEqual(['gingerbread.png', 'disc.png']);
  await editor.button('Open recent work').click();
  await menu(page).getByRole('button', { name: 'Remove disc.png from the list' }).click();
  await expect.poll(() => storedRecent(page)).toEqual(['gingerbread.png']);
  await page.keyboard.press('Escape');
  await editor.button('Restore').click();
  await expect.poll(async () => (await storedRecent(page)).sort()).toEqual(['disc.png', 'gingerbread.png']);
  await editor.button('Open recent work').click();
  await menu(page).getByRole('button', { name: 'Remove all' }).click();
  await expect(menu(page).getByRole('listitem')).toHaveCount(0);
  await expect.poll(() => storedRecent(page)).toEqual([]);
});

test('the offer to go back passes, and not while the pointer is on it', async ({ page }) => {
  await page.clock.install();
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await bring(editor, 'drop', png('disc.png', disc(64)));
  const back = editor.button('Back to gingerbread.png');
  await back.hover();
  await page.clock.runFor(60_000);
  await expect(back).toBeVisible();
  await page.mouse.move(5, 300);
  await page.clock.runFor(20_000);
  await expect(back).toBeHidden();
  await editor.openRecent('gingerbread.png');
  await expect(editor.handles).toHaveCount(5);
});

test('a notice covers no handle', async ({ page }) => {
  const editor = await Editor.open(page);
  const notice = page.locator('c2-warp .notice');
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await bring(editor, 'drop', png('disc.png', disc(64)));
  await editor.button('Back to gingerbread.png').click();
  await expect(editor.handles).toHaveCount(5);
  // The feet of the figure are at the bottom, where notices usually are.
  await bring(editor, 'drop', png('words.png', Buffer.from('words')));
  await expect(notice).toContainText('words.png');
  const card = await notice.boundingBox();
  if (!card) throw new Error('no notice');
  for (const handle of await editor.handles.all()) {
    const { x, y } = await editor.centre(handle);
    const apart = x < card.x || x > card.x + card.width || y < card.y || y > card.y + card.height;
    expect(apart).toBe(true);
  }
});

test('after edits in two tabs, a reload offers both versions', async ({ page }) => {
  const [first, second] = await Editor.openTwice(page);
  await first.dragHandle('head', { x: 10, y: -30 });
  const head = await first.settled(() => first.shownPose('head'));
  await expect.poll(() => first.storedWork()).toMatchObject({ step: 'Move head' });
  await expect(
    second.page.getByText('Another tab also changed this work. Both versions are kept'),
  ).toBeVisible();
  await second.dragHandle('right hand', { x: -20, y: -40 });
  const hand = await second.settled(() => second.shownPose('right hand'));
  await expect.poll(() => second.storedWork()).toMatchObject({ step: 'Move right hand' });

  await page.reload();
  const asked = page.getByText('gingerbread.png was changed in two tabs. This is the later version.');
  await expect(asked).toBeVisible();
  await expect.poll(() => first.shownPose('right hand')).toEqual(hand);
  await first.button('Show the other version').click();
  await expect.poll(() => first.shownPose('head')).toEqual(head);
  await expect(asked).toBeHidden();
  // The version that gave way is recent work.
  await first.openRecent('gingerbread.png');
  await expect.poll(() => first.shownPose('right hand')).toEqual(hand);
});

test('of two versions, the open one is kept, and the other stays in the list', async ({ page, context }) => {
  const first = await Editor.open(page);
  await expect.poll(() => first.storedWork()).toMatchObject({ picture: 'gingerbread.png' });
  const second = await Editor.open(await context.newPage());
  await first.dragHandle('head', { x: 10, y: -30 });
  const head = await first.settled(() => first.shownPose('head'));
  await expect.poll(() => first.storedWork()).toMatchObject({ step: 'Move head' });
  await second.dragHandle('right hand', { x: -20, y: -40 });
  await expect.poll(() => second.storedWork()).toMatchObject({ step: 'Move right hand' });
  await page.reload();
  await first.button('Keep this one').click();
  await expect.poll(() => storedRecent(page)).toEqual(['gingerbread.png']);
  await page.reload();
  await first.ready();
  await expect(page.getByText('was changed in two tabs')).toBeHidden();
  await first.openRecent('gingerbread.png');
  await expect.poll(() => first.shownPose('head')).toEqual(head);
});

test('a selection in one tab does not replace an edit of another', async ({ page, context }) => {
  const first = await Editor.open(page);
  await expect.poll(() => first.storedWork()).toMatchObject({ picture: 'gingerbread.png' });
  const second = await Editor.open(await context.newPage());
  await first.dragHandle('head', { x: 10, y: -30 });
  await expect.poll(() => first.storedWork()).toMatchObject({ step: 'Move head' });
  await second.handle('left hand').click();
  await expect(second.page.locator('c2-warp .title')).toHaveAttribute('title', /kept in this browser/);
  expect(await first.storedWork()).toMatchObject({ step: 'Move head', selection: ['head'] });
});
