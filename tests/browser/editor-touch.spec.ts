/** The editor by touch, on a phone. */
import type { CDPSession, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { lift, send, touch } from './fingers';
import { expect, test } from './fixtures';

test.use({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });

const fingers = (page: Page) => page.context().newCDPSession(page);
const beside = ({ x, y }: Position, dx: number, dy: number): Position => ({ x: x + dx, y: y + dy });

test('one finger drags a hand, and the sheet shows numbers on request', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  await touch(await fingers(page), [[hand], [beside(hand, -10, -30)], [beside(hand, -20, -60)]]);
  await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(420);
  await expect(page.getByRole('heading', { name: 'Right hand' })).toBeVisible();
  await expect(editor.field('y')).toBeHidden();
  await editor.button('Values').tap();
  await expect(editor.field('y')).toBeVisible();
  await editor.button('Undo').tap();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('two fingers navigate and never edit, even on a handle', async ({ page }) => {
  const editor = await Editor.open(page);
  const [hand, zoom] = [await editor.position('right hand'), await editor.zoom()];
  const second = beside(hand, -120, 40);
  await touch(await fingers(page), [
    [hand],
    [beside(hand, 4, -20)],
    [beside(hand, 4, -20), second],
    [beside(hand, 14, -40), beside(second, -40, 60)],
  ]);
  expect(await editor.settled(() => editor.shownPose('right hand'))).toMatchObject({ x: 900, y: 516 });
  await expect.poll(() => editor.zoom()).toBeGreaterThan(zoom * 1.2);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('a second finger removes a handle that the first just placed', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Add a point handle').tap();
  await expect(editor.button('Add a point handle')).toHaveAttribute('aria-pressed', 'true');
  const belly = beside(await editor.position('head'), 0, 140);
  await touch(await fingers(page), [[belly], [belly, beside(belly, 60, 60)], [belly, beside(belly, 80, 90)]]);
  await expect(editor.handles).toHaveCount(5);
  await touch(await fingers(page), [[belly]]);
  await expect(editor.handles).toHaveCount(6);
});

test('the sheet does not cover the selection, and hides during a drag', async ({ page }) => {
  const editor = await Editor.open(page);
  const sheet = page.getByRole('region', { name: 'Properties' });
  const opaque = () => sheet.evaluate((element) => Number(getComputedStyle(element).opacity));
  const covers = async (name: string) => {
    const [handle, box] = [await editor.position(name), await sheet.boundingBox()];
    return box !== null && handle.y + 20 > box.y && handle.y - 20 < box.y + box.height;
  };
  await editor.handle('head').tap();
  await expect(page.getByRole('heading', { name: 'Head' })).toBeVisible();
  for (const name of ['head', 'left hand', 'left foot'])
    await expect.poll(() => covers(name), name).toBe(false);
  await editor.button('Values').tap();
  await expect(editor.field('depth')).toBeVisible();
  await expect.poll(() => covers('head')).toBe(false);
  await editor.button('Values').tap();
  await expect(editor.field('depth')).toBeHidden();
  await editor.handle('left foot').tap();
  await expect(page.getByRole('heading', { name: 'Left foot' })).toBeVisible();
  await editor.button('Values').tap();
  await expect(editor.field('depth')).toBeVisible();
  await expect.poll(() => covers('left foot')).toBe(false);
  const session = await fingers(page);
  const foot = await editor.position('left foot');
  await send(session, 'Start', [foot]);
  await send(session, 'Move', [beside(foot, -20, -200)]);
  await expect.poll(opaque).toBe(0);
  await lift(session);
  await expect.poll(opaque).toBe(1);
});

test('the bending mode can be changed while a handle is selected', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').tap();
  await editor.button('Bending settings').tap();
  await expect(editor.field('x')).toBeHidden();
  await editor.switch('Lock the outline').tap();
  await expect(editor.switch('Lock the outline')).toBeChecked();
  await editor.handle('left hand').tap();
  await expect(editor.switch('Lock the outline')).toBeHidden();
  await expect(page.getByRole('heading', { name: 'Left hand' })).toBeVisible();
});

test('a tap on the stage does not click controls that appear under it', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const clicks: string[] = [];
    Object.assign(globalThis, { clicks });
    document.addEventListener('click', (event) => clicks.push(String(event.composedPath()[0])), {
      capture: true,
    });
  });
  const heard = () => page.evaluate(() => (Reflect.get(globalThis, 'clicks') as string[]).length);
  /** Browsers send the click of a tap some time after the touch ends. */
  const zoomIn = async () => {
    const zoom = await editor.zoom();
    await editor.button('Zoom in').tap();
    await expect.poll(() => editor.zoom()).not.toBe(zoom);
  };
  await editor.button('Add a point handle').tap();
  await zoomIn();
  await zoomIn();
  const before = await heard();
  // On a leg, where the delete button appears.
  await page.touchscreen.tap(353, 627);
  await expect(editor.handles).toHaveCount(6);
  // Taps are handled in order, so earlier clicks have arrived after this one.
  await zoomIn();
  expect(await heard()).toBe(before + 1);
});

