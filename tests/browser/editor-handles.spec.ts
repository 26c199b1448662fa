/** Placing, dragging, turning and undoing with a mouse. */
import type { C2Warp } from '../../web/src/element';
import { Editor, meanDifference } from './editor';
import { expect, test } from './fixtures';

test('the sample opens with five handles, a hint and the solver’s report', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect(editor.handles).toHaveCount(5);
  await expect(page.getByText('Drag a hand')).toBeVisible();
  await expect(editor.status).toContainText(/[\d,]+ samples/);
  await expect(editor.status).toContainText(/helper point/);
});

test('dragging a hand bends the arm only, and is one undo step', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  const goal = { x: hand.x - 10, y: hand.y - 80 };
  const arm = await editor.screenshot(goal);
  await editor.dragHandle('right hand', { x: -10, y: -80 });

  const zoom = await editor.zoom();
  const told = await editor.settled(() => editor.shownPose('right hand'));
  expect(Math.abs(told.x - (900 - 10 / zoom))).toBeLessThan(12);
  expect(Math.abs(told.y - (516 - 80 / zoom))).toBeLessThan(12);
  await expect(page.getByText('Drag a hand')).toBeHidden();
  await expect.poll(async () => meanDifference(arm, await editor.screenshot(goal))).toBeGreaterThan(10);
  // Handles stay within a hundredth of a pixel; the picture may turn about them.
  const slip = async () => {
    const [x, y] = await page
      .locator('c2-warp')
      .evaluate((element) => (element as C2Warp).mapPoint([312, 1126]) ?? [0, 0]);
    return Math.hypot(x - 312, y - 1126);
  };
  await expect.poll(slip).toBeLessThan(0.01);
  // The label has whole degrees, the field tenths. At densities from 50 to 600 the foot turns by 1.8° to 3.2°.
  await editor.handle('left foot').click();
  await expect
    .poll(async () => Math.abs(Number(await editor.field('rotation').inputValue())))
    .toBeLessThan(4);

  await page.keyboard.press('Control+z');
  await expect.poll(() => editor.shownPose('right hand')).toEqual({ x: 900, y: 516, rotation: 0 });
  await expect(editor.button('Undo')).toBeDisabled();
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => editor.shownPose('right hand')).toEqual(told);
});

test('the ring and Alt-drags turn a handle, in 15° steps with Shift', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = await editor.position('head');
  await page.mouse.click(head.x, head.y);
  // The knob of the ring is 40 px above the handle.
  await editor.drag({ x: head.x, y: head.y - 40 }, { x: 40, y: 40 });
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBeCloseTo(90, 0);
  await page.keyboard.press('Control+z');

  await page.keyboard.down('Shift');
  await editor.drag({ x: head.x, y: head.y - 40 }, { x: 25, y: 12 });
  await page.keyboard.up('Shift');
  await expect.poll(async () => (await editor.shownPose('head')).rotation % 15).toBe(0);
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBeGreaterThan(0);
  await page.keyboard.press('Control+z');

  await page.keyboard.down('Alt');
  await page.mouse.move(head.x, head.y);
  await page.mouse.down();
  await page.mouse.move(head.x + 30, head.y);
  await page.mouse.move(head.x, head.y + 30);
  await page.mouse.up();
  await page.keyboard.up('Alt');
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBeCloseTo(90, 0);
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 512, y: 260 });
});

