/** The examples of `web/docs/element.md`, on pages without a policy. */
import { readFileSync } from 'node:fs';
import type { C2Warp } from '../../web/src/element';
import { expect, test } from './fixtures';

const MANUAL = readFileSync(new URL('../../web/docs/element.md', import.meta.url), 'utf8');
const EXAMPLES = [...MANUAL.matchAll(/^```html\n(.*?)^```$/gms)].map(([, example = '']) => example);

for (const [index, example] of EXAMPLES.entries()) {
  test(`example ${index + 1} opens its picture`, async ({ page, baseURL }) => {
    await page.route('**/example.html', (route) =>
      route.fulfill({ contentType: 'text/html', body: `<link rel="icon" href="favicon.svg" />${example}` }),
    );
    // Every picture and project of the examples is the sample.
    await page.route(/\/(?:cat|gingerbread)\.(?:png|c2warp\.json)$/, async (route) => {
      const { pathname } = new URL(route.request().url());
      const file = pathname.replace(/^.*\/\w+\./, '/samples/gingerbread.');
      await route.fulfill({ response: await route.fetch({ url: `${baseURL}${file}` }) });
    });
    await page.goto('/example.html');
    const warp = page.locator('c2-warp');
    const mapped = () => warp.evaluate((element) => (element as C2Warp).mapPoint?.([512, 700]) ?? null);
    await expect.poll(mapped).not.toBeNull();
    if (!example.includes('requestAnimationFrame')) return;
    const hand = () => warp.evaluate((element) => (element as C2Warp).mapPoint([124, 516]));
    const before = await hand();
    await expect.poll(hand).not.toEqual(before);
    await expect(page.locator('#label')).not.toHaveCSS('translate', '0px');
  });
}

test('the manual has examples of a page, an article, a form, slots and an animation', () => {
  expect(EXAMPLES).toHaveLength(5);
});