const small = async (page: Page): Promise<string[]> => {
  const found: string[] = [];
  for (const control of await page
    .locator('c2-warp')
    .locator('button, .field')
    .filter({ visible: true })
    .all()) {
    const box = await control.boundingBox();
    const name = (await control.getAttribute('aria-label')) ?? (await control.textContent()) ?? '';
    if (Math.min(box?.width ?? 0, box?.height ?? 0) < 44) found.push(name.trim());
  }
  return found;
};

test('every control is at least 44 px, and tools are at the bottom', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').tap();
  await editor.button('Values').tap();
  await expect(editor.field('depth')).toBeVisible();
  expect(await small(page)).toEqual([]);
  const tools = await page.getByRole('group', { name: 'Tools' }).boundingBox();
  expect(tools?.y).toBeGreaterThan(600);
});

test('on a sideways phone controls are 44 px, and fields cause no zoom', async ({ page }) => {
  await page.setViewportSize({ width: 844, height: 390 });
  const editor = await Editor.open(page);
  await editor.handle('head').tap();
  await expect(editor.field('depth')).toBeVisible();
  expect(await small(page)).toEqual([]);
  await expect(editor.field('x')).toHaveCSS('font-size', '16px');
});

test('the sheet of a bar has one row of buttons, and room for all numbers', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    const ends = [
      [420, 700],
      [600, 860],
    ] as const;
    const warp = element as C2Warp;
    warp.selection = [warp.addHandle({ kind: 'bar', rest: ends, posed: ends, depth: -10 })];
  });
  await editor.button('Values').tap();
  await expect(editor.field('depth')).toBeVisible();
  const places = await Promise.all(
    ['Add a corner', 'Values', 'Reset to rest', 'Delete'].map((name) => editor.centre(editor.button(name))),
  );
  expect(new Set(places.map(({ y }) => Math.round(y))).size).toBe(1);
  expect(places.map(({ x }) => x)).toEqual(places.map(({ x }) => x).sort((a, b) => a - b));
  for (const name of ['x', 'y', 'rotation', 'scale', 'depth'] as const) {
    const spare = await editor.field(name).evaluate((input) => input.clientWidth - input.scrollWidth);
    expect(spare, name).toBeGreaterThanOrEqual(0);
  }
});

test('the on-screen keyboard moves nothing and leaves the numbers visible', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  const editor = await Editor.open(page);
  await editor.handle('head').tap();
  await editor.button('Values').tap();
  const zoom = await editor.zoom();
  await editor.field('depth').tap();
  await expect(editor.field('depth')).toBeFocused();
  await page.setViewportSize({ width: 360, height: 370 });
  await editor.waitFrames();
  for (const name of ['x', 'depth'] as const) await expect(editor.field(name)).toBeInViewport({ ratio: 1 });
  expect(await editor.zoom()).toBe(zoom);
  const before = await editor.settled(() => editor.position('head'));
  await page.keyboard.press('Escape');
  await page.setViewportSize({ width: 360, height: 740 });
  await editor.waitFrames();
  await expect.poll(() => editor.position('head')).toEqual(before);
  expect(await editor.zoom()).toBe(zoom);
});

for (const width of [320, 390]) {
  test(`at ${width} px the toolbar fits all its buttons, with equal widths`, async ({ page }) => {
    await page.setViewportSize({ width, height: 640 });
    await Editor.open(page);
    const buttons = page.locator('c2-warp .top .button:visible');
    const widths: number[] = [];
    for (const button of await buttons.all()) {
      const box = await button.boundingBox();
      expect(box && box.x >= 0 && box.x + box.width <= width).toBe(true);
      widths.push(box?.width ?? 0);
    }
    expect(widths.length).toBe(8);
    expect(Math.max(...widths) - Math.min(...widths)).toBeLessThan(1);
    expect(Math.min(...widths)).toBeGreaterThan(24);
  });
}

