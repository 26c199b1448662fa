/** Exports: the panel, formats, sizes, progress, and how an export is cancelled. */
import type { Page } from '@playwright/test';
import { decode, encode } from 'fast-png';
import type { BlobOptions, C2Warp } from '../../web/src/element';
import { expectAccessible } from './axe';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';
import { WorkerReplies } from './worker_replies';

/** Opens the export panel. */
const openPanel = (editor: Editor) => editor.button('Export as …').click();

const panel = (page: Page) => page.getByRole('dialog', { name: 'Export' });

/** Presses a segment of the open panel. */
const choose = (page: Page, word: string) =>
  panel(page).getByRole('button', { name: word, exact: true }).click();

/** Returns a file as the browser decodes it: its size, and the colour of a pixel. */
const decoded = (page: Page, file: Buffer, at: readonly [number, number] = [0, 0]) =>
  page.evaluate(
    async ([base64, [x, y]]) => {
      const blob = await (await fetch(`data:;base64,${base64}`)).blob();
      const bitmap = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      const pixel = Array.from(context?.getImageData(x, y, 1, 1).data ?? []);
      return { width: bitmap.width, height: bitmap.height, pixel };
    },
    [file.toString('base64'), at] as const,
  );

/** Calls `toBlob` of the element, and returns its bytes and type. */
const blob = async (page: Page, scale: number, options: BlobOptions) => {
  const [type, data] = await page.locator('c2-warp').evaluate(
    async (element, [scale, options]) => {
      const file = await (element as C2Warp).toBlob({ scale, ...options });
      return [file.type, Array.from(new Uint8Array(await file.arrayBuffer()))] as const;
    },
    [scale, options] as const,
  );
  return { type, data: Buffer.from(data) };
};

test('the panel exports in each format, and says the name of the file', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [format, extension, signature] of [
    ['PNG', 'png', '\x89PNG'],
    ['JPEG', 'jpg', '\xff\xd8\xff'],
    ['WebP', 'webp', 'RIFF'],
  ] as const) {
    await openPanel(editor);
    await choose(page, format);
    const started = page.waitForEvent('download');
    await panel(page)
      .getByRole('button', { name: `Export ${format}` })
      .click();
    await expect(panel(page)).toBeHidden();
    const download = await started;
    const name = `gingerbread-warped.${extension}`;
    expect(download.suggestedFilename()).toBe(name);
    await expect(page.getByText(`Saved as ${name}.`)).toBeVisible();
    const file = await bytes(download);
    expect(file.subarray(0, signature.length).toString('latin1')).toBe(signature);
    const { width, height, pixel } = await decoded(page, file);
    expect([width, height]).toEqual([1024, 1280]);
    // The corner is transparent, and white in a JPEG.
    expect(pixel.at(-1)).toBe(format === 'JPEG' ? 255 : 0);
    if (format === 'JPEG') expect(Math.min(...pixel)).toBeGreaterThan(250);
  }
});

