/** Pictures with transparency: their outline, its minimum opacity, and parts without a handle. */
import { encode } from 'fast-png';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { bring, png } from './files';
import { expect, test } from './fixtures';

/** A picture of `size` × `size` px with this alpha at each pixel. */
function picture(size: number, alpha: (x: number, y: number) => number): Buffer {
  const data = new Uint8Array(size * size * 4);
  for (let pixel = 0; pixel < size * size; pixel++) {
    data.set([60, 120, 80, alpha(pixel % size, Math.floor(pixel / size))], pixel * 4);
  }
  return Buffer.from(encode({ width: size, height: size, data, channels: 4 }));
}

async function opened(editor: Editor, name: string, buffer: Buffer): Promise<void> {
  await bring(editor, 'drop', png(name, buffer));
  await expect(editor.page.getByRole('application', { name: `Picture ${name}` })).toBeVisible();
  await expect(editor.solved).toContainText('mesh point');
}

/** Where the page shows a place of the picture, CSS pixels. */
const shown = (editor: Editor, x: number, y: number): Promise<readonly [number, number]> =>
  editor.page.locator('c2-warp').evaluate(
    (element, at) => {
      const place = (element as C2Warp).imageToClient(at);
      if (!place) throw new Error('no picture is shown');
      return place;
    },
    [x, y] as const,
  );

async function placeHandle(editor: Editor, x: number, y: number): Promise<void> {
  await editor.page.keyboard.press('p');
  const at = await shown(editor, x, y);
  await editor.waitForSolve(() => editor.page.mouse.click(...at));
}

/** Unfolds the settings of bending, which a selection folds. */
const unfold = (editor: Editor): Promise<void> =>
  editor.page.locator('c2-warp summary').filter({ hasText: 'Bending' }).click();

test('a picture of thousands of dots opens, says what bends together, and bends', async ({ page }) => {
  const editor = await Editor.open(page);
  // Some 15,600 dots.
  const dots = picture(1000, (x, y) => (Math.hypot((x % 8) - 3.5, (y % 8) - 3.5) < 3 ? 255 : 0));
  await opened(editor, 'dots.png', dots);
  await expect(page.getByText(/too fine to follow: parts up to \d+ pixels apart bend/)).toBeVisible();
  await placeHandle(editor, 500, 800);
  await placeHandle(editor, 500, 200);
  await page.keyboard.press('v');
  await editor.dragHandle('handle 2', { x: 60, y: -10 });
  await expect.poll(() => editor.mappedDistance([500, 200], [500, 200])).toBeGreaterThan(20);
});

test('parts without a handle follow if the setting is on', async ({ page }) => {
  const editor = await Editor.open(page);
  // Three squares in a row.
  const isSquare = (x: number, y: number) => x % 100 < 80 && x % 100 > 20 && y > 120 && y < 180;
  await opened(
    editor,
    'squares.png',
    picture(300, (x, y) => (isSquare(x, y) ? 255 : 0)),
  );
  await placeHandle(editor, 150, 150);
  await expect(page.getByText('2 parts have no handle and stay in place.')).toBeVisible();
  await editor.button('Let them follow').click();
  await unfold(editor);
  await expect(editor.switch('Loose parts follow')).toBeChecked();
  await page.keyboard.press('v');
  await editor.dragHandle('handle 1', { x: 0, y: -40 });
  // A point of the first square.
  await expect.poll(() => editor.mappedDistance([50, 150], [50, 150])).toBeGreaterThan(10);
});

test('the boundary of a soft shadow is held, and the figure inside bends', async ({ page }) => {
  const editor = await Editor.open(page);
  const shadow = (x: number, y: number) => {
    const out = Math.hypot(x - 450, y - 450) - 150;
    return out < 0 ? 255 : 120 * Math.exp((-out * out) / 20000);
  };
  await opened(editor, 'shadow.png', picture(900, shadow));
  await placeHandle(editor, 450, 450);
  await unfold(editor);
  await editor.waitForSolve(() => editor.switch('Lock the outline').check());
  await page.keyboard.press('v');
  await editor.dragHandle('handle 1', { x: 40, y: 0 });
  await expect.poll(() => editor.mappedDistance([450, 450], [450, 450])).toBeGreaterThan(20);
  await expect(page.getByText('The step was undone')).toHaveCount(0);
});

test('the least opacity is set with the outline on the stage, a drag in one step', async ({ page }) => {
  const editor = await Editor.open(page);
  await opened(
    editor,
    'soft.png',
    picture(300, (x, y) => Math.max(0, 255 - 2 * Math.hypot(x - 150, y - 150))),
  );
  const outline = page.locator('c2-warp path.outline:not(.pale)');
  await editor.button('All settings').click();
  const slider = page.getByRole('slider', { name: 'Minimum opacity' });
  await expect(outline).toHaveCount(0);
  await slider.focus();
  const first = await outline.getAttribute('d');
  await slider.fill('0.6');
  await expect.poll(() => outline.getAttribute('d')).not.toBe(first);
  await editor.button('Undo: set the minimum opacity').click();
  await slider.focus();
  await expect.poll(() => outline.getAttribute('d')).toBe(first);
  await slider.blur();
  await expect(outline).toHaveCount(0);
});
