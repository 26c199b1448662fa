/** The editor without a pointer, and its announcements to screen readers. */
import type { Locator } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, meanDifference, SAME } from './editor';
import { expect, test } from './fixtures';

test('Tab goes from handle to handle, and arrow keys move the focused one', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('Tab');
  await expect(editor.handle('left hand')).toBeFocused();
  await expect(editor.handle('left hand')).toHaveAttribute('aria-pressed', 'true');
  for (const key of ['ArrowRight', 'Shift+ArrowUp', 'ArrowLeft', 'ArrowRight'])
    await page.keyboard.press(key);
  const told = await editor.settled(() => editor.shownPose('left hand'));
  expect(told).toMatchObject({ x: 125, y: 506 });
  await expect(page.getByText(`left hand: x 125, y 506, rotation ${told.rotation} degree`)).toBeAttached();

  // Consecutive nudges are one step.
  await page.keyboard.press('Control+z');
  await expect.poll(() => editor.shownPose('left hand')).toEqual({ x: 124, y: 516, rotation: 0 });
  await expect(page.getByText('Undone: Move left hand')).toBeAttached();
});

test('comma and full stop turn a handle', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('.');
  await page.keyboard.press('Shift+Period');
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBe(16);
  await page.keyboard.press('Shift+Comma');
  await page.keyboard.press(',');
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBe(0);
});

test('a handle is placed, selected and deleted by keys', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('p');
  await expect(editor.button('Add a point handle')).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Enter');
  await expect(editor.handles).toHaveCount(6);
  await expect(editor.handle('handle 1')).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(editor.handles).toHaveCount(5);
  await expect(page.getByText('Delete handle 1')).toBeAttached();
  // The focused handle is deleted: keys still work, and Tab goes to the handles.
  await expect(page.locator('c2-warp .stage')).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(6);
});

test('Control A selects all, and Escape deselects', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('Control+a');
  await expect(page.getByRole('heading', { name: '5 handles' })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'false');
});

test('O shows the original while held', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  const before = await editor.screenshot(hand, 16);
  await editor.dragHandle('right hand', { x: 0, y: -90 });
  let bent = before;
  const bend = async () => {
    bent = await editor.screenshot(hand, 16);
    return meanDifference(before, bent);
  };
  await expect.poll(bend).toBeGreaterThan(10);
  await page.keyboard.down('o');
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  await expect.poll(async () => meanDifference(before, await editor.screenshot(hand, 16))).toBeLessThan(SAME);
  await page.keyboard.up('o');
  await expect.poll(async () => meanDifference(bent, await editor.screenshot(hand, 16))).toBeLessThan(SAME);
});

test('W shows only the posed picture while held', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  await editor.dragHandle('right hand', { x: 0, y: -90 });
  const at = { x: hand.x, y: hand.y - 90 };
  const look = () => editor.settled(() => editor.screenshot(at, 40));
  await editor.button('Overlays').click();
  for (const name of ['Mesh', 'Helper points', 'Reach']) await page.getByRole('checkbox', { name }).check();
  await page.keyboard.press('Escape');
  const covered = await look();
  await page.keyboard.down('w');
  await expect(editor.button(/hide the handles/)).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('c2-warp .handles')).toHaveCSS('opacity', '0');
  const alone = await look();
  expect(meanDifference(alone, covered)).toBeGreaterThan(10);
  await page.keyboard.up('w');
  expect(meanDifference(await look(), covered)).toBeLessThan(SAME);
  // Without overlays and selection, the posed picture looks the same and differs from the original.
  await editor.button('Overlays').click();
  for (const name of ['Mesh', 'Helper points', 'Reach']) await page.getByRole('checkbox', { name }).uncheck();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.keyboard.down('w');
  expect(meanDifference(await look(), alone)).toBeLessThan(SAME);
  await page.keyboard.down('o');
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  expect(meanDifference(await look(), alone)).toBeGreaterThan(10);
  await page.keyboard.up('o');
});

test('over the original a press pans, and moves no hidden handle', async ({ page }) => {
  const editor = await Editor.open(page);
  const [at, told] = [await editor.position('head'), await editor.shownPose('head')];
  await editor.handle('head').focus();
  await page.keyboard.down('o');
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  await expect(page.locator('c2-warp .stage')).toHaveCSS('cursor', 'grab');
  await editor.drag(at, { x: 50, y: 30 });
  await page.mouse.dblclick(at.x + 50, at.y + 30);
  await page.keyboard.up('o');
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeHidden();
  expect(await editor.position('head')).toEqual({ x: at.x + 50, y: at.y + 30 });
  expect(await editor.shownPose('head')).toEqual(told);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await editor.dragHandle('head', { x: 12, y: 0 });
  await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();
});

