/** The feather of a lasso: a soft rim on the screen and in exports, and nothing of it at rest. */
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { Project } from '../../web/src/document/project';
import { builtCommand } from './command';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { difference } from './images';
import { loadPortrait, PORTRAIT, PORTRAIT_IMAGE, ringAround } from './portrait';

const [X, Y] = [PORTRAIT_IMAGE.width / 2, PORTRAIT_IMAGE.height * 0.35];
const RING = ringAround([X, Y]);

const project = (feather: number, by: number, filled: boolean): Project => ({
  format: 'c2warp/1',
  image: PORTRAIT_IMAGE,
  domain: { kind: 'polygon', rings: [RING], feather },
  ...(filled && { fill: { method: 'patches', seed: 5 } }),
  handles: [{ id: 'face', kind: 'point', rest: [X, Y], posed: [X + by, Y + by / 3] }],
});

/** Projects as both renderers draw them, at a scale. */
const drawn = (page: Page, projects: readonly Project[], scale: number) =>
  page.evaluate(
    async ([projects, scale]) => {
      const file = await (await fetch('/samples/portrait.png')).blob();
      const drawn = [];
      for (const project of projects) drawn.push(await harness.drawnTwice(project, file, scale));
      return drawn;
    },
    [projects, scale] as const,
  );

test.describe('in both renderers', () => {
  test.beforeEach(async ({ page }) => {
    await page.goto('/harness/');
  });

  for (const filled of [false, true]) {
    const behind = filled ? 'over a fill' : 'over a gap';

    test(`a moved part has the same soft rim on screen and in exports, ${behind}`, async ({ page }, info) => {
      const [soft, sharp] = await drawn(page, [project(24, 60, filled), project(0, 60, filled)], 1);
      if (!soft || !sharp) throw new Error('two pictures');
      const { mean, close } = await difference(soft.webgl, soft.cpu, info);
      expect(mean).toBeLessThanOrEqual(1);
      expect(close).toBeGreaterThanOrEqual(0.99);
      expect(soft.webgl).not.toBe(sharp.webgl);
      expect(soft.cpu).not.toBe(sharp.cpu);
    });

    test(`a part at rest is drawn as without a feather, to the bit, ${behind}`, async ({ page }) => {
      const [soft, sharp] = await drawn(page, [project(24, 0, filled), project(0, 0, filled)], 1.3);
      expect(soft?.webgl).toBe(sharp?.webgl);
      expect(soft?.cpu).toBe(sharp?.cpu);
    });
  }

  test('the page draws the same bytes as the command', async ({ page }) => {
    const folder = mkdtempSync(join(tmpdir(), 'c2warp-feather-'));
    try {
      copyFileSync(PORTRAIT, join(folder, 'portrait.png'));
      writeFileSync(join(folder, 'project.json'), JSON.stringify(project(17.5, 60, false)));
      const args = ['warp', 'project.json', '-o', 'out.png'];
      const { status, stderr } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
      expect(`${stderr}${status}`).toBe('0');
      const [{ cpu } = { cpu: '' }] = await drawn(page, [project(17.5, 60, false)], 1);
      const command = decode(readFileSync(join(folder, 'out.png')));
      expect(Buffer.from(command.data).equals(Buffer.from(decode(Buffer.from(cpu, 'base64')).data))).toBe(
        true,
      );
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
});

test('a feather is typed after a lasso, softens the moved part, and is one step', async ({ page }) => {
  const editor = await Editor.open(page);
  await loadPortrait(page);
  await page.keyboard.press('l');
  await editor.dragAlong(RING);
  const featherOf = () =>
    page.evaluate(() => {
      const domain = document.querySelector('c2-warp')?.project.domain;
      return domain?.kind === 'polygon' ? (domain.feather ?? 0) : null;
    });
  await expect.poll(featherOf).toBe(0);
  await page.keyboard.press('v');
  await page.keyboard.press('Escape');
  // The exported bytes, with a handle that has moved by so much.
  const exported = (by: number) =>
    page.evaluate(
      async ([x, y, by]) => {
        const element = document.querySelector('c2-warp');
        if (!element) return '';
        const handles = [{ id: 'face', kind: 'point', rest: [x, y], posed: [x + by, y] }] as const;
        element.project = { ...element.project, handles };
        const bytes = await (await element.toBlob()).arrayBuffer();
        const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
        return Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join('');
      },
      [X, Y, by] as const,
    );
  const [sharpAtRest, sharp] = [await exported(0), await exported(50)];
  const field = page.getByRole('spinbutton', { name: 'Feather (px)' });
  await field.fill('12');
  await field.press('Enter');
  await expect.poll(featherOf).toBe(12);
  await field.press('ArrowUp');
  await expect.poll(featherOf).toBe(13);
  expect(await exported(0)).toBe(sharpAtRest);
  expect(await exported(50)).not.toBe(sharp);
  await field.fill('65');
  await field.press('Enter');
  await expect(page.getByText('Feather: enter a number from 0 to 64.').first()).toBeVisible();
  await expect.poll(featherOf).toBe(13);
});
