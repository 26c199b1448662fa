/** The context menu: by right click, long press and keys. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { lift, send } from './fingers';
import { expect, test } from './fixtures';

const menu = (page: Page) => page.getByRole('menu');
const entry = (page: Page, name: string) => page.getByRole('menuitem', { name, exact: true });
const rightClick = (page: Page, { x, y }: Position) => page.mouse.click(x, y, { button: 'right' });
const beside = ({ x, y }: Position, dx: number, dy: number): Position => ({ x: x + dx, y: y + dy });
const posed = async (editor: Editor, id: string) => (await editor.projectHandle(id))?.posed;
const selection = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).selection.join(' '));
const set = (page: Page, attribute: string) =>
  page.locator('c2-warp').evaluate((element, name) => element.setAttribute(name, ''), attribute);

/** Adds a bar in the left leg, not selected. */
async function leg(editor: Editor): Promise<void> {
  const rest = [
    [330, 1040],
    [430, 820],
  ] as const;
  await editor.waitForSolve(() =>
    editor.page.locator('c2-warp').evaluate((element, rest) => {
      const warp = element as C2Warp;
      warp.addHandle({ kind: 'bar', id: 'leg', rest });
      warp.selection = [];
    }, rest),
  );
}

test('a right click selects a handle and lists its commands with keys', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const moved = await posed(editor, 'left-hand');
  await page.keyboard.press('Escape');
  await rightClick(page, await editor.position('left hand'));
  await expect(menu(page)).toHaveAccessibleName('left hand');
  expect(await selection(page)).toBe('left-hand');
  await expect(entry(page, 'Mirror to the other side')).toHaveText(/Mirror to the other side\s+M/);
  await expect(entry(page, 'Paste a pose')).toHaveAttribute('aria-keyshortcuts', 'Control+V');
  await entry(page, 'Mirror to the other side').click();
  await expect(menu(page)).toHaveCount(0);
  expect(await selection(page)).toBe('right-hand');
  await expect(editor.handle('right hand')).toBeFocused();
  expect(await posed(editor, 'right-hand')).toEqual([1024 - (moved?.[0] as number), moved?.[1]]);

  // On one of several selected handles, the menu applies to all of them.
  await page.keyboard.press('Control+a');
  await rightClick(page, await editor.position('right hand'));
  await expect(menu(page)).toHaveAccessibleName('5 handles');
  await entry(page, 'Reset').click();
  expect(await posed(editor, 'left-hand')).toEqual([124, 516]);
  expect(await posed(editor, 'right-hand')).toEqual([900, 516]);

  // Commands that cannot run are listed and do nothing.
  await rightClick(page, await editor.position('right hand'));
  await expect(entry(page, 'Reset')).toBeDisabled();
  await entry(page, 'Reset').click({ force: true });
  await expect(menu(page)).toBeVisible();

  // No entry stays highlighted when the pointer leaves.
  await entry(page, 'Delete').hover();
  await expect(entry(page, 'Delete')).toBeFocused();
  await page.mouse.move(5, 5);
  await expect(menu(page)).toBeFocused();
});

test('on the picture it adds a point; a press outside only closes it', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await editor.handle('head').click();
  await rightClick(page, at(512, 700));
  await expect(menu(page)).toHaveAccessibleName('Picture');
  expect(await selection(page)).toBe('head');
  const { x, y } = at(700, 300);
  await page.mouse.click(x, y);
  await expect(menu(page)).toHaveCount(0);
  expect(await selection(page)).toBe('head');
  await expect(editor.handle('head')).toBeFocused();

  await rightClick(page, at(512, 700));
  await rightClick(page, at(300, 100));
  await expect(entry(page, 'Add a point handle here')).toBeDisabled();
  await rightClick(page, at(512, 700));
  await editor.waitForSolve(() => entry(page, 'Add a point handle here').click());
  await expect(editor.handles).toHaveCount(6);
  await expect(editor.handle('handle 1')).toBeFocused();
  const told = await editor.shownPose('handle 1');
  expect(Math.hypot(told.x - 512, told.y - 700)).toBeLessThan(2);
  await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
});

