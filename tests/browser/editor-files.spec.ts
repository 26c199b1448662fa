/** Opening, saving, exporting, restoring after a reload, and rejected files. */
import { mkdir } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { decode, encode } from 'fast-png';
import type { Handle } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { bytes, Editor, meanDifference, SAME } from './editor';
import { bring, disc, png, project } from './files';
import { expect, test } from './fixtures';
import { denyPictureWorker } from './picture_worker';
import { WorkerReplies } from './worker_replies';

test('a saved project opens exactly as it was', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 30, y: -50 });
  const told = await editor.settled(() => editor.shownPose('right hand'));
  const saved = await editor.download('Save the project file');
  expect(saved.suggestedFilename()).toBe('gingerbread.c2warp.json');
  const text = (await bytes(saved)).toString();
  expect(JSON.parse(text)).toMatchObject({
    format: 'c2warp/1',
    image: { src: 'gingerbread.png', width: 1024, height: 1280 },
  });

  await editor.button('Reset all handles').click();
  await editor.chooseFile(project(text, 'gingerbread.c2warp.json'));
  await expect(editor.button('Undo: open gingerbread.c2warp.json')).toBeEnabled();
  await expect.poll(() => editor.shownPose('right hand')).toEqual(told);
  expect((await bytes(await editor.download('Save the project file'))).toString()).toBe(text);
});

test('a PNG export is warped, at full size, with alpha', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 0, y: -80 });
  const exported = await editor.exported();
  expect(exported.suggestedFilename()).toBe('gingerbread-warped.png');
  const { width, height, channels, data } = decode(await bytes(exported));
  expect([width, height, channels]).toEqual([1024, 1280, 4]);
  const alpha = (x: number, y: number) => data[(Math.round(y) * width + Math.round(x)) * 4 + 3];
  const hand = await editor.settled(() => editor.shownPose('right hand'));
  expect(alpha(hand.x, hand.y)).toBe(255);
  expect(alpha(900, 560)).toBe(0);
  expect(alpha(2, 2)).toBe(0);
});

/** Returns a picture with a centred, striped rectangle in three colours. */
function sprite(width: number, height: number): Buffer {
  const data = new Uint8Array(width * height * 4);
  const colours = [
    [200, 60, 40, 255],
    [240, 200, 60, 255],
    [40, 60, 90, 255],
  ] as const;
  for (let y = 4; y < height - 4; y++) {
    for (let x = 12; x < width - 12; x++) data.set(colours[(x + y) % 3] ?? [], (y * width + x) * 4);
  }
  return Buffer.from(encode({ width, height, data, channels: 4 }));
}

test('pixel art keeps its colours in exports, unless switched off', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.chooseFile(png('sprite.png', sprite(40, 48)));
  const pixelArt = editor.switch('Pixel art');
  await expect(pixelArt).toBeChecked();
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.addHandle({ kind: 'point', id: 'foot', rest: [20, 42] });
    warp.addHandle({ kind: 'point', id: 'head', rest: [20, 6], posed: [27, 9] });
    warp.selection = [];
  });
  await expect(editor.solved).toContainText('mesh point');
  const colours = (rgba: ArrayLike<number>) => {
    const found = new Set<string>();
    for (let at = 0; at < rgba.length; at += 4)
      found.add(
        Array.from(rgba)
          .slice(at, at + 4)
          .join(),
      );
    return found;
  };
  const exported = async () => colours(decode(await bytes(await editor.exported())).data);
  const hard = new Set(['0,0,0,0', '200,60,40,255', '240,200,60,255', '40,60,90,255']);
  expect(await exported()).toEqual(hard);

  await pixelArt.uncheck();
  expect((await exported()).size).toBeGreaterThan(50);
  await expect.poll(() => editor.storedWork()).toMatchObject({ pixelated: false, picture: 'sprite.png' });
  await page.reload();
  await expect(editor.handle('head')).toBeVisible();
  await expect(pixelArt).not.toBeChecked();
  // Set by the page's attribute, then by its script.
  const blob = (options?: { pixelated: boolean }) =>
    page.locator('c2-warp').evaluate(async (element, options) => {
      const file = await (element as C2Warp).toBlob(options);
      return Array.from(new Uint8Array(await file.arrayBuffer()));
    }, options);
  const ofBlob = async (options?: { pixelated: boolean }) =>
    colours(decode(Uint8Array.from(await blob(options))).data);
  expect(await ofBlob({ pixelated: true })).toEqual(hard);
  await page.locator('c2-warp').evaluate((element) => {
    (element as HTMLElement).style.imageRendering = 'pixelated';
  });
  expect(await ofBlob()).toEqual(hard);
  expect((await ofBlob({ pixelated: false })).size).toBeGreaterThan(50);
});