/** Sends an event of a pen. */
const pen = (session: CDPSession, type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', at: Position) =>
  session.send('Input.dispatchMouseEvent', {
    type,
    ...at,
    pointerType: 'pen',
    button: 'left',
    buttons: type === 'mouseReleased' ? 0 : 1,
    clickCount: 1,
  });

/** Puts palms on the screen, or lifts them all. */
const palms = (session: CDPSession, ...places: readonly Position[]) =>
  send(session, places.length > 0 ? 'Start' : 'End', places);

/** Waits until the right hand is at a place. */
const expectHand = (editor: Editor, { x, y }: Position) =>
  expect
    .poll(async () => {
      const now = await editor.position('right hand');
      return Math.hypot(now.x - x, now.y - y);
    })
    .toBeLessThan(0.1);

test('palms that come during the drag of a pen do not disturb it', async ({ page }) => {
  const editor = await Editor.open(page);
  const session = await fingers(page);
  const [hand, zoom] = [await editor.position('right hand'), await editor.zoom()];
  const palm = beside(hand, -80, 150);
  await pen(session, 'mousePressed', hand);
  await pen(session, 'mouseMoved', beside(hand, -5, -20));
  await palms(session, palm);
  await pen(session, 'mouseMoved', beside(hand, -10, -40));
  await palms(session, palm, beside(palm, 60, 20));
  await pen(session, 'mouseMoved', beside(hand, -20, -60));
  await pen(session, 'mouseReleased', beside(hand, -20, -60));
  await palms(session);
  await expectHand(editor, beside(hand, -20, -60));
  expect(await editor.zoom()).toBe(zoom);
  await expect(editor.button('Undo: move right hand')).toBeEnabled();
});

test('a pen works while a palm rests, and the palm edits nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  const session = await fingers(page);
  const hand = await editor.position('right hand');
  await editor.button('Add a point handle').tap();
  const belly = beside(await editor.position('head'), 0, 140);
  await palms(session, belly);
  await expect(editor.handles).toHaveCount(6);
  await pen(session, 'mousePressed', hand);
  await expect(editor.handles).toHaveCount(5);
  await pen(session, 'mouseMoved', beside(hand, -5, -20));
  await pen(session, 'mouseMoved', beside(hand, -20, -60));
  await pen(session, 'mouseReleased', beside(hand, -20, -60));
  await palms(session);
  await expectHand(editor, beside(hand, -20, -60));
  await expect(editor.handles).toHaveCount(5);
});

test('a palm that has brought up the menu gives way to a pen', async ({ page }) => {
  const editor = await Editor.open(page);
  const session = await fingers(page);
  const [hand, head] = [await editor.position('right hand'), await editor.position('head')];
  await palms(session, head);
  await expect(page.getByRole('menu')).toBeVisible();
  await pen(session, 'mousePressed', hand);
  await expect(page.getByRole('menu')).toBeHidden();
  await pen(session, 'mouseMoved', beside(hand, -20, -60));
  await pen(session, 'mouseReleased', beside(hand, -20, -60));
  await palms(session);
  await expectHand(editor, beside(hand, -20, -60));
});

test('two fingers navigate again once the pen has left', async ({ page }) => {
  const editor = await Editor.open(page);
  const session = await fingers(page);
  const [hand, zoom] = [await editor.position('right hand'), await editor.zoom()];
  await pen(session, 'mousePressed', hand);
  await pen(session, 'mouseReleased', hand);
  await session.send('Input.dispatchMouseEvent', { type: 'mouseMoved', x: 30, y: 20, pointerType: 'pen' });
  const second = beside(hand, -120, 40);
  await touch(session, [
    [hand, second],
    [beside(hand, 20, -40), beside(second, -40, 60)],
  ]);
  await expect.poll(() => editor.zoom()).toBeGreaterThan(zoom * 1.2);
});

test('icons have words, and settings leave the picture in view', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const word of ['Open', 'Undo', 'Overlays', 'More', 'Move', 'Polygon', 'Bend', 'Fit'])
    await expect(page.locator('c2-warp .caption:visible').getByText(word, { exact: true })).toBeVisible();
  const sheet = page.getByRole('region', { name: 'Properties' });
  const covered = async () => {
    const top = (await sheet.boundingBox())?.y ?? 0;
    const feet = await Promise.all(['left foot', 'right foot'].map((name) => editor.position(name)));
    return feet.some(({ y }) => y > top);
  };
  for (const name of ['Bending settings', /^Overlays/]) {
    await editor.button(name).tap();
    await expect(sheet).toBeVisible();
    await expect.poll(covered).toBe(false);
  }
  await editor.button('Close the list').tap();
  await expect(sheet).toBeHidden();
});

test('colours and keys are in a menu, which has room on a phone', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('More').tap();
  await editor.button('Dark colours').tap();
  await expect(page.locator('c2-warp')).toHaveAttribute('theme', 'dark');
  await editor.button('More').tap();
  await expect(editor.button('Reset all handles')).toBeDisabled();
  await page.getByRole('button', { name: 'Keyboard shortcuts', exact: true }).tap();
  const keys = page.getByRole('dialog', { name: 'Keyboard shortcuts' });
  await expect(keys).toBeVisible();
  await editor.button('Close the keyboard shortcuts').tap();
  await expect(keys).toBeHidden();
});

test('one finger and two cannot move the picture out of view', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('More').tap();
  await editor.button('Pan').tap();
  const session = await fingers(page);
  const from = { x: 60, y: 300 };
  for (let swipe = 0; swipe < 4; swipe++) await touch(session, [[from], [beside(from, 300, 300)]]);
  const second = beside(from, 60, 0);
  for (let swipe = 0; swipe < 3; swipe++)
    await touch(session, [[from], [from, second], [beside(from, 260, 260), beside(second, 260, 260)]]);
  const head = await editor.settled(() => editor.position('left hand'));
  expect(head.x).toBeLessThan(390);
  expect(head.y).toBeLessThan(780);
});