test('a file has the chosen size, area, quality and background', async ({ page }) => {
  const editor = await Editor.open(page);
  await openPanel(editor);
  const size = panel(page).getByRole('spinbutton', { name: 'Size (%)' });
  await size.fill('50');
  await size.press('Enter');
  await expect(panel(page)).toContainText('512 × 640 px');
  await choose(page, 'Trimmed');
  await expect(panel(page)).toContainText(/≈ \d+ × \d+ px/);
  const about = ((await panel(page).textContent()) ?? '')
    .match(/≈ (\d+) × (\d+) px/)
    ?.slice(1)
    .map(Number);
  const covered = decode(await bytes(await exportedFromPanel(page, 'PNG')));
  // The text is right up to soft edges, and no border is empty.
  expect(Math.abs(covered.width - (about?.[0] ?? 0))).toBeLessThan(8);
  expect(Math.abs(covered.height - (about?.[1] ?? 0))).toBeLessThan(8);
  expect(covered.width).toBeLessThan(512);
  const alpha = (x: number, y: number) => covered.data[(y * covered.width + x) * 4 + 3] ?? 0;
  const columns = [...Array(covered.width).keys()];
  const rows = [...Array(covered.height).keys()];
  for (const y of [0, covered.height - 1])
    expect(Math.max(...columns.map((x) => alpha(x, y)))).toBeGreaterThan(0);
  for (const x of [0, covered.width - 1])
    expect(Math.max(...rows.map((y) => alpha(x, y)))).toBeGreaterThan(0);

  await openPanel(editor);
  await choose(page, 'Original');
  await choose(page, 'JPEG');
  await panel(page).locator('[name=background]').fill('#204060');
  const fine = await bytes(await exportedFromPanel(page, 'JPEG'));
  const { width, height, pixel } = await decoded(page, fine);
  expect([width, height]).toEqual([512, 640]);
  for (const [channel, value] of [0x20, 0x40, 0x60].entries())
    expect(Math.abs((pixel[channel] ?? 0) - value)).toBeLessThan(6);
  await openPanel(editor);
  await panel(page).getByRole('slider', { name: 'Quality' }).fill('20');
  const coarse = await bytes(await exportedFromPanel(page, 'JPEG'));
  expect(coarse.length).toBeLessThan(0.7 * fine.length);

  // Ctrl E uses the same choices, also after a reload.
  await expect
    .poll(async () => (await editor.storedWork()).exports)
    .toMatchObject({ format: 'jpeg', quality: 20, percent: 50 });
  await page.reload();
  await editor.ready();
  const started = page.waitForEvent('download');
  await page.keyboard.press('Control+e');
  const again = await started;
  expect(again.suggestedFilename()).toBe('gingerbread-warped.jpg');
  expect((await bytes(again)).equals(coarse)).toBe(true);
});

async function exportedFromPanel(page: Page, format: string) {
  const started = page.waitForEvent('download');
  await panel(page)
    .getByRole('button', { name: `Export ${format}` })
    .click();
  return started;
}

test('a PNG by toBlob has the bytes that a canvas of the same export rounds', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 20, y: -60 });
  const { data } = decode((await blob(page, 0.25, {})).data);
  const rounded = await page.locator('c2-warp').evaluate(async (element) => {
    const canvas = await (element as C2Warp).toCanvas({ scale: 0.25 });
    return Array.from(canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? []);
  });
  expect(rounded.length).toBe(data.length);
  // Exact where opaque, and close elsewhere.
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3] !== 255) continue;
    for (let channel = 0; channel < 3; channel++)
      if (data[at + channel] !== rounded[at + channel]) throw new Error(`byte ${at + channel} differs`);
  }
});

test('toBlob writes other types, crops, and refuses invalid options', async ({ page }) => {
  await Editor.open(page);
  const jpeg = await blob(page, 0.25, { type: 'image/jpeg', quality: 0.5, background: '#000000' });
  expect(jpeg.type).toBe('image/jpeg');
  const { width, pixel } = await decoded(page, jpeg.data);
  expect(width).toBe(256);
  expect(Math.max(...pixel.slice(0, 3))).toBeLessThan(6);
  const webp = await blob(page, 0.25, { type: 'image/webp', quality: 0.5, crop: true });
  expect(webp.type).toBe('image/webp');
  expect((await decoded(page, webp.data)).width).toBeLessThan(256);
  for (const [options, name] of [
    [{ type: 'image/gif' as 'image/png' }, 'type'],
    [{ quality: 90 }, 'quality'],
    [{ background: 'red' }, 'background'],
  ] as const) {
    await expect(blob(page, 1, options)).rejects.toThrow(`RangeError: ${name}: `);
  }
});

