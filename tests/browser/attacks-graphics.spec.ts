/** The graphics context is lost at random moments: in a drag, while a picture is opened, while one is exported. */
import { expect, type JSHandle } from '@playwright/test';
import { decode } from 'fast-png';
import { among } from '../../web/src/editor/random';
import { openWithHandle, randomIn, times } from './attacks';
import { bytes, Editor } from './editor';
import { test } from './fixtures';

const LOSSES = times(100, 6);
const SIDE = 96;
const GONE = 'The browser lost access to the graphics card';

type Loss = JSHandle<WEBGL_lose_context | null | undefined>;

/** Takes the graphics context away. */
async function lose({ page }: Editor): Promise<Loss> {
  const context = await page.locator('c2-warp').evaluateHandle((element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    return canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
  });
  await context.evaluate((context) => context?.loseContext());
  return context;
}

/** The actions during which the context is lost. Each returns once all of it has come to its end. */
const MOMENTS: Readonly<Record<string, (editor: Editor, random: () => number) => Promise<Loss>>> = {
  async 'in a drag'(editor, random) {
    const { mouse } = editor.page;
    const before = await editor.shownPose('handle 1');
    const { x, y } = await editor.position('handle 1');
    const step = before.x > SIDE / 2 ? -10 : 10;
    await mouse.move(x, y);
    await mouse.down();
    const at = Math.floor(random() * 4);
    let loss: Loss | undefined;
    for (let move = 0; move < 4; move++) {
      if (move === at) loss = await lose(editor);
      await mouse.move(x + (step * (move + 1)) / 4, y);
    }
    await mouse.up();
    await expect.poll(async () => (await editor.shownPose('handle 1')).x - before.x).not.toBe(0);
    return loss as Loss;
  },

  async 'while a picture is opened'(editor, random) {
    const name = `${Math.floor(random() * 1e9)}.png`;
    const [opened, loss] = await Promise.all([openWithHandle(editor, name, SIDE), lose(editor)]);
    expect(opened).toBeUndefined();
    return loss;
  },

  async 'while one is exported'(editor) {
    const started = editor.page.waitForEvent('download');
    const [, loss] = await Promise.all([editor.pressExport(), lose(editor)]);
    const { width, height } = decode(await bytes(await started));
    expect([width, height]).toEqual([SIDE, SIDE]);
    return loss;
  },
};

test('a context lost at random moments loses no work, and is reported in one sentence', async ({ page }) => {
  test.setTimeout(LOSSES * 20_000 + 120_000);
  const random = randomIn('graphics');
  const editor = await Editor.open(page);
  await openWithHandle(editor, 'first.png', SIDE);
  for (let count = 0; count < LOSSES; count++) {
    const moment = among(Object.keys(MOMENTS), random);
    await test.step(`${count}: ${moment}`, async () => {
      const loss = await MOMENTS[moment]?.(editor, random);
      await expect(editor.notice).toHaveCount(1);
      await expect(editor.notice).toContainText(GONE);
      const pose = await editor.shownPose('handle 1');
      await loss?.evaluate((context) => context?.restoreContext());
      await expect(editor.notice).toBeHidden();
      expect(await editor.shownPose('handle 1')).toEqual(pose);
      await expect.poll(() => drawsSomething(editor)).toBe(true);
    });
  }
});

/** Whether the stage shows the disc. */
async function drawsSomething(editor: Editor): Promise<boolean> {
  const { x, y } = await editor.centre(editor.page.locator('c2-warp .stage'));
  const { data, channels } = decode(await editor.screenshot({ x, y }, 8));
  const [red = 0, green = 0, blue = 0] = data.subarray(0, channels);
  return red > 150 && green < 120 && blue < 90;
}