test('corners are added at the pressed point of a line, and deleted', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await leg(editor);
  // A fifth of the way; a key would add one in the middle.
  await rightClick(page, at(410, 864));
  await expect(entry(page, 'Delete the corner')).toHaveCount(0);
  await editor.waitForSolve(() => entry(page, 'Add a corner').click());
  await expect(editor.corner(2, 'leg')).toBeFocused();
  const corner = (await posed(editor, 'leg'))?.[1] as readonly [number, number];
  expect(Math.hypot(corner[0] - 410, corner[1] - 864)).toBeLessThan(3);
  await page.keyboard.press('Escape');
  await rightClick(page, at(...corner));
  await expect(menu(page)).toHaveAccessibleName('Corner 2 of leg');
  await editor.waitForSolve(() => entry(page, 'Delete the corner').click());
  await rightClick(page, at(430, 820));
  await expect(menu(page)).toHaveAccessibleName('Corner 2 of leg');
  await expect(entry(page, 'Delete the corner')).toBeDisabled();
});

test('keys open it for the focused handle and navigate it', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('right hand').focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ContextMenu');
  await expect(entry(page, 'Reset')).toBeFocused();
  await expect(menu(page)).toHaveAccessibleName('right hand');
  await page.keyboard.press('ArrowUp');
  await expect(entry(page, 'Delete')).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(entry(page, 'Reset')).toBeFocused();
  await page.keyboard.press('End');
  await expect(entry(page, 'Delete')).toBeFocused();
  await page.keyboard.press('Home');
  await expect(entry(page, 'Reset')).toBeFocused();
  // A letter goes to an entry; letters and other keys run no command meanwhile.
  await page.keyboard.press('m');
  await expect(entry(page, 'Mirror to the other side')).toBeFocused();
  await page.keyboard.press('Delete');
  await page.keyboard.press('Escape');
  await expect(menu(page)).toHaveCount(0);
  await expect(editor.handle('right hand')).toBeFocused();
  await expect(editor.handles).toHaveCount(5);
  expect(await selection(page)).toBe('right-hand');

  await page.keyboard.press('Shift+F10');
  await page.keyboard.press('Enter');
  await expect.poll(() => posed(editor, 'right-hand')).toEqual([900, 516]);
  await expect(menu(page)).toHaveCount(0);
  await expect(editor.handle('right hand')).toBeFocused();

  await page.keyboard.press('ContextMenu');
  await expect(menu(page)).toBeVisible();
  await page.keyboard.press('Tab');
  await expect(menu(page)).toHaveCount(0);
  await expect(editor.handle('left foot')).toBeFocused();

  await page.locator('c2-warp .stage').focus();
  await page.keyboard.press('ContextMenu');
  await expect(menu(page)).toHaveAccessibleName('Picture');
  await page.keyboard.press('s');
  await page.keyboard.press(' ');
  await expect(page.locator('c2-warp .stage')).toBeFocused();
  expect((await selection(page)).split(' ')).toHaveLength(5);
  await page.keyboard.press('ContextMenu');
  await page.keyboard.press('Control+z');
  await expect(menu(page)).toHaveCount(0);
  await expect.poll(() => posed(editor, 'right-hand')).toEqual([900, 515]);
});

test('Shift opens the browser’s menu; a drag and a draft continue', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    Object.assign(globalThis, { prevented: [] });
    document.addEventListener('contextmenu', (event) =>
      Reflect.get(globalThis, 'prevented').push(event.defaultPrevented),
    );
  });
  const prevented = () => page.evaluate(() => Reflect.get(globalThis, 'prevented'));
  const hand = await editor.position('right hand');
  await page.keyboard.down('Shift');
  await rightClick(page, hand);
  await page.keyboard.up('Shift');
  await editor.waitFrames();
  await expect(menu(page)).toHaveCount(0);
  expect(await prevented()).toEqual([false]);

  await page.mouse.move(hand.x, hand.y);
  await page.mouse.down();
  await page.mouse.move(hand.x, hand.y - 30);
  await page.mouse.down({ button: 'right' });
  await page.mouse.up({ button: 'right' });
  await page.mouse.move(hand.x, hand.y - 60);
  await page.mouse.up();
  await expect(menu(page)).toHaveCount(0);
  expect((await editor.shownPose('right hand')).y).toBeLessThan(400);

  await page.keyboard.press('g');
  await page.mouse.click(hand.x - 200, hand.y + 100);
  await rightClick(page, beside(hand, -160, 120));
  await editor.waitFrames();
  await expect(menu(page)).toHaveCount(0);
  await expect(page.getByRole('group', { name: 'Drawing' })).toBeVisible();
  expect(await prevented()).toEqual([false, true, true]);
});