test('0 fits, 1 shows actual size, and the wheel zooms at the pointer', async ({ page }) => {
  const editor = await Editor.open(page);
  const fitted = await editor.zoom();
  await page.keyboard.press('1');
  await expect.poll(() => editor.zoom()).toBe(1);
  await page.keyboard.press('0');
  await expect.poll(() => editor.zoom()).toBe(fitted);

  const hand = await editor.position('left hand');
  await page.mouse.move(hand.x, hand.y);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  await expect.poll(() => editor.zoom()).toBeGreaterThan(fitted);
  const after = await editor.settled(() => editor.position('left hand'));
  expect(Math.hypot(after.x - hand.x, after.y - hand.y)).toBeLessThan(1);

  await page.mouse.wheel(0, 50);
  await expect.poll(async () => (await editor.position('left hand')).y).toBeCloseTo(after.y - 50, 0);
  await page.keyboard.down('Space');
  await editor.drag({ x: hand.x + 60, y: hand.y + 200 }, { x: 30, y: 50 });
  await page.keyboard.up('Space');
  await expect.poll(async () => (await editor.position('left hand')).x).toBeCloseTo(after.x + 30, 0);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('document keys work from a number field and commit it first', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('x').fill('530');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  expect(download.suggestedFilename()).toContain('.c2warp.json');
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 530 });
  await editor.field('x').focus();
  await page.keyboard.press('Control+z');
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 512 });
});

test('Escape reaches a dialog around the editor if nothing is to revert', async ({ page }) => {
  const editor = await Editor.open(page);
  const taken = (key: string) =>
    page.evaluate(async (key) => {
      const heard = new Promise<boolean>((done) =>
        addEventListener('keydown', (event) => done(event.defaultPrevented), { once: true }),
      );
      const warp = document.querySelector('c2-warp')?.shadowRoot?.activeElement;
      warp?.dispatchEvent(
        new KeyboardEvent('keydown', { key, bubbles: true, composed: true, cancelable: true }),
      );
      return heard;
    }, key);
  await editor.handle('head').focus();
  expect(await taken('Escape')).toBe(true);
  expect(await taken('Escape')).toBe(false);
});

/** Returns a query for whether a button's tooltip is visible. */
const tipped = (button: Locator) => () =>
  button.evaluate((element) => {
    const { content, opacity } = getComputedStyle(element, '::after');
    return content !== 'none' && opacity === '1';
  });

test('Escape dismisses a tooltip until its button is hovered or focused', async ({ page }) => {
  const editor = await Editor.open(page);
  const [fit, undo] = [editor.button('Fit'), editor.button('Undo')];
  await editor.handle('head').focus();
  await fit.hover();
  await expect.poll(tipped(fit)).toBe(true);
  await page.keyboard.press('Escape');
  await expect.poll(tipped(fit)).toBe(false);
  // That press dismissed the tooltip; the next one deselects.
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Escape');
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'false');
  await undo.hover({ force: true });
  await fit.hover();
  await expect.poll(tipped(fit)).toBe(true);

  await undo.hover({ force: true });
  await editor.button('Zoom in').focus();
  await page.keyboard.press('Tab');
  await expect(fit).toBeFocused();
  await expect.poll(tipped(fit)).toBe(true);
  await page.keyboard.press('Escape');
  await expect.poll(tipped(fit)).toBe(false);
  await expect(fit).toBeFocused();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Tab');
  await expect.poll(tipped(fit)).toBe(true);
});

test('with the focus elsewhere, Escape dismisses a tooltip and reaches the page', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const field = document.createElement('input');
    document.body.append(field);
    field.focus();
    field.addEventListener('keydown', (event) => {
      field.value = `${event.key} ${event.defaultPrevented}`;
    });
  });
  await editor.button('Fit').hover();
  await expect.poll(tipped(editor.button('Fit'))).toBe(true);
  await page.keyboard.press('Escape');
  await expect.poll(tipped(editor.button('Fit'))).toBe(false);
  await expect(page.locator('body > input')).toHaveValue('Escape false');
});

