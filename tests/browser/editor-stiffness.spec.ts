/** The brush that paints how stiff the picture is: the overlay, the pose, undo, keys, phones, and the file. */
import { bytes, Editor, meanDifference, type Position, SAME } from './editor';
import { expect, test } from './fixtures';

interface Mask {
  readonly width: number;
  readonly height: number;
  readonly values: string;
}

const mask = ({ page }: Editor): Promise<Mask | undefined> =>
  page.evaluate(() => document.querySelector('c2-warp')?.project.stiffness);

/** How stiff a place of the sample is, from 0 to 1. */
async function stiffnessAt(editor: Editor, x: number, y: number): Promise<number> {
  const found = await mask(editor);
  if (!found) return 0;
  const { width, height, values } = found;
  const [column, row] = [Math.floor((x * width) / 1024), Math.floor((y * height) / 1280)];
  return (Buffer.from(values, 'base64')[row * width + column] ?? -1) / 255;
}

async function stroke({ page }: Editor, path: readonly Position[]): Promise<void> {
  const [first] = path;
  if (!first) return;
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  for (const { x, y } of path.slice(1)) await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up();
}

test('a painted arm keeps its form; undo takes back one stroke at a time', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await editor.dragHandle('left hand', { x: 60, y: -110 });
  const elbow = await editor.settled(() => editor.mapped(260, 470));
  await page.keyboard.press('f');
  await editor.button('Stiffen').click();
  await expect(editor.button('Brush')).toHaveAttribute('aria-pressed', 'true');
  const before = await editor.screenshot(at(512, 640));

  // The trunk is unbent, so that places of the original lie under the pointer.
  await stroke(editor, [at(440, 640), at(600, 640)]);
  await expect(editor.button('Undo: paint stiffness')).toBeEnabled();
  expect(await stiffnessAt(editor, 512, 640)).toBe(1);
  expect(await stiffnessAt(editor, 512, 1000)).toBe(0);
  // The colour of the mask is shown with the brush.
  await expect
    .poll(async () => meanDifference(before, await editor.screenshot(at(512, 640))))
    .toBeGreaterThan(10);
  await stroke(editor, [at(300, 480), at(400, 520), at(512, 560)]);
  // The pose changes without a solve.
  await expect.poll(() => editor.mappedDistance([260, 470], elbow ?? [0, 0])).toBeGreaterThan(0.5);

  await editor.button('Undo: paint stiffness').click();
  expect(await stiffnessAt(editor, 512, 640)).toBe(1);
  await editor.button('Undo: paint stiffness').click();
  expect(await mask(editor)).toBeUndefined();
  await expect.poll(() => editor.mappedDistance([260, 470], elbow ?? [0, 0])).toBeLessThan(1e-6);
});

test('strokes go to the places of the original under the pointer', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await editor.dragHandle('left hand', { x: 60, y: -110 });
  const hand = await editor.settled(() => editor.mapped(140, 480));
  await page.keyboard.press('f');
  await editor.button('Stiffen').click();
  await stroke(editor, [at(...(hand ?? [0, 0]))]);
  expect(await stiffnessAt(editor, 140, 480)).toBeGreaterThan(0.9);
});