test('toBlob tells its progress, and a signal stops it', async ({ page }) => {
  await Editor.open(page);
  const [fractions, reason, after] = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const fractions: number[] = [];
    await warp.toBlob({ scale: 2, onProgress: (fraction) => fractions.push(fraction) });
    const controller = new AbortController();
    const stopped = warp.toBlob({
      scale: 2,
      signal: controller.signal,
      onProgress: () => controller.abort(new Error('enough')),
    });
    const reason = await stopped.catch((error: Error) => error.message);
    const early = await warp
      .toBlob({ scale: 1, signal: controller.signal })
      .catch((error: Error) => error.message);
    return [fractions, [reason, early], (await warp.toBlob({ scale: 0.1 })).size] as const;
  });
  expect(fractions.length).toBeGreaterThan(5);
  expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
  expect(fractions.at(-1)).toBe(1);
  expect(reason).toEqual(['enough', 'enough']);
  expect(after).toBeGreaterThan(1000);
});

test('Escape and a button cancel an export without other changes', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  let downloads = 0;
  page.on('download', () => downloads++);
  const before = await page
    .locator('c2-warp')
    .evaluate((element) => JSON.stringify((element as C2Warp).project));
  for (const cancel of [() => page.keyboard.press('Escape'), () => editor.button('Cancel').click()]) {
    await replies.hold();
    await editor.pressExport();
    await expect(editor.solved).toContainText('Exporting 0 %');
    await expect(page.getByRole('progressbar', { name: 'Exporting' })).toHaveAttribute('aria-valuenow', '0');
    await cancel();
    // At once, although the solver has not answered.
    await expect(editor.solved).toContainText('mesh point');
    await expect(page.getByText('Export cancelled')).toBeAttached();
    await replies.release();
  }
  const after = await page
    .locator('c2-warp')
    .evaluate((element) => JSON.stringify((element as C2Warp).project));
  expect(after).toBe(before);
  await expect(editor.notice).toBeHidden();
  // The next export is whole.
  const { width, height } = decode(await bytes(await editor.exported()));
  expect([width, height, downloads]).toEqual([1024, 1280, 1]);
});

test('handles are solved and dragged while an export is under way', async ({ page }) => {
  const editor = await Editor.open(page);
  const order = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const order: string[] = [];
    const exported = warp.toBlob({ scale: 3 }).then(() => order.push('exported'));
    warp.addHandle({ kind: 'point', rest: [512, 700] });
    const { project } = warp;
    const solved = new Promise<void>((done) => {
      const look = () => {
        if (warp.shadowRoot?.querySelector('.solved')?.textContent?.includes('mesh point')) done();
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    }).then(() => order.push('solved'));
    await Promise.all([exported, solved]);
    return [...order, String(project.handles.length)];
  });
  expect(order).toEqual(['solved', 'exported', '6']);
  await expect(editor.handles).toHaveCount(6);
});

test('an export that would be too large is refused in plain words', async ({ page }) => {
  const editor = await Editor.open(page);
  await openPanel(editor);
  const size = panel(page).getByRole('spinbutton', { name: 'Size (%)' });
  await size.fill('1000');
  await size.press('Enter');
  await panel(page).getByRole('button', { name: 'Export PNG' }).click();
  await expect(editor.notice).toContainText('The export would be too large');
  await expect(editor.solved).toContainText('mesh point');
});

test('the panel opens by keys, and axe finds nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('Control+Shift+E');
  await expect(panel(page).getByRole('button', { name: 'Export PNG' })).toBeFocused();
  await choose(page, 'JPEG');
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  await expect(panel(page)).toBeHidden();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true });

  test('the panel is a sheet with targets for fingers, and an export can be cancelled', async ({ page }) => {
    const replies = await WorkerReplies.intercept(page);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto('/');
    const editor = new Editor(page);
    await expect(editor.handle('left hand')).toBeVisible();
    await editor.button('Export as …').tap();
    await panel(page).getByRole('button', { name: 'JPEG', exact: true }).tap();
    const sheet = await panel(page).boundingBox();
    expect(sheet && [sheet.x, sheet.x + sheet.width, sheet.y + sheet.height].every((side) => side >= 0)).toBe(
      true,
    );
    expect((sheet?.x ?? 0) + (sheet?.width ?? 999)).toBeLessThanOrEqual(390);
    expect((sheet?.y ?? 0) + (sheet?.height ?? 999)).toBeLessThanOrEqual(760);
    const targets = panel(page).locator('button, [type=range], [type=color], .field');
    for (const target of await targets.all()) {
      expect((await target.boundingBox())?.height).toBeGreaterThanOrEqual(44);
    }
    await replies.hold();
    await panel(page).getByRole('button', { name: 'Export JPEG' }).tap();
    await editor.button('Cancel').tap();
    await expect(page.getByText('Export cancelled')).toBeAttached();
    await replies.release();
  });
});