test('the first PNG export works offline', async ({ page, context }) => {
  const editor = await Editor.open(page);
  await page.waitForLoadState('networkidle');
  await context.setOffline(true);
  const { width, height } = decode(await bytes(await editor.exported()));
  expect([width, height]).toEqual([1024, 1280]);
});

test('parts beyond the frame are shown, fitted, and reported as cut off', async ({ page }) => {
  const editor = await Editor.open(page);
  const [frame, told] = [page.locator('c2-warp .frame'), page.getByText('were cut off')];
  await editor.dragHandle('right hand', { x: 0, y: -30 });
  await editor.exported();
  await expect(editor.solved).toContainText('mesh point');
  await expect(frame).toHaveCount(0);
  await expect(told).toBeHidden();

  await editor.dragHandle('right hand', { x: 140, y: 30 });
  await expect(frame).toBeVisible();
  const { width } = decode(await bytes(await editor.exported()));
  expect(width).toBe(1024);
  await expect(told).toBeVisible();

  const [download] = await Promise.all([
    page.waitForEvent('download'),
    editor.button('Export the whole picture').click(),
  ]);
  await expect(told).toBeHidden();
  const all = decode(await bytes(download));
  expect(all.height).toBe(1280);
  expect(all.width).toBeGreaterThan(1024 + 50);
  // Nothing extends to the left of the frame, and the last column holds a part of the hand.
  const alphas = Array.from(
    { length: all.height },
    (_, y) => all.data[(y * all.width + all.width - 1) * 4 + 3],
  );
  expect(Math.max(...alphas.map(Number))).toBeGreaterThan(0);

  await editor.dragHandle('head', { x: 0, y: -170 });
  const top = page.locator('c2-warp .top');
  await page.keyboard.press('0');
  const [head, bar] = [await editor.position('head'), await top.boundingBox()];
  expect(head.y).toBeGreaterThan((bar?.y ?? 0) + (bar?.height ?? 0));
  expect(head.y).toBeLessThan(700);
  await editor.button('Reset all handles').click();
  await expect(frame).toHaveCount(0);
});

test('a short notice ends the offer to reopen earlier work, which stays in the list', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: -10, y: -40 });
  await page.locator('c2-warp').evaluate(async (element) => {
    const canvas = new OffscreenCanvas(64, 8);
    canvas.getContext('2d')?.fillRect(0, 0, 64, 64);
    const file = new File([await canvas.convertToBlob()], 'other.png', { type: 'image/png' });
    const transfer = new DataTransfer();
    transfer.items.add(file);
    element.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
  });
  const back = editor.button(/^Back to/);
  await expect(back).toBeVisible();
  // The page answers at once, since the notice disappears after a few seconds.
  const said = page.locator('c2-warp').evaluate(
    ({ shadowRoot: root }) =>
      new Promise<string>((done) => {
        const look = new MutationObserver(() => {
          const notice = root?.querySelector('.notice')?.textContent ?? '';
          if (!notice.includes('Place the handle on the picture')) return;
          look.disconnect();
          const key = { key: 'Escape', bubbles: true, composed: true, cancelable: true };
          (root?.activeElement ?? root?.querySelector('.stage'))?.dispatchEvent(
            new KeyboardEvent('keydown', key),
          );
          done(notice);
        });
        if (root) look.observe(root, { subtree: true, childList: true, characterData: true });
      }),
  );
  await editor.button('Add a point handle').click();
  await page.mouse.click(100, 600);
  expect(await said).not.toContain('Back to');
  await expect(page.getByText('Place the handle on the picture')).toBeHidden();
  await expect(back).toBeHidden();
  await editor.openRecent('gingerbread.png');
  await expect(editor.handle('right hand')).toBeVisible();
});