test('a tooltip can be hovered; a press dismisses it without the button', async ({ page }) => {
  const editor = await Editor.open(page);
  const reset = editor.button('Reset all handles');
  await editor.handle('head').focus();
  await page.keyboard.press('ArrowUp');
  await reset.hover();
  await expect.poll(tipped(reset)).toBe(true);
  const { x, y } = await editor.centre(reset);
  for (let below = 0; below <= 36; below += 4) {
    await page.mouse.move(x, y + below);
    expect(await tipped(reset)(), `${below} px below`).toBe(true);
  }
  await page.mouse.down();
  await page.mouse.up();
  await expect.poll(tipped(reset)).toBe(false);
  await expect(editor.button('Undo: move head')).toBeEnabled();
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
});

test('a pressed button shows no tooltip until it is hovered again', async ({ page }) => {
  const editor = await Editor.open(page);
  const bar = editor.button('Draw a bar');
  await bar.hover();
  await expect.poll(tipped(bar)).toBe(true);
  const { x, y } = await editor.centre(bar);
  await page.mouse.down();
  expect(await tipped(bar)()).toBe(false);
  await page.mouse.up();
  // The first corner of a bar is set where the tooltip was.
  await page.mouse.click(x + 60, y);
  await expect(page.locator('.draft')).toHaveCount(1);
  await page.keyboard.press('Escape');
  await bar.hover();
  await expect.poll(tipped(bar)).toBe(true);
});

test('the tooltip of a disabled button is fully opaque', async ({ page }) => {
  const editor = await Editor.open(page);
  const undo = editor.button('Undo');
  await expect(undo).toBeDisabled();
  await undo.hover({ force: true });
  await expect.poll(tipped(undo)).toBe(true);
  await expect(undo).toHaveCSS('opacity', '1');
});

for (const name of [
  'Open recent work',
  'compare',
  'Overlays',
  'Select and move',
  'Bending settings',
  'Delete',
]) {
  test(`the tooltip of “${name}” lies inside a window of 320 px`, async ({ page }) => {
    await page.setViewportSize({ width: 320, height: 640 });
    const editor = await Editor.open(page);
    await editor.handle('head').focus();
    const button = editor.button(new RegExp(name)).first();
    await button.hover();
    await expect.poll(tipped(button)).toBe(true);
    const { left, right } = await button.evaluate((element) => {
      const style = getComputedStyle(element, '::after');
      const frame = getComputedStyle(element).position === 'static' ? element.closest('.tools') : element;
      const box = (frame as Element).getBoundingClientRect();
      const start = box.left + (frame as Element).clientLeft + Number.parseFloat(style.left);
      const width = Number.parseFloat(style.width);
      const shift = style.translate.startsWith('-50%') ? width / 2 : 0;
      return { left: start - shift, right: start - shift + width };
    });
    expect(left).toBeGreaterThanOrEqual(0);
    expect(right).toBeLessThanOrEqual(320);
  });
}

test('an open menu hides the tooltip of its button', async ({ page }) => {
  const editor = await Editor.open(page);
  const overlays = editor.button('Overlays');
  await overlays.hover();
  await expect.poll(tipped(overlays)).toBe(true);
  await overlays.focus();
  await page.keyboard.press('Enter');
  await expect.poll(tipped(overlays)).toBe(false);
  await page.keyboard.press('Escape');
  await expect.poll(tipped(overlays)).toBe(true);
});

test('Escape discards a draft before it dismisses a tooltip', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('b');
  const head = await editor.position('head');
  await page.mouse.click(head.x, head.y + 40);
  const drawing = page.getByRole('group', { name: 'Drawing' });
  await expect(drawing).toBeVisible();
  await editor.button('Fit').hover();
  await page.keyboard.press('Escape');
  await expect(drawing).toBeHidden();
  await expect.poll(tipped(editor.button('Fit'))).toBe(true);
  await page.keyboard.press('Escape');
  await expect.poll(tipped(editor.button('Fit'))).toBe(false);
});

test('closing a menu with Escape focuses its button, and keys work again', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('ArrowUp');
  await editor.button('Overlays').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('checkbox').first().focus();
  await page.keyboard.press('Escape');
  await expect(editor.button('Overlays')).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(editor.button('Undo')).toBeDisabled();
});

test('keys work again after a button disables itself', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('ArrowUp');
  await editor.button('Undo').focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+y');
  await expect(editor.button('Redo')).toBeDisabled();
  await expect(editor.button('Undo')).toBeEnabled();
});