test('a handle placed on the posed picture does not move it', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left foot', { x: -60, y: 10 });
  const head = await editor.position('head');
  const belly = { x: head.x, y: head.y + 180 };
  /** Returns the posed position of the red button beside the new handle. */
  const button = () =>
    page.locator('c2-warp').evaluate((element) => (element as C2Warp).mapPoint([512, 835]));
  const before = await editor.settled(button);
  await page.keyboard.press('p');
  await editor.waitForSolve(() => page.mouse.click(belly.x, belly.y));
  await expect(editor.handles).toHaveCount(6);
  await expect(editor.handle('handle 1')).toHaveAttribute('aria-pressed', 'true');

  const away = async () => {
    const added = await editor.position('handle 1');
    return Math.abs(added.x - belly.x) + Math.abs(added.y - belly.y);
  };
  await expect.poll(away).toBeLessThan(3);
  // The new handle is within a hundredth of a pixel of its point.
  const slip = () =>
    page.locator('c2-warp').evaluate((element) => {
      const warp = element as C2Warp;
      const handle = warp.project.handles.at(-1);
      if (handle?.kind !== 'point') return Number.POSITIVE_INFINITY;
      const [x, y] = warp.mapPoint(handle.rest) ?? [0, 0];
      return Math.hypot(x - handle.posed[0], y - handle.posed[1]);
    });
  await expect.poll(slip).toBeLessThan(0.01);
  const jump = async () => {
    const after = await button();
    return Math.hypot((after?.[0] ?? 0) - (before?.[0] ?? 0), (after?.[1] ?? 0) - (before?.[1] ?? 0));
  };
  await expect.poll(jump).toBeLessThan(8);
  await page.keyboard.press('Delete');
  await expect(editor.handles).toHaveCount(5);
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(6);
});

test('no handle can be placed beside the picture, and a notice says so', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('p');
  const hand = await editor.position('left hand');
  await page.mouse.click(hand.x, hand.y + 150);
  await expect(page.getByText('Place the handle on the picture')).toBeVisible();
  await expect(editor.handles).toHaveCount(5);
});

test('a press just outside a shape places the handle on the shape', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate(async (element) => {
    const canvas = new OffscreenCanvas(64, 64);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('no canvas');
    context.arc(32, 32, 20, 0, 7);
    context.fill();
    await (element as C2Warp).load(await canvas.convertToBlob());
  });
  await page.keyboard.press('p');
  const centre = await editor.centre(page.getByRole('application'));
  await page.mouse.click(centre.x, centre.y);
  await expect(editor.handle('handle 1')).toBeVisible();
  const middle = await editor.settled(() => editor.shownPose('handle 1'));
  const scale = await editor.zoom();
  for (const [count, degrees] of [10, 130, 250].entries()) {
    const [x, y] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    // The shape ends 20 px from its centre.
    await page.mouse.click(
      centre.x + (32 + 20.7 * x - middle.x) * scale,
      centre.y + (32 + 20.7 * y - middle.y) * scale,
    );
    await expect(editor.handles).toHaveCount(count + 2);
    const placed = await editor.shownPose(`handle ${count + 2}`);
    const away = Math.hypot(placed.x - 32, placed.y - 32);
    expect(away).toBeGreaterThan(19);
    expect(away).toBeLessThan(20.5);
  }
  await expect(page.getByText(/^[1-9]\d* helper points/)).toBeVisible();
  await expect(editor.notice).toBeHidden();
});

for (const [key, after] of [
  ['Delete', 'delete left hand'],
  ['ArrowLeft', 'move left hand'],
] as const) {
  test(`${key} during a drag ends it, and both can be undone`, async ({ page }) => {
    const editor = await Editor.open(page);
    const hand = await editor.position('left hand');
    await page.mouse.move(hand.x, hand.y);
    await page.mouse.down();
    await page.mouse.move(hand.x + 40, hand.y - 40);
    const dragged = await editor.settled(() => editor.shownPose('left hand'));
    await page.keyboard.press(key);
    await page.mouse.move(hand.x + 80, hand.y - 80);
    await page.mouse.up();
    await expect(editor.handles).toHaveCount(key === 'Delete' ? 4 : 5);
    await editor.button(`Undo: ${after}`).click();
    await expect.poll(() => editor.shownPose('left hand')).toEqual(dragged);
    await editor.button('Undo: move left hand').click();
    await expect.poll(async () => (await editor.shownPose('left hand')).x).toBe(124);
    await expect(editor.button('Undo')).toBeDisabled();
  });
}

test('Enter does not end the placement of a handle by pointer', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('p');
  const at = await editor.fromImage('left hand', [124, 516]);
  const [from, to] = [at(512, 640), at(512, 740)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x, from.y + 20, { steps: 2 });
  await page.locator('c2-warp .stage').press('Enter');
  await page.mouse.move(to.x, to.y, { steps: 2 });
  await page.mouse.up();
  await expect.poll(async () => (await editor.shownPose('handle 1')).y).toBeCloseTo(740, -1);
  await expect(editor.handles).toHaveCount(6);
  await editor.button('Undo: add handle').click();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('a handle selected in the list moves by keys', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp .list .item', { hasText: 'head' }).click();
  await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await editor.shownPose('head')).x).toBe(522);
});

