/** The built element, as other pages and packages use it. */
import { readFileSync } from 'node:fs';
import { sizesOf } from '../../web/scripts/budgets.mjs';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const PACKAGE = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));

/** Returns the URL of a file of the package on the test server. */
const served = (file: string) => file.replace('./web/dist', '');

test('one script and one tag make a working editor', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('/plain/');
  const editor = new Editor(page);
  await editor.ready();
  const element = page.locator('c2-warp');
  const posed = () => element.evaluate((warp) => (warp as C2Warp).project.handles[2]?.posed);
  const before = await posed();
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await expect.poll(posed).not.toEqual(before);
  const size = await element.evaluate(async (warp) => (await (warp as C2Warp).toBlob({ scale: 0.1 })).size);
  expect(size).toBeGreaterThan(1000);
});

test('under the strictest policy it opens, poses and exports', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.addInitScript(() => {
    const violations: string[] = [];
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sample }) =>
      violations.push(`${violatedDirective}: ${blockedURI} ${sample}`),
    );
    Object.assign(globalThis, { violations });
  });
  await page.goto('/strict/');
  const editor = new Editor(page);
  await editor.ready();
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await editor.button('Overlays').click();
  await page.keyboard.press('Escape');
  // A part of the element that is loaded later.
  await page.keyboard.press('i');
  await expect(page.getByRole('region', { name: 'Lens' })).toBeVisible();
  const download = page.waitForEvent('download');
  await editor.pressExport();
  expect((await download).suggestedFilename()).toBe('gingerbread-warped.png');
  // The encoders of films: a module of their own, and the browser's.
  const panel = page.getByRole('dialog', { name: 'Export' });
  await editor.button('Export as …').click();
  await panel.getByRole('button', { name: 'Film', exact: true }).click();
  const size = panel.getByRole('spinbutton', { name: 'Size (%)' });
  await size.fill('5');
  await size.press('Enter');
  for (const format of ['GIF', 'WebM']) {
    if (!(await panel.isVisible())) await editor.button('Export as …').click();
    await panel.getByRole('button', { name: format, exact: true }).click();
    const film = page.waitForEvent('download');
    await panel.getByRole('button', { name: `Export ${format}` }).click();
    expect((await film).suggestedFilename()).toMatch(/^gingerbread-wave\.(gif|webm)$/);
  }
  expect(await page.evaluate(() => Reflect.get(globalThis, 'violations'))).toEqual([]);
});

test.describe('without a policy', () => {
  test.use({ bypassCSP: true });

  test('it runs on a page of another origin, and in a sandboxed frame', async ({ page, baseURL }) => {
    const warp = `
      <script type="module" src="${baseURL}/element/c2warp.js"></script>
      <c2-warp src="${baseURL}/samples/gingerbread.png" project="${baseURL}/samples/gingerbread.c2warp.json"></c2-warp>`;
    await page.route('**/favicon.ico', (route) => route.fulfill());
    await page.goto(`${baseURL}/samples/gingerbread.c2warp.json`.replace('localhost', 'other.localhost'));
    await page.evaluate((warp) => {
      const sandboxed = Object.assign(document.createElement('iframe'), {
        srcdoc: warp,
        width: 800,
        height: 600,
      });
      sandboxed.sandbox.add('allow-scripts');
      document.body.replaceChildren(document.createRange().createContextualFragment(warp), sandboxed);
    }, warp);
    await expect.poll(() => page.frames().length).toBe(2);
    for (const frame of page.frames()) {
      const element = frame.locator('c2-warp');
      await expect(element.locator('.solved')).toContainText('mesh point');
      const size = await element.evaluate(
        async (warp) => (await (warp as C2Warp).toBlob({ scale: 0.1 })).size,
      );
      expect(size).toBeGreaterThan(1000);
    }
  });
});

test('a missing file, or a page in its place, is reported', async ({ page }) => {
  const refused = async () => {
    await page.goto('/plain/');
    await expect(page.getByRole('alert')).toBeVisible();
    return page.getByRole('alert').textContent();
  };
  await page.route('**/worker.js', (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }),
  );
  expect(await refused()).toMatch(/Check that http:.+worker\.js exists/);
  await page.route('**/*.wasm', (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }),
  );
  expect(await refused()).toMatch(/a web page instead of http:.+warp_bg\.wasm/);
});

test('downloads stay within their budgets', async ({ request }) => {
  const sizes = await sizesOf(async (path) => (await request.get(`/${path}`)).body());
  expect(sizes.filter(({ size, most }) => size >= most)).toEqual([]);
});

test('the entries of the core and of the command exist', async ({ request }) => {
  const { types: _, ...core }: Readonly<Record<string, string>> = PACKAGE.exports['./core'];
  for (const entry of [...Object.values(core), PACKAGE.bin.c2warp])
    expect((await request.get(served(String(entry)))).ok(), entry).toBe(true);
});