test('a press on a panel control leaves the focus on the picture', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  for (const name of ['Auto rotation', /^Bring forward$/]) {
    const before = await editor.settled(() => editor.shownPose('head'));
    await editor.button(name).click();
    await expect(editor.handle('head')).toBeFocused();
    await page.keyboard.press('ArrowRight');
    await expect.poll(async () => (await editor.shownPose('head')).x).toBe(before.x + 1);
  }
  // A field is committed, and loses the focus too.
  await editor.field('x').fill('530');
  await editor.button(/^Bring forward$/).click();
  await page.keyboard.press('ArrowRight');
  await expect.poll(async () => (await editor.shownPose('head')).x).toBe(531);
});

test('after a press on a switch, Space still pans the picture', async ({ page }) => {
  const editor = await Editor.open(page);
  const guard = editor.switch('Stop at folds');
  await guard.click();
  await expect(guard).toBeChecked();
  const before = await editor.position('head');
  await page.keyboard.down('Space');
  await editor.drag({ x: before.x, y: before.y + 120 }, { x: 30, y: 20 });
  await page.keyboard.up('Space');
  await expect
    .poll(async () => {
      const { x, y } = await editor.position('head');
      return [Math.round(x - before.x), Math.round(y - before.y)];
    })
    .toEqual([30, 20]);
  await expect(guard).toBeChecked();
});

test('a control focused by Tab keeps the focus until a pointer press', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  const forward = editor.button(/^Bring forward$/);
  await forward.focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Space');
  await expect(forward).toBeFocused();
  await expect.poll(async () => (await editor.projectHandle('head'))?.depth).toBe(2);
  await forward.click();
  await expect(forward).not.toBeFocused();
});

test('the crosshair stays in view, is announced, and ends with Escape', async ({ page }) => {
  const editor = await Editor.open(page);
  const crosshair = page.locator('c2-warp .crosshair');
  await editor.handle('head').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('p');
  await expect(page.getByRole('status').getByText('Add a point handle')).toBeAttached();
  for (let press = 0; press < 30; press++) await page.keyboard.press('Shift+ArrowUp');
  await expect(crosshair).toBeVisible();
  await expect(page.getByText(/^x \d+, y -?\d+$/)).toBeAttached();
  for (let press = 0; press < 8; press++) await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Enter');
  await expect(editor.handles).toHaveCount(6);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Shift+ArrowUp');
  await expect(crosshair).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(crosshair).toBeHidden();
});

test('a tool chosen by keys places handles by keys at once', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const choose of [
    async () => {
      await editor.button('Save the project file').focus();
      await page.keyboard.press('p');
    },
    async () => {
      await editor.button('Add a point handle').focus();
      await page.keyboard.press('Enter');
    },
  ]) {
    const count = await editor.handles.count();
    await choose();
    for (let step = 0; step < count - 4; step++) await page.keyboard.press('Shift+ArrowDown');
    await page.keyboard.press('Enter');
    await expect(editor.handles).toHaveCount(count + 1);
    await page.keyboard.press('Escape');
  }
});

test('the key list opens by button or key; Escape only closes it', async ({ page }) => {
  const editor = await Editor.open(page);
  const keys = page.getByRole('dialog', { name: 'Keyboard shortcuts' });
  await editor.handle('head').focus();
  await page.keyboard.press('?');
  await expect(keys).toBeVisible();
  await expect(keys).toContainText('Mirror to the other side');
  await page.keyboard.press('Escape');
  await expect(keys).toBeHidden();
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
  await editor.button('Keyboard shortcuts').click();
  await expect(keys).toBeVisible();
  // Beside it.
  await page.mouse.click(8, 400);
  await expect(keys).toBeHidden();
  // The list scrolls in a small editor.
  await page.setViewportSize({ width: 700, height: 420 });
  await page.keyboard.press('?');
  await keys.getByText('Redo').scrollIntoViewIfNeeded();
  await expect(keys.getByText('Redo')).toBeInViewport();
});

test('the original shows while its button is held, with any focus', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('x').focus();
  const { x, y } = await editor.centre(editor.button('Hold to compare with the original'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  await editor.waitFrames();
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  await page.mouse.up();
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeHidden();
});

test('a posable picture discards a number being typed', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  const told = await editor.shownPose('head');
  await editor.field('x').fill('222');
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).posable = true;
  });
  await expect.poll(() => editor.shownPose('head')).toEqual(told);
  expect((await editor.projectHandle('head'))?.posed).toEqual([told.x, told.y]);
});

