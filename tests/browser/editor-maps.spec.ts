/** Maps and weights from the export panel, beside those of the command. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Download, Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import type { C2Warp } from '../../web/src/element';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';
import { wave } from './wave';

const SAMPLE = fileURLToPath(new URL('../../web/public/samples/gingerbread.png', import.meta.url));

const panel = (page: Page) => page.getByRole('dialog', { name: 'Export' });
const press = (page: Page, name: string) => panel(page).getByRole('button', { name, exact: true }).click();

let folder: string;
let binary: string;

test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'c2warp-maps-'));
  binary = builtCommand();
});

test.afterAll(() => {
  rmSync(folder, { recursive: true });
});

/** Exports by the choices in the panel. */
async function exported(editor: Editor, page: Page, choices: readonly string[]): Promise<Download> {
  if (await panel(page).isHidden()) await editor.button('Export as …').click();
  for (const choice of choices) await press(page, choice);
  const saving = page.waitForEvent('download');
  await panel(page)
    .getByRole('button', { name: /^Export / })
    .click();
  await expect(panel(page)).toBeHidden();
  const download = await saving;
  await expect(page.getByText(`Saved as ${download.suggestedFilename()}.`)).toBeVisible();
  return download;
}

/** Runs the command on the project of the page. */
async function command(page: Page, name: string, ...options: readonly string[]): Promise<void> {
  const project = await page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);
  writeFileSync(join(folder, 'scene.c2warp.json'), JSON.stringify(project));
  const args = [name, 'scene.c2warp.json', '--image', SAMPLE, ...options];
  const { status, stderr } = spawnSync(binary, args, { cwd: folder, encoding: 'utf8' });
  expect(status, stderr).toBe(0);
}

/** Whether a file of the command has these bytes. */
const isWritten = (name: string, file: Uint8Array | undefined): boolean =>
  file !== undefined && readFileSync(join(folder, name)).equals(file);

test('maps and weights are those of the command, at the playhead', async ({ page }) => {
  await page.route('**/samples/gingerbread.c2warp.json', async (route) => {
    const json = await (await route.fetch()).json();
    await route.fulfill({ json: { ...json, samples: 1500, clips: [wave(0.5)] } });
  });
  const editor = await Editor.open(page);
  await page.keyboard.press('t');
  const playhead = page.getByRole('region', { name: 'Timeline' }).getByRole('slider', { name: 'Playhead' });
  await playhead.focus();
  for (let frame = 1; frame <= 3; frame++) await page.keyboard.press('ArrowRight');
  await expect(playhead).toHaveAttribute('aria-valuenow', '0.1');
  const moment = ['--clip', 'wave', '--at', '0.1'];

  await editor.button('Export as …').click();
  await press(page, 'Maps');
  await expect(panel(page).getByText('gingerbread-inverse.exr')).toBeVisible();
  const inverse = await bytes(await exported(editor, page, ['Inverse', 'EXR']));
  await command(page, 'maps', ...moment, '--inverse', 'inverse.exr');
  expect(isWritten('inverse.exr', inverse)).toBe(true);

  const stretch = await exported(editor, page, ['Stretch', 'PNG', 'Expanded']);
  expect(stretch.suggestedFilename()).toBe('gingerbread-stretch.png');
  await command(page, 'maps', ...moment, '--grow', '--stretch', 'stretch.png');
  expect(isWritten('stretch.png', await bytes(stretch))).toBe(true);

  await editor.button('Export as …').click();
  await press(page, 'Heat map');
  await expect(panel(page).getByText('Select one handle first')).toBeVisible();
  await expect(panel(page).getByRole('button', { name: 'Export map' })).toBeDisabled();
  await page.keyboard.press('Escape');
  await editor.handle('head').click();
  const heat = await exported(editor, page, ['Heat map']);
  expect(heat.suggestedFilename()).toBe('gingerbread-heat-head.png');
  await command(page, 'weights', '--handle', 'head', '-o', 'heat.png');
  expect(isWritten('heat.png', await bytes(heat))).toBe(true);

  const files = unzipSync(await bytes(await exported(editor, page, ['Weights'])));
  expect(Object.keys(files)).toEqual(['weights.npy', 'sites.csv']);
  await command(page, 'weights', '--every', '8', '-o', 'weights.npy', '--sites', 'sites.csv');
  expect(isWritten('weights.npy', files['weights.npy'])).toBe(true);
  expect(isWritten('sites.csv', files['sites.csv'])).toBe(true);
  const table = await exported(editor, page, ['Weights', 'Selected handle', 'CSV']);
  expect(table.suggestedFilename()).toBe('gingerbread-weights-head.csv');
  await command(page, 'weights', '--every', '8', '--handle', 'head', '-o', 'head.csv');
  expect(isWritten('head.csv', await bytes(table))).toBe(true);

  await editor.button('Export as …').click();
  await press(page, 'Forward');
  await panel(page).getByRole('button', { name: 'Export map' }).click();
  await expect(editor.solved).toContainText('Exporting');
  await page.keyboard.press('Escape');
  await expect(page.getByText('Export cancelled')).toBeAttached();
  await expect(editor.solved).toContainText('mesh point');
});
