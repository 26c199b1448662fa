/** Every page of the site: under its policy, on a phone, for screen readers, and its links. */
import { readFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect, test } from './fixtures';
import { BUILD_MS, htmlOf, openPage, PAGES } from './site';

test.describe.configure({ timeout: BUILD_MS + 120_000 });

/** Pages whose dark colours are tested, too: the landing page, code with a table, and the playground. */
const DARK = ['/site/', '/site/docs/clips/', '/site/playground/'];

/** Pages with a live picture. */
const LIVE = ['/site/', '/site/playground/'];

/** Returns requests that fail or leave the origin, from now on. */
function badRequests(page: Page, origin: string): readonly string[] {
  const bad: string[] = [];
  page.on('requestfailed', (request) => bad.push(`failed: ${request.url()}`));
  page.on('response', (response) => {
    if (response.status() >= 400) bad.push(`${response.status()}: ${response.url()}`);
  });
  page.on('request', (request) => {
    const { protocol, origin: other } = new URL(request.url());
    if (/^http/.test(protocol) && other !== origin) bad.push(`foreign: ${request.url()}`);
  });
  return bad;
}

async function expectAccessible(page: Page): Promise<void> {
  // Details of rules that hold take most of the time on long pages.
  const { violations } = await new AxeBuilder({ page }).options({ resultTypes: ['violations'] }).analyze();
  const found = violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(' ')}\n${failureSummary}`),
  );
  expect(found).toEqual([]);
}

for (const address of PAGES) {
  test(`${address} works under the policy, fits a phone and suits axe`, async ({ page, baseURL }) => {
    const bad = badRequests(page, baseURL ?? '');
    await openPage(page, address);
    if (LIVE.includes(address))
      await expect(page.getByRole('button', { name: /^Handle / }).first()).toBeVisible();
    await expectAccessible(page);
    await page.setViewportSize({ width: 320, height: 640 });
    const beyond = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    await expect.poll(beyond).toBeLessThanOrEqual(0);
    expect(bad).toEqual([]);
  });
}

for (const address of DARK) {
  test(`${address} suits axe in dark colours`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: 'dark' });
    await openPage(page, address);
    await expect(page.locator('html')).toHaveClass(/\bdark\b/);
    await expectAccessible(page);
  });
}

test('all links of the site lead to pages and headings', async ({ request }) => {
  const pages = new Map<string, string>();
  for (const address of PAGES) pages.set(address, await htmlOf(request, address));
  const dead: string[] = [];
  for (const [address, html] of pages) {
    for (const [, href = ''] of html.matchAll(/<a [^>]*?href="([^"]+)"/g)) {
      const { origin, pathname, hash } = new URL(href.replaceAll('&amp;', '&'), `http://site${address}`);
      // `npm run docs` adds the documentation of the library.
      if (origin !== 'http://site' || pathname.startsWith('/site/rustdoc/')) continue;
      const target = pages.get(pathname);
      const found = target?.includes(`id="${decodeURIComponent(hash.slice(1))}"`) || hash === '';
      if (target === undefined || !found) dead.push(`${address}: ${href}`);
    }
  }
  expect(dead).toEqual([]);
});

test('pages have no inline scripts and styles, and the policy of the manual', async ({ request }) => {
  for (const address of PAGES) {
    const html = await htmlOf(request, address);
    expect(html.match(/<script(?![^>]* src=)[^>]*>|<style|<[a-z][^>]* style="/g), address).toBeNull();
  }
  const manual = readFileSync(new URL('../../web/docs/hosting.md', import.meta.url), 'utf8');
  const policy = (await request.get('/site/')).headers()['content-security-policy'] ?? '';
  expect(manual.replaceAll(/\s+/g, ' ')).toContain(policy);
});

test('programs that read find all pages as text', async ({ request }) => {
  const list = await htmlOf(request, '/site/llms.txt');
  const named = [...list.matchAll(/\]\(\.\/(.*)\)$/gm)].map(([, path]) => `/site/${path}`);
  expect(named.sort()).toEqual(PAGES);
  const text = await htmlOf(request, '/site/llms-full.txt');
  expect(text).toContain("import 'c2warp';");
  expect(text).not.toMatch(/^<<<|@include/m);
});

test('the search finds a page by a word, without a server', async ({ page }) => {
  await openPage(page, '/site/');
  await page.getByRole('button', { name: 'Search' }).click();
  await page.getByRole('searchbox').fill('premultiplied');
  await page.getByRole('option').first().click();
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  await expect(page).not.toHaveURL(/\/site\/$/);
});

test('a phone has all pages in its menus', async ({ page }) => {
  // Colours in between have less contrast.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 320, height: 640 });
  await openPage(page, '/site/docs/clips/');
  await page.getByRole('button', { name: 'Menu', exact: true }).click();
  await expect(page.getByRole('link', { name: 'Rig format' })).toBeVisible();
  await expectAccessible(page);
  await page.getByRole('link', { name: 'Rig format' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(/^The rig file/);
  await page.getByRole('button', { name: 'mobile navigation' }).click();
  await expect(page.getByRole('link', { name: 'Playground' })).toBeVisible();
  await expectAccessible(page);
});

test('an address without a page says so', async ({ page }) => {
  await page.goto('/site/404.html', { timeout: BUILD_MS });
  await expect(page.getByRole('heading', { name: 'Page not found' })).toBeVisible();
});