test('a press into a field selects its number', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('x').click();
  await page.keyboard.type('1,024');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await editor.projectHandle('head'))?.posed[0]).toBe(1024);
  await editor.field('x').click();
  await page.keyboard.type('2000000');
  await page.keyboard.press('Enter');
  await expect(page.getByText('X: enter a number up to 1,000,000.')).toBeVisible();
});

test('every control has a name', async ({ page }) => {
  await Editor.open(page);
  await page.keyboard.press('Control+a');
  for (const control of await page.locator('c2-warp').locator('button:visible, input:visible').all()) {
    await expect(control).toHaveAccessibleName(/\w/);
  }
});

test('Escape in a field reverts the input, and does not reach a dialog', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.evaluate(() => {
    const dialog = document.createElement('dialog');
    document.body.append(dialog);
    Object.assign(dialog.style, { width: '90vw', height: '90vh' });
    const warp = document.querySelector('c2-warp');
    if (warp) dialog.append(warp);
    dialog.showModal();
  });
  await editor.ready();
  await editor.handle('head').click();
  await editor.field('x').fill('77');
  await page.keyboard.press('Escape');
  await expect(editor.field('x')).toHaveValue('512');
  await expect(page.locator('dialog')).toBeVisible();
});

test('keys of other scripts are commands by their position', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('ArrowUp');
  await expect(editor.button('Undo: move head')).toBeEnabled();
  await page.locator('c2-warp .shell').evaluate((shell) =>
    shell.dispatchEvent(
      new KeyboardEvent('keydown', {
        key: 'я',
        code: 'KeyZ',
        ctrlKey: true,
        bubbles: true,
        composed: true,
      }),
    ),
  );
  await expect(editor.button('Undo')).toBeDisabled();
});

test('the key of O shows the original while held in other scripts too', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  const keyboard = await page.context().newCDPSession(page);
  const key = { key: 'щ', code: 'KeyO', windowsVirtualKeyCode: 79 };
  const original = page.locator('c2-warp p.hint', { hasText: 'Original' });
  await keyboard.send('Input.dispatchKeyEvent', { type: 'keyDown', ...key });
  await expect(original).toBeVisible();
  await keyboard.send('Input.dispatchKeyEvent', { type: 'keyUp', ...key });
  await expect(original).toBeHidden();
});

test('keys work inside a closed shadow root', async ({ page }) => {
  await Editor.open(page);
  await page.evaluate(() => {
    const host = document.createElement('div');
    const warp = document.querySelector('c2-warp') as C2Warp;
    document.body.append(host);
    Object.assign(warp.style, { display: 'block', height: '600px' });
    host.attachShadow({ mode: 'closed' }).append(warp);
    Object.assign(globalThis, { warp });
  });
  const moved = () =>
    page.evaluate(() => (Reflect.get(globalThis, 'warp') as C2Warp).mapPoint([512, 260]) !== null);
  await expect.poll(moved).toBe(true);
  const press = async (what: string) => {
    const at = await page.evaluate(async (what) => {
      const warp = Reflect.get(globalThis, 'warp') as C2Warp;
      await warp.updateComplete;
      const box = warp.shadowRoot?.querySelector(what)?.getBoundingClientRect();
      return box ? { x: box.x + box.width / 2, y: box.y + box.height / 2 } : { x: 0, y: 0 };
    }, what);
    await page.mouse.click(at.x, at.y);
  };
  const count = () => page.evaluate(() => (Reflect.get(globalThis, 'warp') as C2Warp).project.handles.length);
  await press('[data-handle="head"]');
  await press('.panel [data-command="remove"]');
  await expect.poll(count).toBe(4);
  await page.keyboard.press('Control+z');
  await expect.poll(count).toBe(5);
});

test('a plain click, as from a screen reader, toggles the original', async ({ page }) => {
  const editor = await Editor.open(page);
  const compare = editor.button(/compare/i);
  await compare.evaluate((button) => (button as HTMLElement).click());
  await expect(compare).toHaveAttribute('aria-pressed', 'true');
  await compare.evaluate((button) => (button as HTMLElement).click());
  await expect(compare).toHaveAttribute('aria-pressed', 'false');
  await compare.focus();
  await page.keyboard.press('Enter');
  await expect(compare).toHaveAttribute('aria-pressed', 'false');
});