test('a soft shadow belongs to the picture', async ({ page }) => {
  const editor = await Editor.open(page);
  const left = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const canvas = new OffscreenCanvas(200, 200);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('no canvas');
    [context.shadowBlur, context.shadowColor] = [40, 'black'];
    context.arc(100, 100, 40, 0, 7);
    context.fill();
    const seen = async (source: ImageBitmapSource) => {
      const drawn = new OffscreenCanvas(200, 200).getContext('2d');
      drawn?.drawImage(await createImageBitmap(source), 0, 0);
      const { data } = drawn?.getImageData(0, 0, 200, 200) ?? { data: [] };
      return Array.from(data).filter((value, k) => k % 4 === 3 && value > 8).length;
    };
    const file = await canvas.convertToBlob();
    await warp.load(file);
    return (await seen(await warp.toBlob())) / (await seen(file));
  });
  expect(left).toBeGreaterThan(0.99);
  await expect(editor.handles).toHaveCount(0);
});

test('a reload restores picture, pose and history', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.chooseFile(png('disc.png', disc(96)));
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
  await expect(editor.status).toContainText('96 × 96 px');
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  await expect(editor.handles).toHaveCount(1);
  await page.keyboard.press('ArrowRight');
  const told = await editor.settled(() => editor.shownPose('handle 1'));

  const work = {
    picture: 'disc.png',
    step: 'Move handle 1',
    handles: [expect.objectContaining({ posed: [told.x, told.y] })],
  };
  await expect.poll(() => editor.storedWork()).toMatchObject(work);
  await page.reload();
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
  await expect(editor.handles).toHaveCount(1);
  await expect.poll(() => editor.shownPose('handle 1')).toEqual(told);
  await editor.button('Undo: move handle 1').click();
  await editor.button('Undo: add handle').click();
  await expect(editor.handles).toHaveCount(0);
  await editor.button('Redo: add handle').click();
  await expect(editor.handles).toHaveCount(1);
});

test('full storage is reported once, and again after a success', async ({ page }) => {
  await page.addInitScript(() => {
    const { put } = IDBObjectStore.prototype;
    IDBObjectStore.prototype.put = function (...given) {
      if (Reflect.get(globalThis, 'full')) throw new DOMException('no room', 'QuotaExceededError');
      return put.apply(this, given);
    };
  });
  const full = (is: boolean) => page.evaluate((is) => Object.assign(globalThis, { full: is }), is);
  const editor = await Editor.open(page);
  const dismiss = editor.button('Dismiss');
  await full(true);
  // An opened picture without edits is no loss.
  await editor.chooseFile(png('disc.png', disc(96)));
  await expect(editor.status).toContainText('96 × 96 px');
  await page.keyboard.press('p');
  await expect(editor.notice).toBeHidden();
  await page.keyboard.press('Enter');
  await expect(editor.notice).toContainText('This browser cannot store your work');
  await dismiss.click();
  await page.keyboard.press('ArrowRight');
  await editor.waitFrames();
  await expect(editor.notice).toBeHidden();
  await full(false);
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => editor.storedWork()).toMatchObject({ picture: 'disc.png', step: 'Move handle 1' });
  await full(true);
  await page.keyboard.press('ArrowRight');
  await expect(editor.notice).toContainText('Save the project before you leave');
});

/** Makes the browser fail to decode pictures this many times, from the next page load on. */
const undecoded = async (page: Page, times: number) => {
  await denyPictureWorker(page);
  await page.addInitScript((times) => {
    const { createImageBitmap } = globalThis;
    let left = times;
    globalThis.createImageBitmap = (async (...given: [ImageBitmapSource]) => {
      if (given[0] instanceof Blob && given[0].size > 2000 && left-- > 0) throw new DOMException('no memory');
      return createImageBitmap(...given);
    }) as typeof createImageBitmap;
  }, times);
};

test('stored work that fails to open is reported, and opens later', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  await expect.poll(() => editor.storedWork()).toMatchObject({ step: 'Move left hand' });
  await undecoded(page, 1);
  await page.reload();
  await expect(editor.notice).toContainText('gingerbread.png: The picture is damaged');
  await editor.ready();
  expect(await editor.shownPose('left hand')).not.toEqual(told);
  // The sample shown instead does not overwrite the stored work.
  await editor.handle('head').click();
  expect(await editor.storedWork()).toMatchObject({ step: 'Move left hand' });
  await editor.notice.getByRole('button', { name: 'Dismiss' }).click();
  await editor.openRecent('gingerbread.png');
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
});

