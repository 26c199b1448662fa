/** Rigs for game engines from the export panel, beside those of the command. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import { unzipSync } from 'fflate';
import type { C2Warp } from '../../web/src/element';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';
import { wave } from './wave';

const SAMPLE = fileURLToPath(new URL('../../web/public/samples/gingerbread.png', import.meta.url));
const OPTIONS = { Bones: 24, Vertices: 200, 'Bones per vertex': 3 } as const;

const panel = (page: Page) => page.getByRole('dialog', { name: 'Export' });
const press = (page: Page, name: string) => panel(page).getByRole('button', { name, exact: true }).click();
const field = (page: Page, name: string) => panel(page).getByRole('spinbutton', { name: `${name} (` });

let folder: string;

test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'c2warp-engine-'));
});

test.afterAll(() => {
  rmSync(folder, { recursive: true });
});

/** Opens the sample with a clip, and the panel's page. */
async function opened(page: Page): Promise<Editor> {
  await page.route('**/samples/gingerbread.c2warp.json', async (route) => {
    const json = await (await route.fetch()).json();
    await route.fulfill({ json: { ...json, samples: 1500, clips: [wave(0.5)] } });
  });
  const editor = await Editor.open(page);
  await showPanel(editor, page);
  await press(page, 'Engine');
  await expect(field(page, 'Bones')).toHaveValue('64');
  return editor;
}

async function showPanel(editor: Editor, page: Page): Promise<void> {
  await editor.button('Export as …').click();
  await expect(panel(page)).toBeVisible();
}

async function fill(page: Page, values: Readonly<Record<string, number>>): Promise<void> {
  for (const [name, value] of Object.entries(values)) {
    await field(page, name).fill(String(value));
    await field(page, name).press('Enter');
    await expect(field(page, name)).toHaveValue(String(value));
  }
}

/** Runs the command on the project of the page. Returns what it prints. */
async function command(page: Page, output: string): Promise<string> {
  const project = await page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);
  writeFileSync(join(folder, 'scene.c2warp.json'), JSON.stringify(project));
  const [bones, vertices, influences] = Object.values(OPTIONS).map(String) as [string, string, string];
  const options = ['--bones', bones, '--vertices', vertices, '--influences', influences];
  const args = ['export', 'scene.c2warp.json', '--image', SAMPLE, '-o', output, ...options];
  const { status, stdout, stderr } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
  expect(status, stderr).toBe(0);
  return stdout;
}

const written = (name: string) => readFileSync(join(folder, name));

/** The printed errors: those of 99 % and the largest, as the panel rounds them. */
const printed = (report: string) =>
  report
    .split('\n')
    .filter((line) => /^(vertices, |between)/.test(line))
    .map((line) => line.trim().split(/\s+/).slice(-3).map(Number))
    .map(([largest, percentile]) => [percentile, largest]);

test('rigs of the editor are those of the command, and it tells their loss', async ({ page }) => {
  const editor = await opened(page);
  await fill(page, OPTIONS);
  await press(page, 'Zip');
  const axe = await new AxeBuilder({ page }).include('c2-warp').analyze();
  expect(axe.violations).toEqual([]);

  const zipping = page.waitForEvent('download');
  await press(page, 'Export rig');
  await expect(panel(page)).toBeHidden();
  const zip = await zipping;
  expect(zip.suggestedFilename()).toBe('gingerbread-spine.zip');
  const loss = /Saved as gingerbread-spine\.zip\. 99 % of vertices are within \d+\.\d\d px/;
  await expect(page.getByText(loss)).toBeVisible();
  const report = await command(page, 'gingerbread.spine.json');
  const files = unzipSync(await bytes(zip));
  expect(Object.keys(files)).toEqual(['gingerbread.spine.json', 'gingerbread.atlas', 'gingerbread.png']);
  for (const name of ['gingerbread.spine.json', 'gingerbread.atlas'])
    expect(written(name).equals(files[name] ?? new Uint8Array()), name).toBe(true);
  const [own, wanted] = [files['gingerbread.png'] ?? new Uint8Array(), written('gingerbread.png')].map(
    (png) => Buffer.from(decode(png).data.buffer),
  );
  expect(own?.equals(wanted ?? Buffer.of())).toBe(true);

  await showPanel(editor, page);
  await expect(
    panel(page).getByText(/The last rig uses 24 bones for \d+ handles and helper points/),
  ).toBeVisible();
  const rows = panel(page).getByRole('row');
  await expect(rows).toHaveText([/99 %\s+Largest/, /Pose/, /Random poses/, /Clip wave/, /Between vertices/]);
  const shown = (await rows.allInnerTexts()).slice(1).map((row) => row.match(/[\d.]+/g)?.map(Number));
  for (const [k, errors] of printed(report).entries())
    for (const [at, error] of errors.entries())
      expect(Math.abs((shown[k]?.[at] ?? Number.NaN) - (error ?? 0))).toBeLessThan(0.0101);

  await press(page, 'glTF');
  await expect(panel(page).getByRole('button', { name: 'Folder' })).toBeHidden();
  const saving = page.waitForEvent('download');
  await press(page, 'Export rig');
  const glb = await saving;
  expect(glb.suggestedFilename()).toBe('gingerbread.glb');
  await command(page, 'gingerbread.glb');
  expect(written('gingerbread.glb').equals(await bytes(glb))).toBe(true);
});

test('files go into a picked folder, and choices stay for the next rig', async ({ page }) => {
  // The folder of the page instead of one on the disk.
  await page.addInitScript(() => {
    const picked = async () =>
      (await navigator.storage.getDirectory()).getDirectoryHandle('rigs', { create: true });
    Object.assign(globalThis, { showDirectoryPicker: picked });
  });
  const editor = await opened(page);
  await press(page, 'Godot');
  await fill(page, { Bones: 8, Vertices: 60 });
  await press(page, 'Folder');
  await press(page, 'Export rig');
  await expect(page.getByText('Saved as rigs. 99 % of vertices')).toBeVisible();
  const files = await page.evaluate(async () => {
    const folder = await (await navigator.storage.getDirectory()).getDirectoryHandle('rigs');
    const sizes: Record<string, number> = {};
    for await (const [name, handle] of folder as unknown as AsyncIterable<[string, FileSystemFileHandle]>)
      sizes[name] = (await handle.getFile()).size;
    return sizes;
  });
  expect(Object.keys(files).toSorted()).toEqual(['gingerbread.png', 'gingerbread.tscn']);
  expect(Math.min(...Object.values(files))).toBeGreaterThan(1000);
  await showPanel(editor, page);
  await expect(field(page, 'Bones')).toHaveValue('8');
  await expect(panel(page).getByRole('button', { name: 'Godot', pressed: true })).toBeVisible();
});

test('too few vertices are named, and an export can be cancelled', async ({ page }) => {
  const editor = await opened(page);
  await fill(page, { Vertices: 3 });
  await press(page, 'Zip');
  await press(page, 'Export rig');
  await expect(page.getByRole('alert')).toContainText(
    /The outline alone needs \d+ vertices, but only 3 are allowed\./,
  );
  await showPanel(editor, page);
  await fill(page, { Vertices: 3000, Bones: 200 });
  await press(page, 'Export rig');
  await expect(editor.solved).toContainText('Exporting');
  await page.keyboard.press('Escape');
  await expect(page.getByText('Export cancelled')).toBeAttached();
  await expect(editor.solved).toContainText('mesh point');
});
