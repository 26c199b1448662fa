/** Deceptive files, an interrupted network, and a browser that denies storage: all is reported, and work is kept. */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { deflateSync } from 'node:zlib';
import { expect, test } from '@playwright/test';
import { openWithHandle, randomIn, times } from './attacks';
import { chunk, header } from './corpus/png';
import { Editor } from './editor';
import { disc, png } from './files';

const SIDE = 96;
const CUTS = times(50, 3);

test.beforeEach(({ page }) =>
  page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showOpenFilePicker')),
);

/** A PNG with a header of its own, and black pixels of one bit for this many rows. */
function pngOf(size: readonly [number, number], rows: readonly [width: number, height: number]): Buffer {
  const row = Math.ceil(rows[0] / 8) + 1;
  return Buffer.from([
    ...[0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10],
    ...header(...size, 1, 0),
    ...chunk('IDAT', [...deflateSync(Buffer.alloc(row * rows[1]))]),
    ...chunk('IEND', []),
  ]);
}

const HOSTILE: Readonly<Record<string, () => Buffer>> = {
  'of 300 megapixels': () => pngOf([16_000, 18_750], [16_000, 18_750]),
  'of 256 megapixels within the longest side': () => pngOf([16_000, 16_000], [16_000, 16_000]),
  'that claims 300 megapixels': () => pngOf([16_000, 18_750], [8, 8]),
  'that claims 100 megapixels': () => pngOf([10_000, 10_000], [8, 8]),
  'that claims no width': () => pngOf([0, 8], [8, 8]),
  'that claims 4 billion columns': () => pngOf([0xffff_ffff, 1], [8, 8]),
};

test('pictures that are too large, and headers that lie, are refused in one sentence', async ({ page }) => {
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'disc.png', SIDE);
  for (const [title, file] of Object.entries(HOSTILE)) {
    await test.step(title, async () => {
      await editor.chooseFile(png('hostile.png', file()));
      await expect(editor.notice).toContainText('hostile.png');
      await expect(editor.notice).toHaveCount(1);
      await expect(page.getByRole('progressbar')).toBeHidden();
      await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
      await expect(editor.handles).toHaveCount(1);
      await editor.button('Dismiss').click();
      await expect(editor.notice).toBeHidden();
    });
  }
});

test('a JPEG that the browser begins to decode, but cannot, is refused in plain words', async ({ page }) => {
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'disc.png', SIDE);
  const buffer = readFileSync(new URL('../attacks/corpus/pictures/decoder-that-panics', import.meta.url));
  await editor.chooseFile({ name: 'partial.jpg', mimeType: 'image/jpeg', buffer });
  await expect(editor.notice).toContainText('The picture is damaged, or this browser cannot read it.');
  await expect(editor.handles).toHaveCount(1);
});

test('an interrupted download is reported, and the work is kept', async ({ page }) => {
  test.setTimeout(CUTS * 10_000 + 120_000);
  const random = randomIn('cuts');
  const whole = disc(SIDE);
  let sent = 0;
  const server = createServer((_, response) => {
    response.writeHead(200, {
      'Content-Type': 'image/png',
      'Content-Length': whole.length,
      'Access-Control-Allow-Origin': '*',
      'Cache-Control': 'no-store',
    });
    response.write(whole.subarray(0, sent), () => {
      if (sent < whole.length) response.destroy();
      else response.end();
    });
  });
  await new Promise<void>((done) => server.listen(0, 'localhost', done));
  const { port } = server.address() as AddressInfo;
  const open = (name: string) =>
    page.locator('c2-warp').evaluate((element, src) => {
      // It is for the sample.
      element.removeAttribute('project');
      element.setAttribute('src', src);
    }, `http://localhost:${port}/${name}.png`);
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'disc.png', SIDE);
  for (let count = 0; count < CUTS; count++) {
    sent = 1 + Math.floor(random() * (whole.length - 1));
    await open(`cut-${count}`);
    await expect(editor.notice).toContainText(`cut-${count}.png`);
    await expect(editor.notice).toHaveCount(1);
    await expect(page.getByRole('progressbar')).toBeHidden();
    await expect(editor.handles).toHaveCount(1);
    await editor.button('Dismiss').click();
  }
  sent = whole.length;
  await open('whole');
  await expect(page.getByText('whole.png', { exact: true })).toBeVisible();
  server.close();
});

test('if the browser denies storage, editing continues, and the loss is reported once', async ({ page }) => {
  await page.addInitScript(() => {
    // As in a frame of another origin.
    IDBFactory.prototype.open = () => {
      throw new DOMException('denied', 'SecurityError');
    };
  });
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'disc.png', SIDE);
  await expect(editor.notice).toContainText('This browser cannot store your work');
  await expect(editor.notice).toHaveCount(1);
  await editor.button('Dismiss').click();
  const before = await editor.shownPose('handle 1');
  await editor.handle('handle 1').focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(async () => (await editor.shownPose('handle 1')).x).toBe(before.x + 1);
  await expect(editor.notice).toBeHidden();
});
