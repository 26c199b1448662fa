/** The filled background behind a lasso: on the screen, in exports, and the same by the command. */
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decode } from 'fast-png';
import type { Project } from '../../web/src/document/project';
import { builtCommand } from './command';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { difference } from './images';
import { loadPortrait, PORTRAIT, PORTRAIT_IMAGE, ringAround } from './portrait';

const [X, Y] = [PORTRAIT_IMAGE.width / 2, PORTRAIT_IMAGE.height * 0.4];
const RING = ringAround([X, Y]);

const project = (by: number): Project => ({
  format: 'c2warp/1',
  image: PORTRAIT_IMAGE,
  domain: { kind: 'polygon', rings: [RING] },
  fill: { method: 'patches', seed: 5 },
  handles: [{ id: 'face', kind: 'point', rest: [X, Y], posed: [X + by, Y] }],
});

for (const by of [0, 0.4, 70]) {
  test(`screen and export agree on a part that moved by ${by} pixels`, async ({ page }, info) => {
    await page.goto('/harness/');
    const { webgl, cpu } = await page.evaluate(async (project) => {
      const file = await (await fetch('/samples/portrait.png')).blob();
      return harness.drawnTwice(project, file, 1);
    }, project(by));
    const { mean, close } = await difference(webgl, cpu, info);
    expect(mean).toBeLessThanOrEqual(1);
    expect(close).toBeGreaterThanOrEqual(0.99);
    const [screen, exported] = [webgl, cpu].map((file) => decode(Buffer.from(file, 'base64')).data);
    // No crack and no gap: everything is opaque.
    for (const rgba of [screen, exported]) {
      expect(rgba?.every((value, at) => at % 4 !== 3 || value === 255)).toBe(true);
    }
    if (by !== 0) return;
    const original = decode(readFileSync(PORTRAIT));
    const channels = original.channels;
    // The greatest change of a colour.
    const change = (rgba: ArrayLike<number> = []): number => {
      let most = 0;
      for (let at = 0; at < rgba.length; at++) {
        const before = original.data[Math.floor(at / 4) * channels + (at % 4)] ?? 255;
        if (at % 4 !== 3) most = Math.max(most, Math.abs((rgba[at] ?? 0) - before));
      }
      return most;
    };
    expect(change(exported)).toBe(0);
    // Graphics cards round corners of triangles, to 1/256 of a pixel at best. Sharp edges show that by some levels.
    expect(change(screen)).toBeLessThanOrEqual(16);
  });
}

test('the page fills with the same bytes as the command', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-fill-'));
  try {
    copyFileSync(PORTRAIT, join(folder, 'portrait.png'));
    writeFileSync(join(folder, 'project.json'), JSON.stringify(project(70)));
    const args = ['warp', 'project.json', '-o', 'out.png'];
    const { status, stderr } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
    expect(`${stderr}${status}`).toBe('0');
    await page.goto('/harness/');
    const { cpu } = await page.evaluate(async (project) => {
      const file = await (await fetch('/samples/portrait.png')).blob();
      return harness.drawnTwice(project, file, 1);
    }, project(70));
    const command = decode(readFileSync(join(folder, 'out.png')));
    expect(Buffer.from(command.data).equals(Buffer.from(decode(Buffer.from(cpu, 'base64')).data))).toBe(true);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('a lasso in a photograph is filled behind, in one step; a switch leaves it empty', async ({ page }) => {
  const editor = await Editor.open(page);
  await loadPortrait(page);
  const fillOf = () => page.evaluate(() => document.querySelector('c2-warp')?.project.fill ?? null);
  expect(await fillOf()).toBeNull();
  await page.keyboard.press('l');
  await editor.dragAlong(RING);
  await expect.poll(fillOf).toEqual({ method: 'patches', seed: 0 });

  // The exported opacities, once a part has moved.
  const opacities = () =>
    page.evaluate(
      async ([x, y]) => {
        const element = document.querySelector('c2-warp');
        if (!element) return [];
        const handles = [{ id: 'face', kind: 'point', rest: [x, y], posed: [x + 90, y] }] as const;
        element.project = { ...element.project, handles };
        const bitmap = await createImageBitmap(await element.toBlob());
        const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        pen?.drawImage(bitmap, 0, 0);
        const { data = [] } = pen?.getImageData(0, 0, bitmap.width, bitmap.height) ?? {};
        return [...new Set([...data].filter((_, at) => at % 4 === 3))];
      },
      [X, Y] as const,
    );
  await expect.poll(opacities).toEqual([255]);
  await page.keyboard.press('v');
  await page.keyboard.press('Escape');
  await editor.switch('Fill the background').click();
  await expect.poll(fillOf).toBeNull();
  await expect.poll(async () => (await opacities()).includes(0)).toBe(true);
  await editor.switch('Fill the background').click();
  await expect.poll(fillOf).toEqual({ method: 'patches', seed: 0 });
});