test('the list scrolls handles into view; Control and Shift select several', async ({ page }) => {
  const editor = await Editor.open(page);
  const listed = (name: string) => page.locator('c2-warp .item').filter({ hasText: name });
  await editor.button('Actual size').click();
  for (let notch = 0; notch < 3; notch++) await editor.button('Zoom in').click();
  const stage = await page.locator('c2-warp .stage').boundingBox();
  const [left, top, right, bottom] = [stage?.x ?? 0, stage?.y ?? 0, 900 - 248, 700];
  for (const name of ['Left foot', 'Head', 'Right hand']) {
    await listed(name).click();
    await expect
      .poll(async () => {
        const { x, y } = await editor.position(name.toLowerCase());
        return x > left && y > top && x < right && y < bottom;
      }, name)
      .toBe(true);
  }
  await listed('Head').click({ modifiers: ['ControlOrMeta'] });
  await listed('Left foot').click({ modifiers: ['Shift'] });
  await expect(page.getByRole('heading', { name: '3 handles' })).toBeVisible();
  await listed('Head').click({ modifiers: ['ControlOrMeta'] });
  await expect(page.getByRole('heading', { name: '2 handles' })).toBeVisible();
});

test('an invalid number is reported, and the old one restored', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  for (const [field, typed, words] of [
    ['scale', '0', 'Scale: enter a number from 0.01 to 100.'],
    ['x', '900+20', 'X: enter a number, such as 120'],
    ['scale', '150%', 'Scale: enter a number from 0.01 to 100.'],
  ] as const) {
    const before = await editor.field(field).inputValue();
    await editor.field(field).fill(typed);
    await editor.field(field).press('Enter');
    await expect(page.getByText(words)).toBeVisible();
    await expect(editor.field(field)).toHaveValue(before);
  }
  await page.locator('c2-warp .notice').getByRole('button', { name: 'Dismiss' }).click();
  const field = editor.field('x');
  await field.fill('');
  await field.press('Enter');
  await expect(field).not.toHaveValue('');
  await expect(page.locator('c2-warp .notice')).toBeHidden();
});

test('Escape reverts a drag', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('left hand');
  await page.mouse.move(hand.x, hand.y);
  await page.mouse.down();
  await page.mouse.move(hand.x + 40, hand.y - 40);
  await page.keyboard.press('Escape');
  await page.mouse.move(hand.x + 80, hand.y - 80);
  await page.mouse.up();
  expect(await editor.settled(() => editor.shownPose('left hand'))).toMatchObject({ x: 124, y: 516 });
  await expect(editor.button('Undo')).toBeDisabled();
});

test('a drag back to its start adds no step and keeps the redo', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    element.addEventListener('historychange', (event) =>
      Object.assign(globalThis, { told: (event as CustomEvent).detail }),
    );
  });
  await editor.dragHandle('left hand', { x: 10, y: -40 });
  await page.keyboard.press('Control+z');
  await expect(editor.button('Redo: move left hand')).toBeEnabled();

  const { x, y } = await editor.position('right hand');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y - 50, { steps: 3 });
  await expect(editor.button('Undo: move right hand')).toBeEnabled();
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.up();
  await expect(editor.handle('right hand')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.button('Undo')).toBeDisabled();
  await expect(editor.button('Redo: move left hand')).toBeEnabled();
  expect(await page.evaluate(() => Reflect.get(globalThis, 'told'))).toEqual({
    undo: null,
    redo: 'Move left hand',
  });
});

