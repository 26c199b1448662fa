/** Files that hold a picture together with its handles: exported PNGs and saved projects. */
import { spawnSync } from 'node:child_process';
import { decode } from 'fast-png';
import type { C2Warp } from '../../web/src/element';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { bring, disc, png, project } from './files';
import { expect, test } from './fixtures';

const WHOLE = { name: 'Open recent work' };

async function downloadWhole(editor: Editor, label: string) {
  await editor.button(WHOLE.name).click();
  return editor.download(label);
}

/** Numbers of handles that the command reads from a file. */
function readByCommand(file: Buffer): Record<string, number> {
  const { stdout, stderr } = spawnSync(builtCommand(), ['inspect', '-', '--json'], {
    input: file,
    encoding: 'utf8',
  });
  expect(stderr).toBe('');
  return JSON.parse(stdout);
}

test('an exported PNG that holds the original opens again as the rig', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 0, y: -80 });
  const told = await editor.settled(() => editor.shownPose('right hand'));
  const download = await downloadWhole(editor, 'Export an editable PNG');
  expect(download.suggestedFilename()).toBe('gingerbread-warped.png');
  const file = await bytes(download);
  const { width, height } = decode(file);
  expect([width, height]).toEqual([1024, 1280]);
  expect(readByCommand(file)).toMatchObject({ point_handles: 5, samples: 9889 });

  await bring(editor, 'drop', png('posted.png', file));
  await expect(page).toHaveTitle('gingerbread.png – c2warp');
  await expect(page.getByText('posted.png was not opened')).toBeHidden();
  await expect.poll(() => editor.shownPose('right hand')).toEqual(told);
  await editor.button('Reset all handles').click();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
  const alpha = decode(await bytes(await editor.exported())).data;
  expect(alpha[(560 * width + 900) * 4 + 3]).toBe(255);
});

test('any exported PNG names its picture, and continues with it', async ({ page }) => {
  const editor = await Editor.open(page);
  const original = await page.request.get('/samples/gingerbread.png');
  await editor.dragHandle('right hand', { x: 0, y: -80 });
  const told = await editor.settled(() => editor.shownPose('right hand'));
  const file = await bytes(await editor.exported());
  expect(file.length).toBeLessThan(3e6);
  await bring(editor, 'drop', png('posted.png', file));
  await expect(
    page.getByText('posted.png belongs to the picture gingerbread.png (1024 × 1280 px)'),
  ).toBeVisible();
  await expect(editor.handles).toHaveCount(0);
  await bring(editor, 'drop', png('gingerbread.png', await original.body()));
  await expect.poll(() => editor.shownPose('right hand')).toEqual(told);
});

test('a damaged project in a PNG is named, and the picture opens as one', async ({ page }) => {
  const editor = await Editor.open(page);
  const file = await bytes(await editor.exported());
  const at = file.indexOf('c2warp/1');
  file[at] = 'C'.charCodeAt(0);
  await bring(editor, 'drop', png('posted.png', file));
  await expect(
    page.getByText('posted.png opened without its project. The project in this picture is damaged.'),
  ).toBeVisible();
  await expect(page).toHaveTitle('posted.png – c2warp');
});

test('a project saved with its picture is one file that opens everywhere', async ({ page }) => {
  const editor = await Editor.open(page);
  await bring(editor, 'drop', png('my disc.png', disc(64)));
  await expect(editor.status).toContainText('64 × 64 px');
  await page
    .locator('c2-warp')
    .evaluate((element) =>
      (element as C2Warp).addHandle({ kind: 'point', id: 'middle', rest: [32, 32], posed: [40, 30] }),
    );
  await expect(page).toHaveTitle('• my disc.png – c2warp');
  const saved = await downloadWhole(editor, 'Save with the picture');
  expect(saved.suggestedFilename()).toBe('my disc.c2warp.json');
  await expect(page).toHaveTitle('my disc.png – c2warp');
  const file = await bytes(saved);
  expect(readByCommand(file)).toMatchObject({ point_handles: 1 });
  const text = file.toString();
  expect(JSON.parse(text).image.src).toMatch(/^data:image\/png;name=my%20disc\.png;base64,/);
  await bring(editor, 'drop', project(text, 'received.json'));
  await expect.poll(() => editor.shownPose('middle')).toMatchObject({ x: 40, y: 30 });
  // The history does not repeat the picture.
  const src = await page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.image.src);
  expect(src).toBe('my disc.png');
});
