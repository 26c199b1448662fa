/** The pages of the site, as the server of the tests has them. */
import { readdirSync } from 'node:fs';
import type { APIRequestContext, Page } from '@playwright/test';
import { expect } from './fixtures';

const markdown = (folder: string): readonly string[] =>
  readdirSync(new URL(`../../web/${folder}/`, import.meta.url), { recursive: true, encoding: 'utf8' })
    .map((file) => file.replaceAll('\\', '/'))
    .filter((file) => file.endsWith('.md') && file !== '404.md')
    .map((file) => file.replace(/(?:^index)?\.md$/, ''));

/** The addresses of all pages, without those for addresses that do not exist. */
export const PAGES: readonly string[] = [
  ...markdown('docs').map((name) => `/site/docs/${name}/`),
  ...markdown('site').map((name) => (name === '' ? '/site/' : `/site/${name}/`)),
].sort();

/** Its first request builds the site. */
export const BUILD_MS = 180_000;

/** The HTML of a page. */
export async function htmlOf(request: APIRequestContext, address: string): Promise<string> {
  const response = await request.get(address, { timeout: BUILD_MS });
  expect(response.status(), address).toBe(200);
  return response.text();
}

/** Opens a page, and waits until its scripts have taken it over. */
export async function openPage(page: Page, address: string): Promise<void> {
  await page.goto(address, { timeout: BUILD_MS });
  await page.waitForFunction(() => '__vue_app__' in (document.querySelector('#app') ?? {}));
}
