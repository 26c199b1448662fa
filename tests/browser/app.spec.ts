/** The editor as an installed app: without a network, in versions that follow one another, and with given files. */
import { readFileSync } from 'node:fs';
import type { BrowserContext, Page } from '@playwright/test';
import { decode } from 'fast-png';
import { AppServer, builtEditor, type Files } from './app_server';
import { bytes, Editor } from './editor';
import { exportFilm, exportRig } from './exports';
import { disc, type GivenFile, png, project } from './files';
import { expect, test } from './fixtures';

test.use({ serviceWorkers: 'allow' });
// One process builds both versions once.
test.describe.configure({ mode: 'default' });

const MANUAL = readFileSync(new URL('../../web/docs/hosting.md', import.meta.url), 'utf8');

let [first, second]: Files[] = [];
let server: AppServer;

test.beforeAll(async () => {
  first = await builtEditor('first');
  second = await builtEditor('second');
});
test.beforeEach(async () => {
  server = await AppServer.start(first as Files);
});
test.afterEach(() => server.stop());

/** Opens the editor, and waits until it is stored. */
async function visited(page: Page): Promise<Editor> {
  const editor = await opened(page);
  await expect.poll(() => page.evaluate(() => navigator.serviceWorker.controller?.state)).toBe('activated');
  return editor;
}

async function opened(page: Page): Promise<Editor> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(server.home);
  const editor = new Editor(page);
  await editor.ready();
  return editor;
}

async function goOffline(context: BrowserContext): Promise<void> {
  await server.stop();
  await context.setOffline(true);
}

/** The lens is a part that is loaded later. */
async function openLens(page: Page): Promise<void> {
  await page.keyboard.press('i');
  await expect(page.getByRole('region', { name: 'Lens' })).toBeVisible();
}

/** The versions reported by the scripts of a page. */
const versions = (page: Page) =>
  page.evaluate(() => ['main', 'study'].map((name) => Reflect.get(globalThis, `${name}Version`)));

/** Looks for a new version, and waits until it is stored. */
async function update(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    await registration.update();
  });
  await expect
    .poll(() => page.evaluate(async () => (await navigator.serviceWorker.ready).waiting?.state))
    .toBe('installed');
}

const notice = (page: Page) => page.locator('c2-warp .notice');

const NEW_VERSION = 'A new version is ready. It starts the next time you open the editor.';

test('after one visit it works without a network', async ({ page, context }) => {
  await visited(page);
  await goOffline(context);
  await page.reload();
  const editor = new Editor(page);
  await editor.ready();
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const { width, height } = decode(await bytes(await editor.exported()));
  expect([width, height]).toEqual([1024, 1280]);
  const saved = await editor.download('Save the project file');
  expect(saved.suggestedFilename()).toBe('gingerbread.c2warp.json');
  await openLens(page);
  await page.keyboard.press('Escape');
  await exportFilm(editor, 'GIF');
  await exportRig(editor);

  await editor.openRecent('octopus');
  await expect(page).toHaveTitle('octopus.png – c2warp');
});

test('the page of the first visit needs no network any more', async ({ page, context }) => {
  await visited(page);
  await goOffline(context);
  await openLens(page);
});