test('a file dropped while work is being restored loses nothing', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  const kept = { picture: 'gingerbread.png', step: 'Move left hand' };
  await expect.poll(() => editor.storedWork()).toMatchObject(kept);
  await replies.hold();
  await page.reload();
  await expect(page.getByText('gingerbread.png', { exact: true })).toBeVisible();
  await bring(editor, 'drop', png('words.png', Buffer.from('these are words')));
  await expect(editor.notice).toContainText('words.png');
  await replies.release();
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  expect(await editor.storedWork()).toMatchObject(kept);

  await replies.hold();
  await page.reload();
  await expect(page.getByText('gingerbread.png', { exact: true })).toBeVisible();
  await bring(editor, 'drop', png('disc.png', disc(96)));
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
  await replies.release();
  await expect(editor.status).toContainText('96 × 96 px');
  await expect.poll(() => editor.storedWork()).toMatchObject({ picture: 'disc.png' });
  // The offer to reopen survives a reload.
  await page.reload();
  await expect(editor.status).toContainText('96 × 96 px');
  await editor.button('Back to gingerbread.png').click();
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
});

test('the fold guard stays on after a reload and a move', async ({ page }) => {
  const editor = await Editor.open(page);
  const guard = editor.switch('Stop at folds');
  const stays = async (as: boolean) => {
    await expect.poll(() => editor.storedWork()).toMatchObject({ guarded: as });
    await page.reload();
    await editor.ready();
    await expect(guard).toBeChecked({ checked: as });
  };
  await guard.check();
  await stays(true);
  await page.evaluate(() => {
    const frame = document.createElement('div');
    document.body.append(frame);
    frame.append(document.querySelector('c2-warp') as Element);
  });
  await editor.ready();
  await expect(guard).toBeChecked();
  await guard.uncheck();
  await stays(false);
});

test('the last change of two tabs is restored completely', async ({ page }) => {
  // The first tab continues with another picture.
  const [first, second] = await Editor.openTwice(page);
  await second.handle('head').click();
  await expect.poll(() => second.storedWork()).toMatchObject({ selection: ['head'] });
  await first.chooseFile(png('disc.png', disc(96)));
  await expect(first.status).toContainText('96 × 96 px');
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  // The selection is written last: this tab writes nothing after it.
  const work = { picture: 'disc.png', step: 'Add handle', selection: ['handle-1'] };
  await expect.poll(() => first.storedWork()).toMatchObject(work);
  await second.dragHandle('right hand', { x: -20, y: -40 });
  const later = { picture: 'gingerbread.png', step: 'Move right hand' };
  await expect.poll(() => second.storedWork()).toMatchObject(later);
  const told = page.getByText('Another tab also changed this work');
  await expect(told).toBeVisible();
  for (const tab of [page, second.page]) {
    await tab.reload();
    const editor = new Editor(tab);
    await expect(editor.handles).toHaveCount(5);
    await expect(editor.button('Undo: move right hand')).toBeEnabled();
  }
});

test('after a reload, reverting a rejected step keeps earlier work', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  await replies.hold();
  // Two bars that nearly touch need too many sites.
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const close = [560, 560.05].map((y, i): Handle => {
      const line: [number, number][] = [200, 800].map((x) => [x, y]);
      return { id: `close-${i}`, kind: 'bar', rest: line, posed: line, rotation: 'auto', scale: 1, depth: 0 };
    });
    const { project } = warp;
    warp.project = { ...project, handles: [...project.handles, ...close] };
  });
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(7);
  await page.reload();
  // Each bar counts three times: itself and its two corners.
  await expect(editor.handles).toHaveCount(11);
  await replies.release();
  await expect(editor.notice).toContainText('too close together', { timeout: 60_000 });
  await expect(editor.handles).toHaveCount(5);
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await expect(page.getByRole('progressbar')).toBeHidden();

  // The rejected step does not come back.
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(5);
  await page.reload();
  await editor.ready();
  await expect(editor.handles).toHaveCount(5);
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await expect(editor.notice).toBeHidden();
});