test('on a corner of one of several selected handles it applies to all', async ({ page }) => {
  const editor = await Editor.open(page);
  await leg(editor);
  await page.keyboard.press('Control+a');
  await rightClick(page, await editor.centre(editor.corner(1, 'leg')));
  await expect(menu(page)).toHaveAccessibleName('6 handles');
  await page.keyboard.press('Escape');
  const before = await posed(editor, 'head');
  await page.keyboard.press('ArrowRight');
  expect(await posed(editor, 'head')).toEqual([(before?.[0] as number) + 1, before?.[1]]);
});

test('it does not open during a drag or with the lasso tool', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = await editor.position('head');
  await page.mouse.move(head.x, head.y);
  await page.mouse.down();
  await page.mouse.move(head.x + 20, head.y, { steps: 3 });
  await page.keyboard.press('Shift+F10');
  await page.mouse.move(head.x + 30, head.y, { steps: 3 });
  await page.mouse.up();
  await expect(menu(page)).toHaveCount(0);

  await page.keyboard.press('l');
  await rightClick(page, beside(head, 0, 60));
  await expect(menu(page)).toHaveCount(0);
  await page.keyboard.press('v');
  await rightClick(page, beside(head, 0, 60));
  await expect(menu(page)).toBeVisible();
});

test('it closes when the page removes its handle', async ({ page }) => {
  const editor = await Editor.open(page);
  await rightClick(page, await editor.position('head'));
  await expect(menu(page)).toHaveAccessibleName('head');
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).removeHandle('head'));
  await expect(menu(page)).toHaveCount(0);
});

test('a Ctrl click is a right click on a Mac, and begins no drag', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Add a point handle').click();
  const belly = beside(await editor.position('head'), 0, 200);
  await page.keyboard.down('Control');
  await page.mouse.move(belly.x, belly.y);
  await page.mouse.down();
  // Other systems send no such event for a Ctrl click.
  await page.locator('c2-warp .stage').evaluate((stage, { x: clientX, y: clientY }) => {
    const init = { clientX, clientY, ctrlKey: true, bubbles: true, cancelable: true };
    stage.dispatchEvent(new MouseEvent('contextmenu', init));
  }, belly);
  await expect(menu(page)).toHaveAccessibleName('Picture');
  await page.mouse.up();
  await page.keyboard.up('Control');
  await expect(menu(page)).toBeVisible();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('a press elsewhere on the page closes it, as does scrolling', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('/plain/');
  const editor = new Editor(page);
  await editor.ready();
  await page.evaluate(() => {
    const words = Object.assign(document.createElement('p'), { textContent: 'words' });
    document.body.prepend(words);
    document.body.style.paddingBottom = '2000px';
  });
  const hand = await editor.position('right hand');
  await rightClick(page, hand);
  await expect(menu(page)).toBeVisible();
  await page.getByText('words', { exact: true }).click();
  await expect(menu(page)).toHaveCount(0);
  await rightClick(page, hand);
  await expect(menu(page)).toBeVisible();
  await page.evaluate(() => scrollBy(0, 40));
  await expect(menu(page)).toHaveCount(0);
  // The menu extends beyond a lower editor, and stays within the window.
  await page.setViewportSize({ width: 900, height: 320 });
  await rightClick(page, await editor.settled(() => editor.position('right hand')));
  await expect(menu(page)).toBeInViewport({ ratio: 1 });
});

