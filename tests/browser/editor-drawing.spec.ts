/** Drawings: an SVG is opened, bent, exported as SVG like the command does, and is still a drawing after a reload. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';

const DRAWING = readFileSync(fileURLToPath(new URL('../drawings/features.svg', import.meta.url)), 'utf8')
  .replace('</svg>', '<script>parent.stopped = true</script><text x="9" y="9">A title</text></svg>')
  .replace('width="240" height="240">', '>');

const handle = (id: string, rest: readonly number[], posed: readonly number[]) => ({
  id,
  kind: 'point',
  rest,
  posed,
});
const PROJECT = {
  format: 'c2warp/1',
  image: { src: 'house.svg', width: 1024, height: 1024 },
  domain: { kind: 'image' },
  samples: 2000,
  handles: [
    handle('a', [150, 150], [230, 120]),
    handle('b', [850, 200], [800, 330]),
    handle('c', [512, 850], [500, 800]),
  ],
};

/** The numbers of all paths, in their order. */
const numbers = (svg: string): number[] =>
  [...svg.matchAll(/ d="([^"]*)"/g)].flatMap(([, data = '']) => data.match(/-?[\d.]+/g) ?? []).map(Number);

let binary: string;

test.beforeAll(() => {
  binary = builtCommand();
});

function byCommand(): string {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-drawing-'));
  try {
    writeFileSync(join(folder, 'house.svg'), DRAWING.replace(/<text.*<\/text>/, ''));
    writeFileSync(join(folder, 'project.json'), JSON.stringify(PROJECT));
    const args = ['warp', 'project.json', '-o', 'bent.svg'];
    const { status, stderr } = spawnSync(binary, args, { cwd: folder, encoding: 'utf8' });
    expect(status, stderr).toBe(0);
    return readFileSync(join(folder, 'bent.svg'), 'utf8');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a drawing is exported as SVG, as the command bends it, also after a reload', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.chooseFile({ name: 'house.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(DRAWING) });
  await expect(editor.status).toContainText('1024 × 1024 px');
  await expect(page.getByText('not opened')).toBeHidden();
  const project = Buffer.from(JSON.stringify(PROJECT));
  await editor.chooseFile({ name: 'house.c2warp.json', mimeType: 'application/json', buffer: project });
  await expect(editor.handles).toHaveCount(3);
  await expect(editor.solved).toContainText('2,024 mesh points');
  expect(await page.evaluate(() => 'stopped' in window)).toBe(false);

  const panel = page.getByRole('dialog', { name: 'Export' });
  const exported = async () => {
    await editor.button('Export as …').click();
    await panel.getByRole('button', { name: 'SVG', exact: true }).click();
    const started = page.waitForEvent('download');
    await panel.getByRole('button', { name: 'Export SVG' }).click();
    const download = await started;
    expect(download.suggestedFilename()).toBe('house-warped.svg');
    return (await bytes(download)).toString();
  };
  const svg = await exported();
  await expect(page.getByText(/Saved as house-warped\.svg.*Scripts are left out\..*A title/)).toBeVisible();
  const [ours, theirs] = [numbers(svg), numbers(byCommand())];
  expect(ours.length).toBe(theirs.length);
  expect(Math.max(...ours.map((value, at) => Math.abs(value - (theirs[at] ?? Number.NaN))))).toBeLessThan(
    0.05,
  );

  await page.reload();
  await expect(editor.status).toContainText('1024 × 1024 px');
  await expect(editor.solved).toContainText('2,024 mesh points');
  expect(await exported()).toBe(svg);
});

test('a drawing that is damaged or has no size is refused', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [text, told] of [
    ['<svg xmlns="http://www.w3.org/2000/svg"/>', 'The drawing has no size'],
    ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><g></svg>', 'The drawing is damaged'],
  ] as const) {
    await editor.chooseFile({ name: 'bad.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(text) });
    await expect(editor.notice).toContainText(`bad.svg: ${told}`);
  }
});
