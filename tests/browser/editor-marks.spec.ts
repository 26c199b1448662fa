/** Texts and marks of the stage, the menu and the bars about the present work. */
import type { Locator } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { expect, test } from './fixtures';

const box = async (shown: Locator) => {
  const found = await shown.boundingBox();
  if (!found) throw new Error(`${shown} is not shown`);
  return { ...found, right: found.x + found.width, bottom: found.y + found.height };
};

const beside = ({ x, y }: Position, dx: number, dy: number): Position => ({ x: x + dx, y: y + dy });

/** The number of the sample's handles on the stage. */
async function handlesInView(editor: Editor): Promise<number> {
  const stage = await box(editor.page.locator('c2-warp .stage'));
  const places = await editor.settled(() =>
    Promise.all(
      ['head', 'left hand', 'right hand', 'left foot', 'right foot'].map((name) => editor.position(name)),
    ),
  );
  return places.filter(({ x, y }) => x > stage.x && x < stage.right && y > stage.y && y < stage.bottom)
    .length;
}

test('Enter keeps hold of a focused handle, and takes another', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = editor.handle('head');
  await head.focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(head).toHaveAttribute('aria-pressed', 'true');
  await expect(head).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 513 });
});

test('panning stops while some of the picture is in view', async ({ page }) => {
  const editor = await Editor.open(page);
  const stage = page.locator('c2-warp .stage');
  for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown']) {
    await stage.focus();
    for (let press = 0; press < 12; press++) await page.keyboard.press(`Shift+${key}`);
    expect(await handlesInView(editor), key).toBeGreaterThan(0);
  }
  const { x, y } = await editor.centre(stage);
  for (const [dx, dy] of [
    [0, 6000],
    [6000, 0],
    [-9000, -9000],
  ] as const) {
    await page.mouse.move(x, y);
    await page.mouse.wheel(dx, dy);
    expect(await handlesInView(editor), `wheel by ${dx}, ${dy}`).toBeGreaterThan(0);
  }
  await page.keyboard.press('h');
  for (const by of [
    { x: 250, y: 0 },
    { x: 250, y: 0 },
    { x: 250, y: 200 },
    { x: 0, y: 200 },
  ])
    await editor.drag({ x: 300, y: 300 }, by);
  expect(await handlesInView(editor), 'dragged by hand').toBeGreaterThan(0);
  await page.keyboard.press('0');
  expect(await handlesInView(editor)).toBe(5);
});

test('W hides a notice while it is held, and the notice waits', async ({ page }) => {
  await page.clock.install();
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('depth').fill('deep');
  await page.keyboard.press('Enter');
  const notice = page.locator('c2-warp .notice');
  await expect(notice).toBeVisible();
  await editor.handle('head').focus();
  await page.keyboard.down('w');
  await expect(notice).toHaveCSS('opacity', '0');
  await page.clock.runFor(20_000);
  await page.keyboard.up('w');
  await expect(notice).toHaveCSS('opacity', '1');
  await page.clock.runFor(20_000);
  await expect(notice).toBeHidden();
});

test('the crosshair of the keyboard is as large as a finger', async ({ page }) => {
  await Editor.open(page);
  await page.keyboard.press('p');
  await page.keyboard.press('ArrowDown');
  const { width, height } = await box(page.locator('c2-warp .crosshair'));
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
});

test('the menu says why an entry is grey', async ({ page }) => {
  const editor = await Editor.open(page);
  const entry = (name: string) => page.getByRole('menuitem', { name, exact: true });
  const head = await editor.position('head');
  await page.mouse.click(head.x, head.y, { button: 'right' });
  await expect(entry('Reset')).toBeDisabled();
  await expect(entry('Reset')).toContainText('Already in the rest position');
  await expect(entry('Reset')).toHaveAccessibleDescription('Already in the rest position');
  await expect(entry('Delete')).toHaveAccessibleDescription('');
  await page.keyboard.press('Escape');
  await page.mouse.click(head.x + 220, head.y, { button: 'right' });
  await expect(entry('Add a point handle here')).toHaveAccessibleDescription('Nothing bends here');
  await page.keyboard.press('Escape');
  for (let press = 0; press < 11; press++) await page.keyboard.press(']');
  await expect(page.getByRole('status').getByText('Already in front')).toBeAttached();
});

test('a new handle is named once', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = await editor.position('head');
  await page.keyboard.press('p');
  await page.mouse.click(head.x, head.y + 60);
  await expect(editor.handle('handle 1')).toHaveAccessibleName(/^handle 1, x/);
});

