/** Exports for web pages: the rig of the editor beside that of the command, and the code in a page beside it. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inflateRawSync } from 'node:zlib';
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import type { C2WarpPlayer } from '../../web/src/player';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';
import { wave } from './wave';

const SAMPLE = fileURLToPath(new URL('../../web/public/samples/gingerbread.png', import.meta.url));

const WAVE = wave(0.5);

const panel = (page: Page) => page.getByRole('dialog', { name: 'Export' });
const code = (page: Page) => panel(page).getByRole('textbox', { name: 'Code' });
const copyCode = (page: Page) => panel(page).getByRole('button', { name: 'Copy code' });
const exportRig = (page: Page) => panel(page).getByRole('button', { name: 'Export rig' });

/** Opens the sample with a clip, and the panel's page. */
async function opened(page: Page, clip: object = WAVE): Promise<Editor> {
  await page.route('**/samples/gingerbread.c2warp.json', async (route) => {
    const json = await (await route.fetch()).json();
    await route.fulfill({ json: { ...json, samples: 1500, clips: [clip] } });
  });
  const editor = await Editor.open(page);
  await editor.button('Export as …').click();
  await panel(page).getByRole('button', { name: 'Web page', exact: true }).click();
  await expect(code(page)).toBeVisible();
  return editor;
}

/** The sections of a rig by their tags. */
function sections(file: Buffer): [string, Buffer][] {
  const count = file.readUInt32LE(20);
  let at = 24 + 12 * count;
  return Array.from({ length: count }, (_, row) => {
    const start = 24 + 12 * row;
    const stored = file.subarray(at, at + file.readUInt32LE(start + 4));
    at += stored.length;
    const isPacked = stored.length !== file.readUInt32LE(start + 8);
    return [file.toString('latin1', start, start + 4), isPacked ? inflateRawSync(stored) : stored];
  });
}

async function exported(page: Page): Promise<Buffer> {
  const started = page.waitForEvent('download');
  await exportRig(page).click();
  await expect(panel(page)).toBeHidden();
  const download = await started;
  expect(download.suggestedFilename()).toBe('gingerbread.c2rig');
  await expect(page.getByText('Saved as gingerbread.c2rig.')).toBeVisible();
  return bytes(download);
}

test('the rig of the editor is that of the command, with the original picture', async ({ page }) => {
  const editor = await opened(page);
  const axe = await new AxeBuilder({ page }).include('c2-warp').analyze();
  expect(axe.violations).toEqual([]);
  const file = await exported(page);
  const project = await page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-rig-'));
  try {
    writeFileSync(join(folder, 'scene.c2warp.json'), JSON.stringify(project));
    const args = ['bake', 'scene.c2warp.json', '--image', SAMPLE, '-o', 'scene.c2rig'];
    expect(spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' }).stderr).toBe('');
    const [own, wanted] = [file, readFileSync(join(folder, 'scene.c2rig'))].map(sections);
    const picture = own?.find(([tag]) => tag === 'PICT')?.[1];
    expect(picture?.equals(readFileSync(SAMPLE))).toBe(true);
    const others = (list?: [string, Buffer][]) =>
      list?.filter(([tag]) => tag !== 'PICT').map(([tag, data]) => [tag, data.toString('base64')]);
    expect(others(own)).toEqual(others(wanted));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  await expect(editor.button('Export as …')).toBeEnabled();
});

test('the copied code plays in a page beside the file', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await opened(page);
  await copyCode(page).click();
  await expect(page.getByText('Copied. Put gingerbread.c2rig')).toBeVisible();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(await code(page).inputValue());
  expect(copied.trim().split('\n')).toHaveLength(2);
  const file = await exported(page);

  await page.route('**/beside/**', async (route) => {
    const name = new URL(route.request().url()).pathname.replace('/beside/', '');
    if (name === 'page.html') await route.fulfill({ contentType: 'text/html', body: copied });
    else if (name === 'gingerbread.c2rig') await route.fulfill({ body: file });
    else await route.fulfill({ response: await route.fetch({ url: new URL(`/${name}`, page.url()).href }) });
  });
  // With reduced motion it would not play by itself.
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await page.goto('/beside/page.html');
  const player = page.locator('c2-warp-player');
  await expect
    .poll(() => player.evaluate((element) => (element as C2WarpPlayer).currentTime))
    .toBeGreaterThan(0);
  const { clips, loop, alt, error } = await player.evaluate((element) => {
    const { clips, loop, alt, error } = element as C2WarpPlayer;
    return { clips, loop, alt, error };
  });
  expect({ clips, loop, alt, error }).toEqual({
    clips: ['wave'],
    loop: true,
    alt: 'gingerbread',
    error: null,
  });
  const box = await player.boundingBox();
  expect((box?.height ?? 0) / (box?.width ?? 1)).toBeCloseTo(1280 / 1024, 2);
});

test('where the clipboard is blocked, the code is selected to be copied by hand', async ({ page }) => {
  await page.addInitScript(() => {
    Clipboard.prototype.writeText = () => Promise.reject(new DOMException('blocked', 'NotAllowedError'));
  });
  await opened(page);
  await copyCode(page).click();
  await expect(page.getByText('The browser blocked the clipboard.')).toBeVisible();
  await expect(code(page)).toBeFocused();
  const selected = await code(page).evaluate((field) => {
    const { value, selectionStart, selectionEnd } = field as HTMLTextAreaElement;
    return value.slice(selectionStart, selectionEnd) === value;
  });
  expect(selected).toBe(true);
});

test('a bake can be cancelled, and another one follows', async ({ page }) => {
  const editor = await opened(page, { ...WAVE, duration: 60 });
  await exportRig(page).click();
  await expect(editor.solved).toContainText('Exporting');
  await editor.button('Cancel').click();
  await expect(page.getByText('Export cancelled')).toBeAttached();
  await expect(editor.solved).toContainText('mesh point');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const [clip] = warp.project.clips ?? [];
    warp.project = { ...warp.project, clips: clip ? [{ ...clip, duration: 0.5 }] : [] };
  });
  await page.getByRole('button', { name: 'Export as …' }).click();
  expect((await exported(page)).length).toBeGreaterThan(100_000);
});

test('a clip that is too long for a rig is named', async ({ page }) => {
  await opened(page, { ...WAVE, duration: 700 });
  await exportRig(page).click();
  await expect(page.getByRole('alert')).toContainText(
    'Clip "wave" lasts 700 s: a clip of a rig can last up to 600 s.',
  );
});
