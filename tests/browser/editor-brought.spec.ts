/** What people bring to the editor: several files at once, projects whose pictures come later, addresses. */
import { mkdir, writeFile } from 'node:fs/promises';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { bring, disc, png, project } from './files';
import { expect, test } from './fixtures';

const note = { name: 'note.txt', mimeType: 'text/plain', buffer: Buffer.from('words') };

/** A project with one handle, for a picture of 64 × 64 px. */
const posed = (id: string, src: string) => ({
  format: 'c2warp/1',
  image: { src, width: 64, height: 64 },
  handles: [{ id, kind: 'point', rest: [32, 32], posed: [36, 30] }],
});

test('a drop opens its first picture, and a notice names the other files', async ({ page }) => {
  const editor = await Editor.open(page);
  const unknown = { name: '.hidden', mimeType: '', buffer: Buffer.from('nothing') };
  await bring(
    editor,
    'drop',
    note,
    unknown,
    png('damaged.png', disc(64).subarray(0, 90)),
    png('disc.png', disc(64)),
  );
  await expect(editor.status).toContainText('64 × 64 px');
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
  await expect(page.getByText('note.txt and 2 more were not opened')).toBeVisible();
  await expect(editor.notice).toBeHidden();
});

for (const name of ['holiday', 'old.c2warp.json']) {
  test(`a folder ${name} dropped before a picture is named, and the picture opens`, async ({ page }) => {
    const editor = await Editor.open(page);
    const [folder, picture] = [test.info().outputPath(name), test.info().outputPath('disc.png')];
    await mkdir(folder, { recursive: true });
    await writeFile(picture, disc(64));
    const devtools = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder, picture], dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await devtools.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
    await expect(editor.status).toContainText('64 × 64 px');
    await expect(page.getByText(`${name} was not opened`)).toBeVisible();
    await expect(editor.handles).toHaveCount(0);
  });
}

test('a waiting project is taken by its own picture alone', async ({ page }) => {
  const editor = await Editor.open(page);
  const asks = page.getByText('belongs to the picture a.png (64 × 64 px)');
  const open = async (...files: readonly ReturnType<typeof png>[]) => {
    await bring(editor, 'drop', ...files);
    const picture = files.find(({ mimeType }) => mimeType === 'image/png')?.name ?? '';
    await expect(page.getByText(picture, { exact: true })).toBeVisible();
    await expect(editor.solved).toContainText('64 × 64 px');
  };
  await bring(editor, 'drop', project(posed('first', 'a.png'), 'a.c2warp.json'));
  await expect(asks).toBeVisible();
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).load('/samples/gingerbread.png'));
  await expect(editor.solved).toContainText('1024 × 1280 px');
  await expect(asks).toBeVisible();
  await open(png('b.png', disc(64)));
  await expect(editor.handles).toHaveCount(0);
  await expect(asks).toBeVisible();
  // Another project comes with the picture that was asked for.
  await open(project(posed('second', 'a.png'), 'other.json'), png('a.png', disc(64)));
  await expect(editor.handle('second')).toBeVisible();
  await expect(asks).toBeHidden();
  await open(png('a.png', disc(64)));
  await expect(editor.handles).toHaveCount(0);
});

test('a newer offer closes an older error', async ({ page }) => {
  const editor = await Editor.open(page);
  await bring(editor, 'drop', project('{}', 'other.json'));
  await expect(editor.notice).toContainText('format: missing');
  await bring(editor, 'drop', project(posed('first', 'a.png'), 'a.c2warp.json'));
  await expect(editor.button('Open picture')).toBeVisible();
  await expect(editor.notice).toBeHidden();
});
