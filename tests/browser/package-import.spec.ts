/** The built modules, imported without a DOM. */
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { APIRequestContext } from '@playwright/test';
import { expect, test } from './fixtures';

/** Modules that define elements, with their classes. */
const MODULES = [
  ['element/c2warp.js', 'C2Warp'],
  ['player/c2warp-player.js', 'C2WarpPlayer'],
] as const;

/** Writes a served module, and those that it imports, into a folder. */
async function written(request: APIRequestContext, folder: string, entry: string): Promise<string> {
  const files = [entry];
  for (const file of files) {
    const text = await (await request.get(`/${file}`)).text();
    await mkdir(join(folder, file, '..'), { recursive: true });
    await writeFile(join(folder, file), text);
    for (const [, name] of text.matchAll(/\bfrom\s*["'`]\.\/([\w-]+\.js)["'`]/g)) {
      const imported = `${entry.split('/')[0]}/${name}`;
      if (!files.includes(imported)) files.push(imported);
    }
  }
  return pathToFileURL(join(folder, entry)).href;
}

test('the package has one module of the element, for pages, servers and workers', async () => {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  const { exports, main, types, dependencies } = JSON.parse(text);
  expect(Object.keys(exports['.'])).toEqual(['types', 'default']);
  expect([types, main]).toEqual(Object.values(exports['.']));
  expect(dependencies).toBeUndefined();
});

test('servers import the elements without an entry in the list of Lit versions', async ({ request }) => {
  const folder = await mkdtemp(join(tmpdir(), 'c2warp-import-'));
  await writeFile(join(folder, 'package.json'), '{ "type": "module" }');
  try {
    for (const [entry, name] of MODULES) {
      const module = await import(await written(request, folder, entry));
      expect(module[name].prototype.connectedCallback, name).toBeInstanceOf(Function);
    }
    const globals = Object.keys(globalThis).filter((name) => /^(lit|reactive)/i.test(name));
    expect(globals).toEqual([]);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
});

test('workers are single files, because bundlers copy them as they are', async ({ request }) => {
  const scripts = await Promise.all(
    ['c2warp.js', 'exporting.js', 'filming.js'].map(async (name) =>
      (await request.get(`/element/${name}`)).text(),
    ),
  );
  const addresses = [...scripts.join().matchAll(/new URL\("\.\/(\w+\.js)",import\.meta\.url\)/g)];
  const workers = new Set(addresses.map(([, name]) => name));
  expect(workers).toContain('worker.js');
  for (const name of workers) {
    const text = await (await request.get(`/element/${name}`)).text();
    expect(text, name).not.toMatch(/\bimport\s*[("'`]|\bfrom\s*["'`]\.\/|import\.meta\.url/);
  }
});

test('workers import the elements', async ({ page, baseURL }) => {
  await page.route('**/importer.js?*', (route) => {
    const [address, name] = new URL(route.request().url()).searchParams.values();
    const body = `import(${JSON.stringify(address)}).then(
      (module) => postMessage(typeof module[${JSON.stringify(name)}]),
      (error) => postMessage(String(error)),
    );`;
    return route.fulfill({ contentType: 'text/javascript', body });
  });
  await page.goto('/plain/');
  for (const [entry, name] of MODULES) {
    const query = new URLSearchParams({ address: `${baseURL}/${entry}`, name });
    const kind = await page.evaluate((address) => {
      const worker = new Worker(address, { type: 'module' });
      return new Promise((resolve) => {
        worker.onmessage = ({ data }) => resolve(data);
        worker.onerror = ({ message }) => resolve(`error: ${message}`);
      });
    }, `/importer.js?${query}`);
    expect(kind, entry).toBe('function');
  }
});

test('a second Lit in the page does not detect the first', async ({ page }) => {
  await page.goto('/plain/');
  await page.waitForFunction(() => customElements.get('c2-warp') !== undefined);
  const globals = await page.evaluate(() =>
    Object.keys(globalThis).filter((name) => /^(lit|reactive)/i.test(name)),
  );
  expect(globals).toEqual([]);
});