test('every file of a version is stored, and asked for once', async ({ page }) => {
  await visited(page);
  const stored = await page.evaluate(async () => {
    const [name = ''] = await caches.keys();
    const keys = await (await caches.open(name)).keys();
    return keys.map(({ url }) => new URL(url).pathname.replace(/^\/tools\/editor\//, ''));
  });
  const parts = [...(first as Files).keys()].filter((name) => name !== 'service-worker.js');
  expect(stored).toEqual(expect.arrayContaining(parts.map((name) => (name === 'index.html' ? '' : name))));
  expect(stored).toEqual(expect.arrayContaining(['samples/octopus.png', 'icons/512.png']));
  expect(stored.filter((name) => /samples.*svg/.test(name))).toEqual([]);
  const wasm = server.asked.filter((path) => /c2warp_bg.*wasm/.test(path));
  expect(wasm).toHaveLength(1);
});

test('an update is announced once, and waits for the next start', async ({ page }) => {
  const editor = await visited(page);
  server.deploy(second as Files);
  await update(page);
  await expect(page.getByText(NEW_VERSION)).toHaveCount(1);
  await expect(notice(page)).toHaveText(NEW_VERSION);
  // The old version stays whole: the server has this part of it no more.
  await openLens(page);
  expect(await versions(page)).toEqual(['first', 'first']);
  await expect(page.getByText(NEW_VERSION)).toBeHidden();

  await page.reload();
  await expect.poll(() => versions(page).catch(() => null)).toEqual(['second', undefined]);
  await editor.ready();
  await openLens(page);
  expect(await versions(page)).toEqual(['second', 'second']);
  await expect(page.getByText('A new version')).toHaveCount(0);
});

test('with two windows both stay at their version until one is left', async ({ page, context }) => {
  await visited(page);
  server.deploy(second as Files);
  await update(page);
  const other = await context.newPage();
  await opened(other);
  await expect(notice(other)).toContainText('It starts after you close all other editor windows.');
  await openLens(other);
  expect(await versions(other)).toEqual(['first', 'first']);
  await openLens(page);
  expect(await versions(page)).toEqual(['first', 'first']);

  await page.close();
  await other.reload();
  await expect.poll(() => versions(other).catch(() => null)).toEqual(['second', undefined]);
});

test('once all windows are closed, the next start is the new version', async ({ page, context }) => {
  await visited(page);
  server.deploy(second as Files);
  await update(page);
  await page.close();
  const next = await context.newPage();
  await opened(next);
  await expect.poll(() => versions(next).catch(() => null)).toEqual(['second', undefined]);
  const files = () =>
    next.evaluate(async () => {
      const [name = ''] = await caches.keys();
      return (await (await caches.open(name)).keys()).length;
    });
  const stored = await files();
  // The files of the old version are gone.
  const parts = (files: Files) => [...files.keys()];
  const changed = parts(first as Files).filter((name) => !second?.has(name)).length;
  expect(changed).toBeGreaterThan(1);
  await next.reload();
  expect(await files()).toBe(stored);
});

test('a download that breaks off is tried again', async ({ page, context }) => {
  server.failures.set('samples/snake.png', { status: 503, times: 2 });
  await visited(page);
  expect(server.asked.filter((path) => path === 'samples/snake.png')).toHaveLength(3);
  await goOffline(context);
  await page.reload();
  await new Editor(page).ready();
});

test('a version that cannot be stored whole is not used, and is tried again', async ({ page }) => {
  server.failures.set('samples/snake.png', { status: 503, times: 3 });
  await opened(page);
  const tries = () => server.asked.filter((path) => path === 'samples/snake.png').length;
  await expect.poll(tries).toBe(3);
  await expect
    .poll(() => page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length))
    .toBe(0);
  // In a tab nobody expects it to work without a network.
  await expect(notice(page)).toBeHidden();
  const wasm = () => server.asked.filter((path) => path.endsWith('.wasm')).length;
  const before = wasm();
  await visited(page);
  expect(wasm()).toBe(before);
});

test('files opened with the editor open as those of its own button do', async ({ page }) => {
  await holdLaunchQueue(page);
  const editor = await opened(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const saved = await bytes(await editor.download('Save the project file'));
  await launch(page, png('disc.png', disc(96)));
  await expect(editor.status).toContainText('96 × 96 px');
  await expect(page).toHaveTitle('disc.png – c2warp');
  await editor.openRecent('gingerbread.png');
  await editor.ready();
  await editor.button('Reset all handles').click();
  await launch(page, project(saved.toString(), 'gingerbread.c2warp.json'));
  await expect(editor.button('Undo: open gingerbread.c2warp.json')).toBeEnabled();
});

test('opening a deleted file is reported', async ({ page }) => {
  await page.addInitScript(() => {
    const getFile = () => Promise.reject(new DOMException('gone', 'NotFoundError'));
    const launchQueue = {
      setConsumer: (consume: (launch: object) => void) => consume({ files: [{ name: 'cat.png', getFile }] }),
    };
    Object.defineProperty(globalThis, 'launchQueue', { value: launchQueue });
  });
  await opened(page);
  await expect(notice(page)).toContainText('Could not read cat.png');
});

test('files of the system that lie leave the work as it is', async ({ page }) => {
  await holdLaunchQueue(page);
  const editor = await opened(page);
  const hostile = [
    png('text.png', Buffer.from('<html>')),
    png('cut.png', disc(96).subarray(0, 60)),
    project('{"format": "c2warp/9"}', 'later.c2warp.json'),
    png('empty.png', Buffer.alloc(0)),
  ];
  for (const file of hostile) {
    await launch(page, file);
    await expect(notice(page)).toContainText(file.name);
    await expect(page).toHaveTitle('gingerbread.png – c2warp');
    await editor.button('Dismiss').click();
  }
  await page.evaluate(() => Reflect.get(globalThis, 'launched')({ files: [] }));
  await editor.ready();
});

test('a shared picture opens, without a network too', async ({ page, context }) => {
  await visited(page);
  await goOffline(context);
  await share(page, [png('größe 1.png', disc(80))]);
  const editor = new Editor(page);
  await editor.ready();
  await takeOffer(page, 'größe 1.png');
  await expect(editor.status).toContainText('80 × 80 px');
  await expect(page).toHaveTitle('größe 1.png – c2warp');
  await expect(page).toHaveURL(server.home);
  // A reload restores it as any work, and takes no file again.
  await expect.poll(() => editor.storedWork()).toMatchObject({ picture: 'größe 1.png' });
  await page.reload();
  await expect(editor.status).toContainText('80 × 80 px');
  await expect(notice(page)).toBeHidden();
});

for (const policy of ['unsafe-url', 'no-referrer'])
  test(`a form of another site replaces no work by itself, with the policy ${policy}`, async ({ page }) => {
    const editor = await visited(page);
    await editor.dragHandle('right hand', { x: 10, y: -40 });
    await expect.poll(() => editor.storedWork()).toMatchObject({ step: 'Move right hand' });
    const headers = { 'Referrer-Policy': policy };
    await page.route('http://other.example/', (route) =>
      route.fulfill({ contentType: 'text/html', headers, body: '<!doctype html><title>other</title>' }),
    );
    await page.goto('http://other.example/');
    await share(page, [png('disc.png', disc(80))], server.home);
    await editor.ready();
    await expect(notice(page)).toContainText('A link or another program wants to open disc.png.');
    await expect(page).toHaveURL(server.home);
    await expect(editor.button('Undo: move right hand')).toBeEnabled();
    await takeOffer(page, 'disc.png');
    await expect(editor.status).toContainText('80 × 80 px');
    await editor.openRecent('gingerbread.png');
    await expect(editor.button('Undo: move right hand')).toBeEnabled();
  });

test('a link of another site replaces no work by itself', async ({ page }) => {
  const editor = await visited(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await expect.poll(() => editor.storedWork()).toMatchObject({ step: 'Move right hand' });
  await page.route('http://other.example/', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><script>location = '${server.home}?src=samples/octopus.png'</script>`,
    }),
  );
  await page.goto('http://other.example/', { waitUntil: 'commit' });
  await takeOffer(page, 'octopus.png', async () => {
    await expect(editor.button('Undo: move right hand')).toBeEnabled();
  });
  await expect(page).toHaveTitle('octopus.png – c2warp');
});

test('a share without a file is reported', async ({ page }) => {
  await visited(page);
  await share(page, []);
  await expect(notice(page)).toContainText('Could not receive the shared picture');
});

test('the manifest is valid, and its files are there', async ({ page }) => {
  await opened(page);
  const session = await page.context().newCDPSession(page);
  const { url, errors, data } = await session.send('Page.getAppManifest');
  expect([url, errors]).toEqual([`${server.home}manifest.webmanifest`, []]);
  const manifest = JSON.parse(data ?? '');
  expect(manifest).toMatchObject({ display: 'standalone', start_url: './', scope: './' });
  const sizes = [];
  for (const { src, sizes: size, type, purpose } of manifest.icons) {
    const response = await page.request.get(new URL(src, url).href);
    expect(response.headers()['content-type']).toBe(type);
    if (type !== 'image/png') continue;
    const { width, height } = decode(await response.body());
    expect(`${width}x${height}`).toBe(size);
    sizes.push(`${size} ${purpose}`);
  }
  expect(sizes).toEqual(['192x192 any', '512x512 any', '512x512 maskable']);
  const touch = await page
    .locator('link[rel="apple-touch-icon"]')
    .evaluate((link: HTMLLinkElement) => link.href);
  expect((await page.request.get(touch)).ok()).toBe(true);
});

test('the colour of the title bar follows the theme', async ({ page }) => {
  await opened(page);
  const colours = () =>
    page
      .locator('meta[name="theme-color"]')
      .evaluateAll((metas: HTMLMetaElement[]) => metas.map(({ content }) => content));
  expect(await colours()).toEqual(['#ffffff', '#232427']);
  await page.locator('c2-warp').evaluate((warp) => warp.setAttribute('theme', 'dark'));
  await expect.poll(colours).toEqual(['#232427', '#232427']);
  await page.reload();
  await expect.poll(colours).toEqual(['#232427', '#232427']);
});

test('a worker is removed by the one of the manual', async ({ page }) => {
  await visited(page);
  const [, retired = ''] = MANUAL.match(/^```js\n(.*?)^```$/ms) ?? [];
  server.deploy(new Map([...(second as Files), ['service-worker.js', retired]]));
  await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  await expect
    .poll(() =>
      page
        .evaluate(async () => [
          await caches.keys(),
          (await navigator.serviceWorker.getRegistrations()).filter(({ active }) => active).length,
          Reflect.get(globalThis, 'mainVersion'),
        ])
        .catch(() => null),
    )
    .toEqual([[], 0, 'second']);
});

test('an element in another page registers no worker', async ({ page, baseURL }) => {
  await page.goto(`${baseURL}/plain/`);
  await new Editor(page).ready();
  expect(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length)).toBe(0);
});

/** Keeps the function that receives files of the system, for {@link launch}. */
const holdLaunchQueue = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const launchQueue = {
      setConsumer: (consume: unknown) => Reflect.set(globalThis, 'launched', consume),
    };
    Object.defineProperty(globalThis, 'launchQueue', { value: launchQueue });
  });

/** Gives a file to the page as the system does: by a handle, here one of the browser's own file system. */
const launch = (page: Page, { name, mimeType, buffer }: GivenFile): Promise<void> =>
  page.evaluate(
    async ({ name, mimeType, base64 }) => {
      const folder = await navigator.storage.getDirectory();
      const handle = await folder.getFileHandle(name, { create: true });
      const writing = await handle.createWritable();
      const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      await writing.write(new Blob([content], { type: mimeType }));
      await writing.close();
      Reflect.get(globalThis, 'launched')({ files: [handle] });
    },
    { name, mimeType, base64: buffer.toString('base64') },
  );

/** Opens what a notice offers. @param before what holds until then. */
async function takeOffer(page: Page, name: string, before = async () => {}): Promise<void> {
  await expect(notice(page)).toContainText(`A link or another program wants to open ${name}.`);
  await before();
  await notice(page).getByRole('button', { name: 'Open' }).click();
}

/** Sends the form that a system sends to a share target. */
async function share(page: Page, files: readonly GivenFile[], action = './'): Promise<void> {
  await page.evaluate(
    ([files, action]) => {
      const transfer = new DataTransfer();
      for (const { name, type, base64 } of files) {
        const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        transfer.items.add(new File([content], name, { type }));
      }
      const input = Object.assign(document.createElement('input'), { type: 'file', name: 'files' });
      input.files = transfer.files;
      const form = Object.assign(document.createElement('form'), {
        method: 'post',
        enctype: 'multipart/form-data',
        action,
      });
      form.append(...(files.length > 0 ? [input] : []));
      document.body.append(form);
      form.submit();
    },
    [
      files.map(({ name, mimeType, buffer }) => ({
        name,
        type: mimeType,
        base64: buffer.toString('base64'),
      })),
      action,
    ] as const,
  );
}