test('after a reload, reverting a rejected handle keeps later work', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await replies.hold();
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.addHandle({ id: 'stray', kind: 'point', rest: [124, 516.001] });
    warp.addHandle({ id: 'heart', kind: 'point', rest: [512, 600] });
  });
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(7);
  await page.reload();
  await expect(editor.handles).toHaveCount(7);
  await replies.release();
  await expect(editor.notice).toContainText('stray');
  await expect(editor.handles).toHaveCount(6);
  await expect(editor.handle('heart')).toBeVisible();
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(6);
  await editor.button('Undo: add handle').click();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

for (const event of ['drop', 'paste'] as const) {
  test(`${event} opens a picture, and the earlier work can be reopened`, async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.dragHandle('left hand', { x: 20, y: -40 });
    const told = await editor.settled(() => editor.shownPose('left hand'));
    await bring(editor, event, png('disc.png', disc(64)));
    await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
    await expect(editor.handles).toHaveCount(0);
    await editor.button('Back to gingerbread.png').click();
    await expect(editor.handles).toHaveCount(5);
    // The automatic turn of the hand is known after the next solve.
    await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  });
}

test('notices with an action keep words whole in narrow windows', async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 480 });
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 10, y: -20 });
  await bring(editor, 'drop', png('gingerbread-2.png', disc(64)));
  const words = page.getByText('gingerbread-2.png is open.');
  await expect(words).toBeVisible();
  // Two lines: the name, and the message.
  const lines = await words.evaluate(
    (p) => p.clientHeight / Number.parseFloat(getComputedStyle(p).lineHeight),
  );
  expect(Math.round(lines)).toBeLessThan(3);
});

test('readonly and disabled editors do not reopen earlier work', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await bring(editor, 'drop', png('disc.png', disc(64)));
  const back = editor.button('Back to gingerbread.png');
  const at = await editor.centre(back);
  for (const attribute of ['readonly', 'disabled']) {
    await back.focus();
    await warp.evaluate((element, name) => element.setAttribute(name, ''), attribute);
    await page.keyboard.press('Enter');
    await page.mouse.click(at.x, at.y);
    await expect(editor.handles).toHaveCount(0);
    await expect(page.getByText('disc.png is open.')).toBeVisible();
    await warp.evaluate((element, name) => element.removeAttribute(name), attribute);
  }
  await back.click();
  await expect(editor.handles).toHaveCount(5);
});

test('each of two edited pictures offers to reopen the other', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  await bring(editor, 'drop', png('disc.png', disc(64)));
  await expect(editor.button('Back to gingerbread.png')).toBeVisible();
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  await expect(editor.handle('handle 1')).toBeVisible();
  // The edit has ended the offer.
  await expect(editor.button(/^Back to/)).toBeHidden();
  await editor.openRecent('gingerbread.png');
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await expect(page.getByText('gingerbread.png is open.', { exact: true })).toBeVisible();
  await editor.button('Back to disc.png').click();
  await expect(editor.handles).toHaveCount(1);
  // The next edit ends the offer, and the work stays in the list.
  await editor.button('Undo: add handle').click();
  await expect(editor.handles).toHaveCount(0);
  await expect(editor.button(/^Back to/)).toBeHidden();
  await editor.openRecent('gingerbread.png');
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await expect(editor.button(/^Back to/)).toBeHidden();
});

test('earlier work stays in the list through unedited and rejected pictures', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  for (const name of ['wrong.png', 'right.png']) {
    await bring(editor, 'drop', png(name, disc(64)));
    await expect(page.getByText(`${name} is open.`)).toBeVisible();
  }
  // The picture is shown until the solver rejects it.
  await bring(editor, 'drop', png('clear.png', disc(64, 0)));
  await editor.notice.getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.getByText('right.png', { exact: true })).toBeVisible();
  await editor.openRecent('gingerbread.png');
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
});

