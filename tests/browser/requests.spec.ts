/** Nothing leaves the origin of the page: every request of the browser, over a whole session with the editor. */
import { AppServer, builtEditor } from './app_server';
import { Editor } from './editor';
import { exportFilm, exportPicture, exportRig } from './exports';
import { bring, disc, png } from './files';
import { expect, test } from './fixtures';
import { RecordingProxy } from './recording_proxy';

/** In the page and its workers, without a network: an object in memory, or the address itself. */
const LOCAL = /^(blob|data):/;

test('open, pose, export, film, rig and save only send requests to the own server', async ({ browser }) => {
  test.slow();
  const [server, proxy] = [await AppServer.start(await builtEditor('first')), await RecordingProxy.start()];
  const context = await browser.newContext({
    // Browsers do not ask proxies about localhost unless they are told to.
    proxy: { server: proxy.address, bypass: '<-loopback>' },
    serviceWorkers: 'allow',
    reducedMotion: 'reduce',
    viewport: { width: 900, height: 700 },
  });
  const seen: string[] = [];
  context.on('request', (request) => seen.push(request.url()));
  try {
    const page = await context.newPage();
    page.on('websocket', (socket) => seen.push(socket.url()));
    await page.addInitScript(() => {
      Reflect.deleteProperty(globalThis, 'showOpenFilePicker');
      Reflect.deleteProperty(globalThis, 'showSaveFilePicker');
    });
    await page.goto(server.home);
    const editor = new Editor(page);
    await editor.ready();
    // All of that once from the server, and once from the service worker.
    for (const controlled of [false, true]) {
      if (controlled) {
        await expect
          .poll(() => page.evaluate(() => navigator.serviceWorker.controller?.state))
          .toBe('activated');
        await page.reload();
        // The reload may come before the browser has stored that the sample is open again.
        await expect(editor.solved).toContainText('mesh point');
        await editor.openRecent('gingerbread');
        await editor.ready();
      }
      await editor.dragHandle('right hand', { x: 10, y: -40 });
      await exportPicture(editor);
      for (const format of controlled ? ['GIF'] : ['GIF', 'WebM', 'PNGs']) await exportFilm(editor, format);
      await exportRig(editor);
      await editor.download('Save the project file');
      await page.keyboard.press('i');
      await expect(page.getByRole('region', { name: 'Lens' })).toBeVisible();
      await page.keyboard.press('Escape');
      await editor.openRecent('octopus');
      await expect(page).toHaveTitle('octopus.png – c2warp');
      await bring(editor, 'drop', png('disc.png', disc(96)));
      await expect(page).toHaveTitle('disc.png – c2warp');
      await editor.openRecent('gingerbread');
      await editor.ready();
    }
    const { origin } = new URL(server.home);
    const isOwn = (address: string) => address.startsWith(`${origin}/`);
    expect(proxy.asked.filter((address) => !isOwn(address))).toEqual([]);
    expect(seen.filter((address) => !isOwn(address) && !LOCAL.test(address))).toEqual([]);
    // The recording has the requests of the page, of workers and of the service worker.
    const asked = proxy.asked.map((address) => address.replace(server.home, ''));
    expect(asked).toEqual(expect.arrayContaining(['', 'samples/octopus.png', 'icons/512.png']));
    for (const file of [/^assets\/worker-.*js$/, /^assets\/film_bg.*wasm$/, /^assets\/videos-.*js$/])
      expect(asked).toContainEqual(expect.stringMatching(file));

    // It would have other hosts too.
    await page.goto('http://elsewhere.test/').catch(() => {});
    expect(proxy.asked).toContain('http://elsewhere.test/');
  } finally {
    await context.close();
    proxy.stop();
    await server.stop();
  }
});