test('a box selects both feet, Shift-click adds, and all move together', async ({ page }) => {
  const editor = await Editor.open(page);
  const [left, right] = [await editor.position('left foot'), await editor.position('right foot')];
  await editor.drag({ x: left.x - 60, y: left.y - 40 }, { x: right.x - left.x + 120, y: 60 });
  await page.keyboard.down('Shift');
  await page.mouse.click((await editor.position('head')).x, (await editor.position('head')).y);
  await page.keyboard.up('Shift');
  await expect(page.getByRole('heading', { name: '3 handles' })).toBeVisible();
  await editor.drag(left, { x: 0, y: -20 });
  const moved = async () => {
    const told = await Promise.all(['left foot', 'right foot', 'head'].map((name) => editor.shownPose(name)));
    return told.map(({ y }, k) => y < (k < 2 ? 1126 : 260));
  };
  await expect.poll(moved).toEqual([true, true, true]);
});

test('a number being typed survives a redraw of the editor', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('x').fill('540');
  const zoom = await editor.zoom();
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  await expect.poll(() => editor.zoom()).not.toBe(zoom);
  await expect(editor.field('x')).toHaveValue('540');
  await editor.field('x').press('Enter');
  await expect.poll(async () => (await editor.shownPose('head')).x).toBe(540);

  // A discarded number, or one set elsewhere, shows the current value.
  await editor.field('x').fill('300');
  await editor.field('x').press('Escape');
  await expect(editor.field('x')).toHaveValue('540');
  await page.keyboard.press('ArrowRight');
  await expect(editor.field('x')).toHaveValue('541');
});

test('numbers accept a comma, and arrow keys step each selected handle', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('x').fill('510,5');
  await editor.field('x').press('Enter');
  await expect(editor.field('x')).toHaveValue('510.5');
  await editor.field('x').press('Shift+ArrowUp');
  await expect(editor.field('x')).toHaveValue('520.5');
  await editor.handle('left hand').click({ modifiers: ['Shift'] });
  await expect(editor.field('x')).toHaveValue('');
  await editor.field('x').press('ArrowUp');
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 522 });
  await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 125 });
  await editor.field('x').fill('x');
  await editor.field('x').press('Enter');
  await expect(editor.field('x')).toHaveValue('');
});

test('a move without buttons ends a drag whose release was missed', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  await page.evaluate(() =>
    addEventListener('pointerup', (event) => event.stopPropagation(), { capture: true, once: true }),
  );
  await editor.drag(hand, { x: -20, y: -40 });
  const left = await editor.settled(() => editor.shownPose('right hand'));
  await page.mouse.move(hand.x - 200, hand.y + 100, { steps: 3 });
  expect(await editor.settled(() => editor.shownPose('right hand'))).toEqual(left);
  await expect(editor.button('Undo: move right hand')).toBeEnabled();
});

test('handles are grabbed where they appear in a scaled editor', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [property, value] of [
    ['scale', '0.6'],
    ['zoom', '1.5'],
  ] as const) {
    const styled = (value: string) =>
      page
        .locator('c2-warp')
        .evaluate(
          (element, [property, value]) => (element as HTMLElement).style.setProperty(property, value),
          [property, value] as const,
        );
    await styled(value);
    const before = await editor.settled(() => editor.shownPose('left foot'));
    await editor.dragHandle('left foot', { x: 12, y: 0 });
    await expect
      .poll(async () => (await editor.shownPose('left foot')).x, property)
      .toBeGreaterThan(before.x + 5);
    await styled('');
  }
});

test('each number is one step, and reset restores one handle or all', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('rotation').fill('30');
  await editor.field('rotation').press('Enter');
  await editor.field('x').fill('540');
  await editor.field('x').press('Tab');
  await expect.poll(() => editor.shownPose('head')).toEqual({ x: 540, y: 260, rotation: 30 });
  await editor.field('y').fill('');
  await editor.field('y').press('Enter');
  await expect(editor.field('y')).toHaveValue('260');

  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await editor.handle('head').click();
  await editor.button('Reset to rest').click();
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 512, y: 260 });
  // At rest the turn is automatic again, and the moved hand turns the head a little.
  await expect(editor.button('Auto rotation')).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(async () => (await editor.shownPose('left hand')).x).not.toBe(124);
  await editor.button('Reset all handles').click();
  await expect.poll(() => editor.shownPose('left hand')).toEqual({ x: 124, y: 516, rotation: 0 });
  for (let step = 0; step < 5; step++) await editor.button('Undo').click();
  await expect(editor.button('Undo')).toBeDisabled();
});
