/** The rig of one picture on another: offered for dropped pictures, and for projects of another size. */
import { readFileSync } from 'node:fs';
import { decode, encode } from 'fast-png';
import { Editor } from './editor';
import { bring, png, project } from './files';
import { expect, test } from './fixtures';

/** The sample at half its size, at a place in a wider picture. */
function halfSample(at: readonly [number, number]): Buffer {
  const file = new URL('../../web/public/samples/gingerbread.png', import.meta.url);
  const { width, height, data } = decode(readFileSync(file));
  const [wide, high] = [width / 2 + 200, height / 2 + 120];
  const pixels = new Uint8Array(wide * high * 4);
  for (let y = 0; y < height / 2; y++) {
    for (let x = 0; x < width / 2; x++) {
      const from = (2 * y * width + 2 * x) * 4;
      pixels.set(data.slice(from, from + 4), ((y + at[1]) * wide + x + at[0]) * 4);
    }
  }
  return Buffer.from(encode({ width: wide, height: high, data: pixels, channels: 4 }));
}

test('a dropped picture takes the previous rig, aligned with its outline', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const before = await editor.projectHandle('left-hand');
  await bring(editor, 'drop', png('smaller.png', halfSample([150, 30])));
  await expect(editor.solved).toContainText('712 × 760 px');
  await expect(editor.handles).toHaveCount(0);
  await expect(page.getByText('smaller.png is open.')).toBeVisible();
  await expect(editor.button('Back to gingerbread.png')).toBeVisible();
  await editor.button('Use this rig').click();
  await expect(editor.handles).toHaveCount(5);
  const after = await editor.projectHandle('left-hand');
  for (const place of ['rest', 'posed'] as const) {
    const [x, y] = (before?.[place] ?? []) as readonly number[];
    const [toX, toY] = (after?.[place] ?? []) as readonly number[];
    expect(Math.abs(Number(toX) - (Number(x) / 2 + 150))).toBeLessThan(1);
    expect(Math.abs(Number(toY) - (Number(y) / 2 + 30))).toBeLessThan(1);
  }
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(0);
  await page.keyboard.press('Control+y');
  await expect(editor.handles).toHaveCount(5);

  // A project of another size: its rectangle is stretched onto this picture.
  const image = { src: 'owl.png', width: 89, height: 95 };
  const handles = [{ id: 'middle', kind: 'point', rest: [50, 50], posed: [51, 50] }];
  await bring(editor, 'drop', project({ format: 'c2warp/1', image, handles }));
  await expect(page.getByText('belongs to the picture owl.png (89 × 95 px)')).toBeVisible();
  await editor.button('Use this rig').click();
  await expect.poll(() => editor.shownPose('middle')).toMatchObject({ x: 408, y: 400 });
  await expect(page.getByText('belongs to the picture owl.png')).toBeHidden();
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(5);
});