/** Hides everything above the picture. Adopted, since the policy of the page forbids style elements. */
const hideCards = (page: Page, hidden: boolean) =>
  page.evaluate((hidden) => {
    const bare = new CSSStyleSheet();
    const parts = ['hint', 'notice', 'panel', 'tools'].map((part) => `c2-warp::part(${part})`);
    bare.replaceSync(`${parts.join()} { visibility: hidden }`);
    document.adoptedStyleSheets = hidden ? [bare] : [];
  }, hidden);

test('the preview of pixel art shows the pixels of the export', async ({ page }) => {
  const editor = await Editor.open(page);
  const [width, height] = [40, 48];
  const rgba = new Uint8Array(width * height * 4);
  const colours = [
    [200, 60, 40, 255],
    [240, 200, 60, 255],
    [40, 60, 90, 255],
  ] as const;
  for (let y = 4; y < height - 4; y++)
    for (let x = 8; x < width - 8; x++) rgba.set(colours[(x + y) % 3] ?? [], (y * width + x) * 4);
  const buffer = Buffer.from(encode({ width, height, data: rgba, channels: 4 }));
  await editor.chooseFile({ name: 'sprite.png', mimeType: 'image/png', buffer });
  await expect(editor.switch('Pixel art')).toBeChecked();
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.addHandle({ kind: 'point', id: 'foot', rest: [20, 42] });
    warp.addHandle({ kind: 'point', id: 'head', rest: [20, 6], posed: [26, 9], rotation: 25 });
    warp.selection = [];
  });
  await expect(editor.solved).toContainText('mesh point');
  for (const percent of [100, 200]) {
    await openPanel(editor);
    const size = panel(page).getByRole('spinbutton', { name: 'Size (%)' });
    await size.fill(String(percent));
    await size.press('Enter');
    const exported = decode(await bytes(await exportedFromPanel(page, 'PNG')));
    expect(exported.width).toBe((width * percent) / 100);
    await expect(panel(page)).toBeHidden();
    await editor.button('Dismiss').click();
    await editor.page.locator('c2-warp').evaluate((element) => (element as C2Warp).focus());
    await page.keyboard.down('w');
    await editor.waitFrames();
    await hideCards(page, true);
    const screen = decode(await page.screenshot());
    await hideCards(page, false);
    await page.keyboard.up('w');
    const centres = await page.locator('c2-warp').evaluate(
      (element, [width, height, percent]) => {
        const warp = element as C2Warp;
        return Array.from({ length: width * height }, (_, at) =>
          warp.imageToClient([
            ((at % width) + 0.5) * (100 / percent),
            (Math.floor(at / width) + 0.5) * (100 / percent),
          ]),
        );
      },
      [exported.width, exported.height, percent] as const,
    );
    let [opaque, different] = [0, 0];
    for (const [at, centre] of centres.entries()) {
      if (!centre) throw new Error('no picture is open');
      const shown = (Math.floor(centre[1]) * screen.width + Math.floor(centre[0])) * screen.channels;
      const [own, other] = [exported.data, screen.data];
      const isOpaque = own[at * 4 + 3] === 255;
      const same = [0, 1, 2].every((channel) => own[at * 4 + channel] === other[shown + channel]);
      const isColour = colours.some((colour) => [0, 1, 2].every((c) => colour[c] === other[shown + c]));
      opaque += isOpaque ? 1 : 0;
      if (isOpaque ? !same : isColour) different += 1;
    }
    expect(opaque).toBeGreaterThan(500);
    // The graphics card rounds corners of triangles.
    expect(different).toBeLessThan(0.01 * opaque);
  }
});
