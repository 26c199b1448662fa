/** Limbs that cross: the dragged one comes to the front. */
import { Editor, meanDifference } from './editor';
import { expect, test } from './fixtures';

const depthOf = async (editor: Editor, id: string) => (await editor.projectHandle(id))?.depth ?? 0;

/** Drags the right hand of the sample from its rest position to another. */
async function dragRightHand(editor: Editor, to: readonly [number, number]): Promise<void> {
  const scale = await editor.scale();
  await editor.dragHandle('right hand', { x: (to[0] - 900) * scale, y: (to[1] - 516) * scale });
}

test('a hand dragged over the belly lies in front of it', async ({ page }) => {
  const editor = await Editor.open(page);
  const toPage = await editor.fromImage('right hand', [900, 516]);
  const hip = toPage(600, 800);
  await dragRightHand(editor, [600, 800]);
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(1);
  const inFront = await editor.screenshot(hip, 40);
  await expect(editor.handle('right hand')).not.toHaveAttribute('aria-label', /behind/);

  // The person says otherwise.
  await page.keyboard.press('[');
  await page.keyboard.press('[');
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(-1);
  await expect(editor.handle('right hand')).toHaveAttribute('aria-label', /behind another part/);
  await expect.poll(async () => meanDifference(inFront, await editor.screenshot(hip, 40))).toBeGreaterThan(3);
  // A later drag leaves it there.
  await editor.dragHandle('right hand', { x: 8, y: 4 });
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(-1);
  await expect(editor.handle('right hand')).toHaveAttribute('aria-label', /behind another part/);
});

test('undo takes the depth back with the drag, as one step', async ({ page }) => {
  const editor = await Editor.open(page);
  await dragRightHand(editor, [600, 800]);
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(1);
  await page.keyboard.press('Control+z');
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
  expect(await depthOf(editor, 'right-hand')).toBe(0);
  await expect(editor.button('Undo')).toBeDisabled();
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(1);
});

test('a drag that crosses nothing changes no depth', async ({ page }) => {
  const editor = await Editor.open(page);
  await dragRightHand(editor, [860, 400]);
  await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(420);
  expect(await depthOf(editor, 'right-hand')).toBe(0);
});

test('all corners of a drawing belong to the part of the first corner', async ({ page }) => {
  const editor = await Editor.open(page);
  const toPage = await editor.fromImage('right hand', [900, 516]);
  await dragRightHand(editor, [760, 180]);
  await page.keyboard.press('g');
  // The third corner falls on the arm, which covers the head there.
  const corners = [
    [400, 200],
    [620, 200],
    [640, 330],
    [512, 370],
    [390, 330],
  ] as const;
  for (const [x, y] of corners) {
    const at = toPage(x, y);
    await page.mouse.click(at.x, at.y);
  }
  await editor.waitForSolve(() => page.keyboard.press('Enter'));
  const drawn = await editor.projectHandle('polygon-1');
  const rest = drawn?.kind === 'polygon' ? drawn.rest : [];
  const away = rest.map(([x, y], k) => Math.hypot(x - (corners[k]?.[0] ?? 0), y - (corners[k]?.[1] ?? 0)));
  expect(away).toHaveLength(5);
  expect(Math.max(...away)).toBeLessThan(40);
});

test('the edge of a part in front can be switched off', async ({ page }) => {
  const editor = await Editor.open(page);
  const toPage = await editor.fromImage('right hand', [900, 516]);
  // The left border of the hand, in front of the belly.
  const border = toPage(512, 790);
  await dragRightHand(editor, [600, 800]);
  await expect.poll(() => depthOf(editor, 'right-hand')).toBe(1);
  // Lets go of the hand, whose ring would be in the picture.
  await page.keyboard.press('Escape');
  await expect(editor.handle('right hand')).toHaveAttribute('aria-pressed', 'false');
  const edged = await editor.screenshot(border, 30);
  await editor.switch('Shadow where parts overlap').click();
  const change = async () => meanDifference(edged, await editor.screenshot(border, 30));
  await expect.poll(change).toBeGreaterThan(0.5);
  await page.keyboard.press('Control+z');
  await expect.poll(change).toBeLessThan(0.2);
});
