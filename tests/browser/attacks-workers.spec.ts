/** Workers end at random moments: while a handle is solved, a picture is opened, or one is exported. */
import { type Download, expect, test } from '@playwright/test';
import { decode } from 'fast-png';
import { among } from '../../web/src/editor/random';
import { randomIn, times } from './attacks';
import { bytes, Editor } from './editor';
import { disc, png } from './files';

const ENDS = times(100, 6);
const SIDE = 96;

/** Ends one of the page's workers by an error outside of every request, and returns its file. */
async function endWorker({ page }: Editor, random: () => number): Promise<string> {
  const workers = page.workers();
  if (workers.length === 0) return 'none';
  const worker = among(workers, random);
  // A worker that has just been replaced ends on its own.
  await worker
    .evaluate(() =>
      setTimeout(() => {
        throw new Error('ended by a test');
      }),
    )
    .catch(() => {});
  return worker.url();
}

/** Waits for a result, or for a notice in its place, which is one sentence. Returns whether the result came. */
async function resultOrNotice(editor: Editor, result: () => Promise<boolean>): Promise<boolean> {
  await expect.poll(async () => (await result()) || (await editor.notice.isVisible())).toBe(true);
  if (await result()) return true;
  await expect(editor.notice).toHaveCount(1);
  expect((await editor.notice.innerText()).trim()).toMatch(/^[^.]+\.?/);
  await editor.button('Dismiss').click();
  return false;
}

/** Opens a picture while a worker ends, and once more where that fails. */
async function open(editor: Editor, random: () => number): Promise<void> {
  const name = `${Math.floor(random() * 1e9)}.png`;
  const isOpen = () => editor.page.getByText(name, { exact: true }).isVisible();
  const choose = () => editor.chooseFile(png(name, disc(SIDE)));
  await Promise.all([choose(), endWorker(editor, random)]);
  if (!(await resultOrNotice(editor, isOpen))) {
    await choose();
    await expect.poll(isOpen).toBe(true);
  }
  await expect(editor.solved).toContainText(`${SIDE} × ${SIDE} px`);
}

/** The actions during which a worker ends. Each returns whether it came to its end, or a notice came instead. */
const MOMENTS: Readonly<Record<string, (editor: Editor, random: () => number) => Promise<boolean>>> = {
  async 'while a handle is solved'(editor, random) {
    const { page } = editor;
    const before = await editor.handles.count();
    const { x, y } = await editor.centre(page.locator('c2-warp .stage'));
    // Apart from the handles before it.
    const [turn, radius] = [before * 2.4, 50 + ((before * 60) % 150)];
    await page.keyboard.press('p');
    const placed = page.mouse.click(x + radius * Math.cos(turn), y + radius * Math.sin(turn));
    await Promise.all([placed, endWorker(editor, random)]);
    await page.keyboard.press('v');
    const isPlaced = await resultOrNotice(editor, async () => (await editor.handles.count()) > before);
    await expect(page.getByRole('progressbar')).toBeHidden();
    return isPlaced;
  },

  async 'while one is exported'(editor, random) {
    let file: Buffer | undefined;
    const keep = async (download: Download) => {
      file = await bytes(download);
    };
    editor.page.once('download', keep);
    await Promise.all([editor.pressExport(), endWorker(editor, random)]);
    const isExported = await resultOrNotice(editor, async () => file !== undefined);
    editor.page.off('download', keep);
    if (isExported) {
      const { width, height } = decode(file ?? Buffer.alloc(0));
      expect([width, height]).toEqual([SIDE, SIDE]);
    }
    return isExported;
  },
};

test('workers that end at random moments lose nothing, and are replaced', async ({ page }) => {
  test.setTimeout(ENDS * 30_000 + 120_000);
  const random = randomIn('workers');
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showOpenFilePicker'));
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showSaveFilePicker'));
  const editor = await Editor.open(page);
  await open(editor, random);
  for (let count = 0; count < ENDS; count++) {
    const moment = among([...Object.keys(MOMENTS), 'while a picture is opened'], random);
    await test.step(`${count}: ${moment}`, async () => {
      const before = await editor.handles.count();
      const isDone = await MOMENTS[moment]?.(editor, random);
      if (isDone !== undefined) expect(await editor.handles.count()).toBeGreaterThanOrEqual(before);
      // Once the worker that has the pixels is gone too, the picture must be opened again.
      if (!isDone) await open(editor, random);
    });
  }
});