test('a readonly editor has no menu, and an open one closes', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  await rightClick(page, hand);
  await expect(menu(page)).toBeVisible();
  await set(page, 'disabled');
  await expect(menu(page)).toHaveCount(0);
  await page.locator('c2-warp').evaluate((element) => element.removeAttribute('disabled'));
  await set(page, 'readonly');
  await rightClick(page, hand);
  await editor.handle('right hand').focus();
  await page.keyboard.press('ContextMenu');
  await editor.waitFrames();
  await expect(menu(page)).toHaveCount(0);
});

test.describe('with the clipboard', () => {
  test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

  test('poses are copied and pasted, and other text is reported', async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.dragHandle('left hand', { x: 30, y: -80 });
    const moved = await posed(editor, 'left-hand');
    await rightClick(page, await editor.position('left hand'));
    await entry(page, 'Copy the pose').click();
    const clipped = await page.evaluate(() => navigator.clipboard.readText());
    expect(clipped).toContain('c2warp-pose/1');
    await page.keyboard.press('Control+z');
    await expect.poll(() => posed(editor, 'left-hand')).toEqual([124, 516]);
    await page.reload();
    await editor.ready();
    await rightClick(page, await editor.position('left hand'));
    await entry(page, 'Paste a pose').click();
    await expect.poll(() => posed(editor, 'left-hand')).toEqual(moved);
    await page.evaluate(() => navigator.clipboard.writeText('hello'));
    await rightClick(page, await editor.position('left hand'));
    await entry(page, 'Paste a pose').click();
    await expect(page.getByText('The clipboard has no pose')).toBeVisible();
  });
});