test('a rejected picture keeps the view and the draft', async ({ page }) => {
  const editor = await Editor.open(page);
  const refused = async () => {
    await bring(editor, 'drop', png('clear.png', disc(64, 0)));
    await expect(editor.notice).toContainText('clear.png');
    await editor.notice.getByRole('button', { name: 'Dismiss' }).click();
    await expect(editor.solved).toContainText('mesh point');
  };
  await editor.dragHandle('head', { x: 0, y: -170 });
  await page.keyboard.press('0');
  const fitted = await editor.zoom();
  await refused();
  expect(await editor.zoom()).toBe(fitted);

  await page.keyboard.press('g');
  const { x, y } = await editor.centre(page.locator('c2-warp canvas'));
  for (const [right, down] of [
    [0, 0],
    [60, 0],
    [30, 50],
  ] as const) {
    await page.mouse.click(x + right, y + down);
  }
  await page.keyboard.press('+');
  const [corners, last] = [
    page.locator('c2-warp .draft .corner'),
    page.locator('c2-warp .draft .corner').last(),
  ];
  await expect(corners).toHaveCount(3);
  const [zoom, at] = [await editor.zoom(), await editor.centre(last)];
  expect(zoom).toBeGreaterThan(fitted);
  await refused();
  await expect(corners).toHaveCount(3);
  expect(await editor.zoom()).toBe(zoom);
  expect(await editor.centre(last)).toEqual(at);
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: add polygon')).toBeVisible();
});

test('a moved element keeps reopen offer, draft, view and waiting project', async ({ page }) => {
  const editor = await Editor.open(page);
  const move = async () => {
    await page.locator('c2-warp').evaluate((element) => document.body.append(element));
    await expect(editor.solved).toContainText('mesh point');
  };
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  await bring(editor, 'drop', png('disc.png', disc(64)));
  await expect(editor.solved).toContainText('64 × 64 px');
  await page.keyboard.press('g');
  const { x, y } = await editor.centre(page.locator('c2-warp canvas'));
  const corners = page.locator('c2-warp .draft .corner');
  await page.mouse.click(x, y);
  await page.mouse.click(x + 30, y);
  await page.keyboard.press('+');
  const zoom = await editor.zoom();
  await move();
  await expect(corners).toHaveCount(2);
  expect(await editor.zoom()).toBe(zoom);
  await editor.button('Back to gingerbread.png').click();
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  // A draft counts as work too.
  await editor.button('Back to disc.png').click();
  await expect(corners).toHaveCount(2);
  await editor.button('Back to gingerbread.png').click();
  await expect(editor.handles).toHaveCount(5);

  const image = { src: 'other.png', width: 48, height: 48 };
  const handles = [{ id: 'middle', kind: 'point', rest: [24, 24], posed: [26, 24] }];
  await editor.chooseFile(project({ format: 'c2warp/1', image, handles }));
  await expect(page.getByText('belongs to the picture other.png')).toBeVisible();
  await move();
  await bring(editor, 'drop', png('other.png', disc(48)));
  await expect(editor.handle('middle')).toBeVisible();
});

test('the first of several pictures opens, and a notice names the others', async ({ page }) => {
  const editor = await Editor.open(page);
  await bring(editor, 'drop', png('one.png', disc(64)), png('two.png', disc(64)));
  await expect(page.getByText('two.png was not opened')).toBeVisible();
  await expect(page.getByText('one.png', { exact: true })).toBeVisible();
  await bring(editor, 'drop', png('two.png', disc(64)), png('one.png', disc(64)), png('three.png', disc(64)));
  await expect(page.getByText('one.png and 1 more were not opened')).toBeVisible();
});

test('a project without its picture asks for it, and opens with it', async ({ page }) => {
  const editor = await Editor.open(page);
  const other = {
    format: 'c2warp/1',
    image: { src: 'disc.png', width: 64, height: 64 },
    handles: [{ id: 'middle', kind: 'point', rest: [32, 32], posed: [36, 30] }],
  };
  await editor.chooseFile(project(other));
  await expect(page.getByText('belongs to the picture disc.png (64 × 64 px)')).toBeVisible();
  await expect(editor.handles).toHaveCount(5);
  // A wrong picture in between does not end the wait.
  await bring(editor, 'drop', png('wrong.png', disc(48)));
  await expect(editor.solved).toContainText('48 × 48 px');
  await expect(page.getByText('belongs to the picture disc.png (64 × 64 px)')).toBeVisible();
  const asked = page.waitForEvent('filechooser');
  await editor.button('Open picture').click();
  await (await asked).setFiles(png('disc.png', disc(64)));
  await expect.poll(() => editor.shownPose('middle')).toEqual({ x: 36, y: 30, rotation: 0 });
});

