/** Creases of the picture, the guard against them, and depth order. */
import type { Locator } from '@playwright/test';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Drags the right hand toward the belly by a fraction of the way. */
async function push(editor: Editor, share: number): Promise<void> {
  const [hand, head] = [await editor.position('right hand'), await editor.position('head')];
  await editor.page.mouse.move(hand.x, hand.y);
  await editor.page.mouse.down();
  const goal = { x: head.x + (1 - share) * (hand.x - head.x), y: hand.y + share * 30 };
  await editor.page.mouse.move(goal.x, goal.y, { steps: 8 });
}

/** Folds the arm: by hand it does not turn when it is pushed. */
async function crease(editor: Editor): Promise<void> {
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await push(editor, 1);
}

const warningOf = (editor: Editor) => editor.page.getByRole('button', { name: /^\d+ folds?\./ });

test('a warning counts the creases, rings mark them, a press shows them', async ({ page }) => {
  const editor = await Editor.open(page);
  const warning = warningOf(editor);
  const [rings, shown] = ['.crease-place', 'path.creases'].map((name) => page.locator(`c2-warp ${name}`));
  await expect(warning).toBeHidden();
  await crease(editor);
  await expect(warning).toBeVisible();
  await expect(rings as Locator).toHaveCount(0);
  await page.mouse.up();
  await expect((rings as Locator).first()).toBeAttached();
  await expect(shown as Locator).toHaveCount(0);
  await warning.click();
  await expect(shown as Locator).toHaveCount(2);
  await editor.button('Overlays').click();
  await expect(page.getByRole('checkbox', { name: 'Folds' })).toBeChecked();
  await page.keyboard.press('Escape');
  await editor.button('Undo: move right hand').click();
  await expect(warning).toBeHidden();
  await expect(shown as Locator).toHaveCount(0);
  await expect(rings as Locator).toHaveCount(0);
});

test('a press zooms to the creases, and shows them', async ({ page }) => {
  const editor = await Editor.open(page);
  await crease(editor);
  await page.mouse.up();
  const zoom = page.getByRole('button', { name: /^Zoom to the (next )?fold$/ });
  const scale = async () => Number.parseInt(await page.locator('c2-warp .percent').innerText(), 10);
  const before = await scale();
  await zoom.click();
  await expect.poll(scale).toBeGreaterThan(before);
  await expect(page.locator('c2-warp path.creases')).toHaveCount(2);
  // The shown triangles lie in the middle of the stage.
  const [creases, stage] = [page.locator('c2-warp path.creases').first(), page.locator('c2-warp .stage')];
  const boxes = await Promise.all([creases.boundingBox(), stage.boundingBox()]);
  const [[x, y], [middleX, middleY]] = boxes.map((box) => [
    (box?.x ?? 0) + (box?.width ?? 0) / 2,
    (box?.y ?? 0) + (box?.height ?? 0) / 2,
  ]) as [number[], number[]];
  expect(Math.abs((x ?? 0) - (middleX ?? 0))).toBeLessThan(200);
  expect(Math.abs((y ?? 0) - (middleY ?? 0))).toBeLessThan(200);
});

test('a notice names the handles that fold the picture, and a press moves them back', async ({ page }) => {
  const editor = await Editor.open(page);
  await crease(editor);
  await expect(page.locator('c2-warp .notice')).toHaveCount(0);
  const folded = await editor.shownPose('right hand');
  await page.mouse.up();
  const notice = page.locator('c2-warp .notice');
  await expect(notice).toContainText(/“right hand”.* folds? the picture/);
  await notice.getByRole('button', { name: 'Unfold the picture' }).click();
  await expect(notice).toContainText('“right hand” moved back to the nearest pose without folds.');
  await expect(warningOf(editor)).toBeHidden();
  const out = await editor.settled(() => editor.shownPose('right hand'));
  // Not all the way back.
  expect(out.x).toBeGreaterThan(folded.x + 2);
  expect(out.x).toBeLessThan(890);
  await expect(editor.handle('left hand')).toHaveAttribute('aria-label', /x 124, y 516/);
  await page.keyboard.press('Control+z');
  await expect(warningOf(editor)).toBeVisible();
  await expect.poll(() => editor.shownPose('right hand')).toEqual(folded);
  // The line at the bottom and a key do the same.
  await expect(
    page.locator('c2-warp .creased').getByRole('button', { name: /Unfold the picture$/ }),
  ).toBeVisible();
  await page.keyboard.press('u');
  await expect(warningOf(editor)).toBeHidden();
});