test('without clipboard access the menu pastes only poses of this page', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const refused = () => Promise.reject(new DOMException('refused', 'NotAllowedError'));
    Object.assign(navigator.clipboard, { readText: refused, writeText: refused });
  });
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const moved = await posed(editor, 'left-hand');
  await rightClick(page, await editor.position('left hand'));
  await entry(page, 'Paste a pose').click();
  await expect(page.getByText('Press Ctrl + V to paste')).toBeVisible();
  await rightClick(page, await editor.position('left hand'));
  await entry(page, 'Copy the pose').click();
  await expect(page.getByText('You can paste the pose on this page only')).toBeVisible();
  await page.keyboard.press('r');
  await expect.poll(() => posed(editor, 'left-hand')).toEqual([124, 516]);
  // Something else may have been copied meanwhile. The browser refuses to read it.
  await page.evaluate(() => window.dispatchEvent(new Event('blur')));
  await rightClick(page, await editor.position('left hand'));
  await entry(page, 'Paste a pose').click();
  await expect.poll(() => posed(editor, 'left-hand')).toEqual(moved);
});

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });

  /** Longer than a long press. */
  const stay = (page: Page) => page.waitForTimeout(900);

  test('a long press opens it, a tap chooses, and nothing is dragged', async ({ page }) => {
    const editor = await Editor.open(page);
    const session = await page.context().newCDPSession(page);
    const hand = await editor.position('right hand');
    await send(session, 'Start', [hand]);
    await expect(menu(page)).toHaveAccessibleName('right hand');
    await send(session, 'Move', [beside(hand, 3, -3)]);
    await send(session, 'End');
    await expect(menu(page)).toBeVisible();
    expect(await editor.settled(() => editor.shownPose('right hand'))).toMatchObject({ x: 900, y: 516 });
    const box = await entry(page, 'Delete').boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(44);
    // A tap outside closes the menu and keeps the selection.
    const head = await editor.position('head');
    await page.touchscreen.tap(head.x, head.y - 60);
    await expect(menu(page)).toHaveCount(0);
    expect(await selection(page)).toBe('right-hand');

    await send(session, 'Start', [beside(head, 0, 140)]);
    await expect(menu(page)).toHaveAccessibleName('Picture');
    await send(session, 'End');
    await expect(editor.button('Undo')).toBeDisabled();
    await entry(page, 'Select all handles').tap();
    await expect(menu(page)).toHaveCount(0);
    expect((await selection(page)).split(' ')).toHaveLength(5);
  });

  test('a long press that then moves drags, and closes the menu', async ({ page }) => {
    const editor = await Editor.open(page);
    const session = await page.context().newCDPSession(page);
    const hand = await editor.position('right hand');
    await send(session, 'Start', [hand]);
    await expect(menu(page)).toBeVisible();
    await send(session, 'Move', [beside(hand, 0, -30)]);
    await expect(menu(page)).toHaveCount(0);
    await send(session, 'Move', [beside(hand, 0, -60)]);
    await lift(session);
    const goal = beside(hand, 0, -60);
    const missed = async () => {
      const at = await editor.position('right hand');
      return Math.hypot(at.x - goal.x, at.y - goal.y);
    };
    await expect.poll(missed).toBeLessThan(1);
    await editor.button('Undo').tap();
    await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
    await expect(editor.button('Undo')).toBeDisabled();

    await set(page, 'posable');
    const again = await editor.position('right hand');
    await send(session, 'Start', [again]);
    await expect(menu(page)).toBeVisible();
    await send(session, 'Move', [beside(again, -30, -40)]);
    await lift(session);
    await expect(menu(page)).toHaveCount(0);
    await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(480);
  });

  test('a long press that places a handle continues as a drag', async ({ page }) => {
    const editor = await Editor.open(page);
    const session = await page.context().newCDPSession(page);
    const head = await editor.position('head');
    await editor.button('Add a point handle').tap();
    await send(session, 'Start', [beside(head, 0, 140)]);
    await stay(page);
    await expect(menu(page)).toHaveCount(0);
    await send(session, 'Move', [beside(head, 0, 100)]);
    await lift(session);
    await expect(editor.handles).toHaveCount(6);
    await expect(menu(page)).toHaveCount(0);
    // With the same tool on an existing handle, the menu opens.
    await send(session, 'Start', [head]);
    await expect(menu(page)).toHaveAccessibleName('head');
    await send(session, 'End');
    await expect(editor.handles).toHaveCount(6);
  });

  test('a moving finger drags at once, and two fingers navigate', async ({ page }) => {
    const editor = await Editor.open(page);
    const session = await page.context().newCDPSession(page);
    const [hand, foot] = [await editor.position('right hand'), await editor.position('left foot')];
    await send(session, 'Start', [hand]);
    await send(session, 'Move', [beside(hand, -5, -30)]);
    await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(480);
    await stay(page);
    await expect(menu(page)).toHaveCount(0);
    await send(session, 'End');
    await send(session, 'Start', [foot]);
    await send(session, 'Start', [foot, beside(foot, 120, -60)]);
    await stay(page);
    await send(session, 'End');
    await expect(menu(page)).toHaveCount(0);
    await page.touchscreen.tap(foot.x, foot.y);
    await stay(page);
    await expect(menu(page)).toHaveCount(0);
  });
});

test.describe('in a small window', () => {
  test.use({ viewport: { width: 320, height: 480 } });

  test('it stays within the window near every edge', async ({ page }) => {
    const editor = await Editor.open(page);
    await page.keyboard.press('Escape');
    const stage = await page.locator('c2-warp .stage').boundingBox();
    if (!stage) throw new Error('no stage');
    const [right, bottom] = [stage.x + stage.width, stage.y + stage.height];
    for (const place of [
      { x: 3, y: stage.y + 3 },
      { x: right - 3, y: stage.y + 3 },
      { x: 3, y: bottom - 3 },
      { x: right - 3, y: bottom - 3 },
      await editor.position('right hand'),
    ]) {
      await rightClick(page, place);
      await expect(menu(page)).toBeVisible();
      const box = await menu(page).boundingBox();
      if (!box) throw new Error('no menu');
      expect(Math.min(box.x, box.y)).toBeGreaterThanOrEqual(0);
      expect(box.x + box.width).toBeLessThanOrEqual(320);
      expect(box.y + box.height).toBeLessThanOrEqual(480);
      await page.keyboard.press('Escape');
      await expect(menu(page)).toHaveCount(0);
    }
  });
});