const sample = (handles: unknown[]) => ({
  format: 'c2warp/1',
  image: { src: 'gingerbread.png', width: 1024, height: 1280 },
  handles,
});
const at = (id: string, rest: unknown) => ({ id, kind: 'point', rest, posed: [512, 300] });

const REFUSED: [title: string, file: ReturnType<typeof png>, message: RegExp][] = [
  ['an empty file', png('empty.png', Buffer.alloc(0)), /empty\.png: The file is empty/],
  [
    'a text file',
    png('notes.txt', Buffer.from('no picture')),
    /notes\.txt: This browser cannot read the file as a picture/,
  ],
  ['a truncated picture', png('cut.png', disc(64).subarray(0, 200)), /cut\.png: The picture is incomplete/],
  ['one pixel', png('dot.png', disc(1)), /dot\.png: .*at least 2 × 2/],
  [
    'a picture without an opaque pixel',
    png('clear.png', disc(64, 0)),
    /clear\.png: no part of this picture is opaque enough to warp/,
  ],
  ['an empty project', project(' '), /other\.c2warp\.json: The file is empty/],
  ['a project with invalid JSON', project('{'), /other\.c2warp\.json: /],
  ['a wrong type', project(sample([at('a', ['512', 300])])), /handles\[0\]\.rest\[0\]/],
  ['an unknown key', project({ ...sample([]), colour: 'red' }), /colour/],
  ['a handle outside', project(sample([at('lost', [20, 20])])), /lost/],
  ['two handles on one spot', project(sample([at('a', [512, 300]), at('b', [512, 300])])), /"?a"?.*"?b"?/],
];

for (const [title, file, message] of REFUSED) {
  test(`${title} is rejected in a notice, and the work stays`, async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.dragHandle('left hand', { x: 20, y: -40 });
    const told = await editor.settled(() => editor.shownPose('left hand'));
    const hand = await editor.position('left hand');
    const before = await editor.screenshot(hand, 12);
    await editor.chooseFile(file);
    await expect(editor.notice).toContainText(message);
    await expect(editor.handles).toHaveCount(5);
    await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
    await expect
      .poll(async () => meanDifference(before, await editor.screenshot(hand, 12)))
      .toBeLessThan(SAME);
    await editor.notice.getByRole('button', { name: 'Dismiss' }).click();
    await expect(editor.notice).toBeHidden();
    await editor.button('Undo: move left hand').click();
    await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 124, y: 516 });
  });
}

for (const [title, name] of [
  ['a folder', 'some folder'],
  ['a folder with the name of a project', 'old.c2warp.json'],
] as const) {
  test(`${title} is rejected with a message about folders`, async ({ page }) => {
    const editor = await Editor.open(page);
    const folder = test.info().outputPath(name);
    await mkdir(folder, { recursive: true });
    const devtools = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder], dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await devtools.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
    await expect(editor.notice).toContainText(`${name}: Could not read the file. It is a folder`);
    await expect(editor.handles).toHaveCount(5);
  });
}

test('an empty editor has no original, and opens a picture by its button', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() =>
    document.querySelector('c2-warp')?.replaceWith(document.createElement('c2-warp')),
  );
  const open = page.getByRole('button', { name: 'Open a picture', exact: true });
  await page.locator('c2-warp .stage').focus();
  await page.keyboard.down('o');
  await editor.waitFrames();
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeHidden();
  await page.keyboard.up('o');
  for (const press of [() => open.click(), () => open.press('Enter'), () => open.press('Space')]) {
    const asked = page.waitForEvent('filechooser');
    await press();
    await asked;
  }
  const asked = page.waitForEvent('filechooser');
  await open.click();
  await (await asked).setFiles(png('disc.png', disc(96)));
  await expect(editor.status).toContainText('96 × 96 px');
});

test('an opened picture without edits is restored too', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.chooseFile(png('disc.png', disc(96)));
  await expect(editor.status).toContainText('96 × 96 px');
  await expect.poll(() => editor.storedWork()).toMatchObject({ picture: 'disc.png', step: null });
  await page.reload();
  await expect(editor.status).toContainText('96 × 96 px');
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
});