test('an Alt-click deletes a handle, and an Alt-drag turns it', async ({ page }) => {
  const editor = await Editor.open(page);
  const foot = await editor.position('left foot');
  await page.keyboard.down('Alt');
  await page.mouse.move(foot.x, foot.y);
  await page.mouse.down();
  await page.mouse.move(foot.x + 30, foot.y);
  await page.mouse.move(foot.x, foot.y + 30, { steps: 3 });
  await page.mouse.up();
  await page.keyboard.up('Alt');
  await expect.poll(async () => (await editor.shownPose('left foot')).rotation).toBeGreaterThan(20);
  await expect(editor.handles).toHaveCount(5);
  await page.keyboard.down('Alt');
  await page.mouse.click(foot.x, foot.y);
  await page.keyboard.up('Alt');
  await expect(editor.handle('left foot')).toHaveCount(0);
  await editor.button('Undo: delete left foot').click();
  await expect(editor.handle('left foot')).toBeVisible();
});

test('Alt shows the ring of the handle under the pointer, which turns it', async ({ page }) => {
  const editor = await Editor.open(page);
  const ring = page.locator('c2-warp .ring');
  const hand = await editor.position('right hand');
  await editor.handle('head').focus();
  await page.keyboard.press('Escape');
  await expect(ring).toHaveCount(0);
  await page.mouse.move(hand.x + 3, hand.y);
  await page.keyboard.down('Alt');
  await expect(ring).toHaveCount(1);
  await page.keyboard.up('Alt');
  await expect(ring).toHaveCount(0);
  await page.keyboard.down('Alt');
  await page.mouse.move(hand.x + 40, hand.y);
  await expect(page.locator('c2-warp .stage')).toHaveCSS('cursor', /svg/);
  await editor.drag(beside(hand, 40, 0), { x: -40, y: 40 });
  await page.keyboard.up('Alt');
  await expect.poll(async () => (await editor.shownPose('right hand')).rotation).toBeGreaterThan(60);
  await page.mouse.move(40, 600);
  await page.keyboard.down('Alt');
  await expect(page.locator('c2-warp .ring')).toHaveCount(1);
  await page.keyboard.up('Alt');
});

test('a dragged handle snaps to guides once they are switched on', async ({ page }) => {
  const editor = await Editor.open(page);
  const guides = page.locator('c2-warp .guides');
  const [hand, head] = [await editor.position('left hand'), await editor.position('head')];
  const to = { x: head.x - 3, y: hand.y + 3 };
  const drag = async (keys: readonly string[] = []) => {
    await page.mouse.move(hand.x, hand.y);
    await page.mouse.down();
    for (const key of keys) await page.keyboard.down(key);
    await page.mouse.move(to.x, to.y, { steps: 3 });
  };
  const undone = async () => {
    await page.mouse.up();
    await page.keyboard.press('Control+z');
    await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 124, y: 516 });
  };
  await drag();
  await expect(guides).toHaveCount(0);
  await undone();
  await page.keyboard.press('Escape');
  await editor.switch('Snap to guides').click();
  await drag();
  await expect(guides).toBeVisible();
  await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 512, y: 516 });
  await page.mouse.up();
  await expect(guides).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await drag(['Control']);
  await expect(guides).toHaveCount(0);
  await page.keyboard.up('Control');
  expect((await editor.shownPose('left hand')).x).not.toBe(512);
  await undone();
});

test('a handle is placed on the axis of the picture, which shows before the press', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.switch('Snap to guides').click();
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).removeHandle('head'));
  const [left, right] = [await editor.position('left hand'), await editor.position('right hand')];
  const middle = (left.x + right.x) / 2;
  await page.keyboard.press('p');
  await page.mouse.move(middle + 4, left.y + 90);
  await expect(page.locator('c2-warp .guides')).toHaveCount(1);
  await page.mouse.click(middle + 4, left.y + 90);
  await expect.poll(() => editor.shownPose('handle 1')).toMatchObject({ x: 512 });
});

test('the switch of the guides is kept after a reload', async ({ page }) => {
  const editor = await Editor.open(page);
  const guides = editor.switch('Snap to guides');
  await guides.check();
  await expect.poll(() => editor.storedWork()).toMatchObject({ snapping: true });
  await page.reload();
  await editor.ready();
  await expect(guides).toBeChecked();
});

test('Enter places at the crosshair while a handle has the focus', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('p');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Enter');
  await expect(editor.handle('handle 1')).toBeFocused();
  await page.keyboard.press('Escape');
  for (let press = 0; press < 3; press++) await page.keyboard.press('Shift+ArrowDown');
  await expect(editor.handle('handle 1')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(editor.handle('handle 2')).toBeFocused();
});