test('the guard stops a drag at a fold, and releases it on the way back', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await editor.switch('Stop at folds').click();
  const rest = await editor.position('right hand');
  await push(editor, 1);
  const stopped = page.getByRole('button', { name: 'Stopped at a fold' });
  await expect(stopped).toBeVisible();
  const head = await editor.position('head');
  const held = await editor.settled(() => editor.position('right hand'));
  expect(held.x).toBeGreaterThan(head.x + 20);
  expect(held.x).toBeLessThan(rest.x - 10);
  // A ghost shows where the pointer asks the handle to go.
  const ghost = page.locator('c2-warp .asked.held');
  await expect(ghost.getByText('would fold here')).toBeVisible();
  const shape = await ghost.locator('.shape').boundingBox();
  expect(Math.abs((shape?.x ?? 0) + (shape?.width ?? 0) / 2 - head.x)).toBeLessThan(3);
  // The pointer is back at a position without folds: the handle follows it again.
  await page.mouse.move(rest.x - 8, rest.y + 2);
  await expect.poll(async () => (await editor.position('right hand')).x).toBeCloseTo(rest.x - 8, 0);
  await expect(stopped).toBeHidden();
  await expect(page.locator('c2-warp .asked')).toHaveCount(0);
  await page.mouse.move(head.x, rest.y + 30, { steps: 4 });
  await expect(ghost).toBeVisible();
  await page.mouse.up();
  await expect(page.locator('c2-warp .asked')).toHaveCSS('opacity', '0');
  await expect(warningOf(editor)).toBeHidden();
  await expect(stopped).toBeHidden();
  // The drag is one step.
  await editor.button('Undo: move right hand').click();
  await expect(editor.button('Undo: set bending to elastic')).toBeVisible();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('the guard is off by default, and stops numbers and keys too', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect(editor.switch('Stop at folds')).not.toBeChecked();
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await editor.switch('Stop at folds').click();
  await editor.handle('right hand').click();
  await editor.field('x').fill('512');
  await editor.field('x').press('Enter');
  await expect.poll(async () => (await editor.shownPose('right hand')).x).toBeLessThan(890);
  const { x } = await editor.settled(() => editor.shownPose('right hand'));
  expect(x).toBeGreaterThan(530);
  await editor.handle('right hand').focus();
  for (let step = 0; step < 8; step++) await page.keyboard.press('Shift+ArrowLeft');
  const nudged = await editor.settled(() => editor.shownPose('right hand'));
  expect(nudged.x).toBeGreaterThan(x - 30);
  await expect(page.getByText('Stopped before the picture folds')).toBeAttached();
  // The guard does not limit undo.
  await expect(page.getByText('Stopped at a fold')).toBeVisible();
  await page.keyboard.press('Control+z');
  await expect(page.getByText('Stopped at a fold')).toBeHidden();
});

test('depth is set by number, buttons and keys, and undone', async ({ page }) => {
  const editor = await Editor.open(page);
  const depth = async () => (await editor.projectHandle('right-hand'))?.depth ?? 0;
  await editor.handle('right hand').click();
  await editor.button(/^Bring forward$/).click();
  await expect.poll(depth).toBe(1);
  await editor.handle('right hand').focus();
  await page.keyboard.press(']');
  await page.keyboard.press(']');
  await page.keyboard.press('[');
  await expect.poll(depth).toBe(2);
  await expect(editor.field('depth')).toHaveValue('2');
  await expect(page.getByText('right hand: depth 2')).toBeAttached();
  await expect(editor.handle('right hand')).toHaveAttribute('aria-label', /depth 2/);
  await editor.field('depth').fill('40');
  await editor.field('depth').press('Enter');
  await expect(page.getByText('Depth: enter a number from -10 to 10.')).toBeVisible();
  await expect(editor.field('depth')).toHaveValue('2');
  expect(await depth()).toBe(2);
  await editor.field('depth').fill('10');
  await editor.field('depth').press('Enter');
  await expect.poll(depth).toBe(10);
  await expect(editor.button(/^Bring forward$/)).toBeDisabled();
  await editor.button(/Undo: set depth/).click();
  await expect.poll(depth).toBe(2);
});

test('a picture with depths is solved and drawn', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('right hand').click();
  await editor.field('depth').fill('5');
  await editor.field('depth').press('Enter');
  const [head, hand] = [await editor.position('head'), await editor.position('right hand')];
  await editor.dragHandle('right hand', { x: head.x - hand.x, y: head.y + 40 - hand.y });
  await page.keyboard.press('p');
  await editor.waitForSolve(() => page.mouse.click(head.x, head.y + 180));
  await expect(editor.handle('handle 1')).toBeVisible();
  await expect(editor.notice).toBeHidden();
  expect((await editor.projectHandle('right-hand'))?.depth).toBe(5);
});
