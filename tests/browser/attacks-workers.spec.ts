/** Workers end at random moments: while a handle is solved, a picture is opened, or one is exported. */
import { expect, test } from '@playwright/test';
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
  // A worker that has just been replaced is gone by itself.
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

const MOMENTS: Readonly<Record<string, (editor: Editor, random: () => number) => Promise<void>>> = {
  async 'while a handle is solved'(editor, random) {
    const { page } = editor;
    const before = await editor.handles.count();
    const { x, y } = await editor.centre(page.locator('c2-warp .stage'));
    const turn = random() * 2 * Math.PI;
    await page.keyboard.press('p');
    const placed = page.mouse.click(x + 60 * Math.cos(turn), y + 60 * Math.sin(turn));
    await Promise.all([placed, endWorker(editor, random)]);
    await page.keyboard.press('v');
    await resultOrNotice(editor, async () => (await editor.handles.count()) > before);
    await expect(page.getByRole('progressbar')).toBeHidden();
  },

  async 'while a picture is opened'(editor, random) {
    const name = `${Math.floor(random() * 1e9)}.png`;
    const isOpen = () => editor.page.getByText(name, { exact: true }).isVisible();
    const open = () => editor.chooseFile(png(name, disc(SIDE)));
    await Promise.all([open(), endWorker(editor, random)]);
    if (!(await resultOrNotice(editor, isOpen))) {
      await open();
      await expect.poll(isOpen).toBe(true);
    }
    await expect(editor.solved).toContainText(`${SIDE} × ${SIDE} px`);
  },

  async 'while one is exported'(editor, random) {
    let download: Buffer | undefined;
    const arrives = editor.page.waitForEvent('download', { timeout: 60_000 }).then(
      async (arrived) => {
        download = await bytes(arrived);
      },
      () => {},
    );
    await Promise.all([editor.pressExport(), endWorker(editor, random)]);
    if (!(await resultOrNotice(editor, async () => download !== undefined))) {
      await editor.pressExport();
    }
    await arrives;
    const { width, height } = decode(download ?? Buffer.alloc(0));
    expect([width, height]).toEqual([SIDE, SIDE]);
  },
};

test('workers that end at random moments lose nothing, and are replaced', async ({ page }) => {
  test.setTimeout(ENDS * 30_000 + 120_000);
  const random = randomIn('workers');
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showOpenFilePicker'));
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'showSaveFilePicker'));
  const editor = await Editor.open(page);
  await MOMENTS['while a picture is opened']?.(editor, random);
  for (let count = 0; count < ENDS; count++) {
    const moment = among(Object.keys(MOMENTS), random);
    await test.step(`${count}: ${moment}`, async () => {
      const before = await editor.handles.count();
      await MOMENTS[moment]?.(editor, random);
      if (moment !== 'while a picture is opened') {
        expect(await editor.handles.count()).toBeGreaterThanOrEqual(before);
      }
    });
  }
});