test('the eraser, the sizes and a dab have keys; the overlay stays with other tools', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('f');
  await editor.button('Stiffen').click();
  const size = page.getByRole('slider', { name: 'Brush size (%)' });
  const first = Number(await size.inputValue());
  await page.keyboard.press(']');
  expect(Number(await size.inputValue())).toBeGreaterThan(first);
  await page.keyboard.press('[');
  await page.keyboard.press('[');
  expect(Number(await size.inputValue())).toBeLessThan(first);

  // Arrows move the brush, Enter paints under it.
  await page.keyboard.press('f');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: paint stiffness')).toBeEnabled();
  await page.keyboard.press('e');
  await expect(editor.button('Erase')).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: erase stiffness')).toBeEnabled();
  await page.keyboard.press('e');

  await page.mouse.move(at(512, 640).x, at(512, 640).y);
  await stroke(editor, [at(512, 640)]);
  expect(await stiffnessAt(editor, 512, 640)).toBe(1);
  await page.keyboard.down('Alt');
  await stroke(editor, [at(512, 640)]);
  await page.keyboard.up('Alt');
  expect(await stiffnessAt(editor, 512, 640)).toBe(0);

  await stroke(editor, [at(512, 640)]);
  await page.keyboard.press('v');
  const plain = await editor.screenshot(at(540, 660));
  await editor.button(/^Overlays/).click();
  await page.getByRole('checkbox', { name: 'Stiffness' }).click();
  await expect(
    page.getByRole('img', { name: 'Blue is slightly stiff, yellow keeps its shape' }),
  ).toBeVisible();
  await expect
    .poll(async () => meanDifference(plain, await editor.screenshot(at(540, 660))))
    .toBeGreaterThan(10);
});

test('the file keeps the mask, and a project without one has no such key', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const plain = JSON.parse((await bytes(await editor.download('Save the project file'))).toString());
  expect('stiffness' in plain).toBe(false);
  await page.keyboard.press('f');
  await editor.button('Stiffen').click();
  await stroke(editor, [at(440, 640), at(600, 640)]);
  const buffer = await bytes(await editor.download('Save the project file'));
  const painted = await mask(editor);
  expect(JSON.parse(buffer.toString())).toEqual({ ...plain, stiffness: painted });
  await editor.button('Clear stiffness').click();
  expect(await mask(editor)).toBeUndefined();
  await editor.chooseFile({ name: 'gingerbread.c2warp.json', mimeType: 'application/json', buffer });
  await expect.poll(() => mask(editor)).toEqual(painted);
});

test('a polygon has a stiffness in the panel, other handles have none', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await editor.handle('left hand').click({ force: true });
  const field = page.getByRole('spinbutton', { name: 'Stiffness (0 to 1)' });
  await expect(field).toBeHidden();
  await editor.waitForSolve(async () => {
    await page.keyboard.press('g');
    for (const [x, y] of [
      [440, 600],
      [590, 600],
      [590, 720],
      [440, 720],
    ] as const)
      await page.mouse.click(at(x, y).x, at(x, y).y);
    await page.keyboard.press('Enter');
  });
  await field.fill('0.8');
  await field.press('Enter');
  await expect.poll(() => editor.projectHandle('polygon-1')).toMatchObject({ stiffness: 0.8 });
  await field.fill('0');
  await field.press('Enter');
  await expect.poll(async () => 'stiffness' in ((await editor.projectHandle('polygon-1')) ?? {})).toBe(false);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });

  test('a finger paints, and the bar lies beside the tools', async ({ page }) => {
    const editor = await Editor.open(page);
    const at = await editor.fromImage('head', [512, 260]);
    await editor.button('Brush').tap();
    await editor.button('Stiffen').tap();
    const bar = page.getByRole('group', { name: 'Brush', exact: true });
    await expect(bar).toBeVisible();
    const [box, tools] = [
      await bar.boundingBox(),
      await page.getByRole('group', { name: 'Tools', exact: true }).boundingBox(),
    ];
    expect(box && box.x >= 0 && box.x + box.width <= 360).toBe(true);
    expect(tools && tools.x >= 0 && tools.x + tools.width <= 360).toBe(true);
    expect(box && tools && box.y + box.height <= tools.y).toBe(true);
    const before = await editor.screenshot(at(512, 500), 12);
    await page.touchscreen.tap(at(512, 500).x, at(512, 500).y);
    await expect.poll(() => stiffnessAt(editor, 512, 500)).toBe(1);
    await expect
      .poll(async () => meanDifference(before, await editor.screenshot(at(512, 500), 12)))
      .toBeGreaterThan(SAME);
  });
});
