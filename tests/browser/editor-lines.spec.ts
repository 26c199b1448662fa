/** Bars and polygons: drawing, bending, moving, turning, and rejection by the solver. */

import { Editor, meanDifference, type Position } from './editor';
import { send, touch } from './fingers';
import { expect, test } from './fixtures';
import { WorkerReplies } from './worker_replies';

/** A line in the left leg of the sample, from below the foot's handle to the hip, image pixels. */
const [ANKLE, HIP] = [
  [330, 1040],
  [430, 820],
] as const;

async function clicks(editor: Editor, places: readonly Position[]): Promise<void> {
  for (const at of places) await editor.page.mouse.click(at.x, at.y);
}

/** Waits until the solution maps a handle's corner to its posed position. */
const settles = (editor: Editor, rest: readonly [number, number], posed: readonly [number, number]) =>
  expect.poll(() => editor.mappedDistance(rest, posed)).toBeLessThan(1);

/** Adds a bar in the left leg, and waits for the solution. */
async function leg(editor: Editor): Promise<(x: number, y: number) => Position> {
  const at = await editor.fromImage('head', [512, 260]);
  await editor.page.keyboard.press('b');
  await clicks(editor, [at(...ANKLE), at(...HIP)]);
  await editor.waitForSolve(() => editor.page.keyboard.press('Enter'));
  await expect(editor.handle('bar 1')).toHaveAttribute('aria-pressed', 'true');
  return at;
}

test('a bar is drawn by clicks and bent by one end, each undone alone', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('b');
  const [first, second] = [at(...ANKLE), at(...HIP)];
  await page.mouse.click(first.x, first.y);
  await page.mouse.move(second.x, second.y);
  // The line to the pointer, before the next click.
  await expect(page.locator('c2-warp .draft .next')).toBeAttached();
  await expect(page.getByRole('group', { name: 'Drawing' })).toContainText('One more corner');
  await page.mouse.dblclick(second.x, second.y);
  await expect(page.getByRole('group', { name: 'Drawing' })).toBeHidden();
  await expect(editor.handle('bar 1')).toBeFocused();
  expect(await editor.projectHandle('bar-1')).toMatchObject({ kind: 'bar', rotation: 'auto', scale: 1 });

  const goal = at(240, 980);
  const before = await editor.screenshot(goal);
  const end = await editor.centre(editor.corner(1, 'bar 1'));
  await editor.drag(end, { x: goal.x - end.x, y: goal.y - end.y });
  await expect.poll(async () => (await editor.shownPose('bar 1')).rotation).toBeGreaterThan(10);
  const bent = await editor.projectHandle('bar-1');
  if (bent?.kind !== 'bar') throw new Error('a bar stays one');
  expect(bent.posed[1]).toEqual(bent.rest[1]);
  // The picture follows the corners.
  for (const k of [0, 1]) await settles(editor, bent.rest[k] ?? [0, 0], bent.posed[k] ?? [0, 0]);
  await expect.poll(async () => meanDifference(before, await editor.screenshot(goal))).toBeGreaterThan(10);

  await editor.button('Undo: move a corner of bar 1').click();
  await expect.poll(async () => (await editor.shownPose('bar 1')).rotation).toBe(0);
  await editor.button('Undo: add bar').click();
  await expect(editor.handle('bar 1')).toBeHidden();
  await expect(editor.button('Undo')).toBeDisabled();
  await editor.button('Redo: add bar').click();
  await expect(editor.handle('bar 1')).toBeVisible();
});

test('one drag draws a whole bar, with Shift in steps of 45°', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await editor.button('Draw a bar').click();
  await page.keyboard.down('Shift');
  const [from, to] = [at(440, 700), at(570, 720)];
  await editor.drag(from, { x: to.x - from.x, y: to.y - from.y });
  await page.keyboard.up('Shift');
  await expect(editor.handle('bar 1')).toBeVisible();
  const bar = await editor.projectHandle('bar-1');
  if (bar?.kind !== 'bar') throw new Error('a bar was drawn');
  expect(bar.posed).toHaveLength(2);
  expect(bar.posed[1]?.[1]).toBeCloseTo(bar.posed[0]?.[1] ?? 0, 1);
});

test('a double click adds a corner that bends the bar, or removes one', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await leg(editor);
  await page.keyboard.press('v');
  const corners = () =>
    editor.projectHandle('bar-1').then((bar) => (bar?.kind === 'bar' ? bar.posed.length : 0));
  const [knee, bent] = [at(380, 930), at(340, 930)];
  await page.mouse.dblclick(knee.x, knee.y);
  await expect(editor.corner(2, 'bar 1')).toBeFocused();
  await editor.drag(knee, { x: bent.x - knee.x, y: 0 });
  const bar = await editor.projectHandle('bar-1');
  if (bar?.kind !== 'bar' || bar.posed.length !== 3) throw new Error('the bar has a knee');
  for (const k of [0, 1, 2]) await settles(editor, bar.rest[k] ?? [0, 0], bar.posed[k] ?? [0, 0]);
  expect(bar.posed[1]?.[0]).toBeLessThan((bar.rest[1]?.[0] ?? 0) - 30);

  await page.mouse.dblclick(bent.x, bent.y);
  await expect(editor.button('Undo: delete a corner of bar 1')).toBeEnabled();
  expect(await corners()).toBe(2);
  // The ends stay: a bar needs two.
  const ankle = at(...ANKLE);
  await page.mouse.dblclick(ankle.x, ankle.y);
  expect(await corners()).toBe(2);
  await page.keyboard.press('Control+z');
  await expect.poll(corners).toBe(3);
});

test('keys add a corner beside the focused one, and delete it', async ({ page }) => {
  const editor = await Editor.open(page);
  await leg(editor);
  await page.keyboard.press('v');
  await editor.corner(2, 'bar 1').focus();
  await page.keyboard.press('c');
  // No edge follows an end, so the corner is added before it.
  await expect(editor.corner(2, 'bar 1')).toBeFocused();
  await expect(editor.corner(3, 'bar 1')).toBeVisible();
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(editor.button('Undo: move a corner of bar 1')).toBeEnabled();
  await page.keyboard.press('x');
  await expect(editor.corner(1, 'bar 1')).toBeFocused();
  await expect(editor.corner(3, 'bar 1')).toBeHidden();
  // A bar needs two corners.
  await page.keyboard.press('x');
  await expect(editor.corner(2, 'bar 1')).toBeVisible();
  await editor.button('Add a corner').click();
  await expect(editor.corner(2, 'bar 1')).toBeFocused();
  await expect(editor.corner(3, 'bar 1')).toBeVisible();
});

test('a clicked corner shows its position and buttons in the panel', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await leg(editor);
  await page.keyboard.press('v');
  const [group, hip] = [page.getByRole('group', { name: 'Corner 2 of 2' }), at(...HIP)];
  await expect(group).toBeHidden();
  await page.mouse.click(hip.x, hip.y);
  const before = await editor.projectHandle('bar-1');
  if (before?.kind !== 'bar' || !before.posed[1]) throw new Error('a bar was drawn');
  const [x, y] = [
    group.getByRole('spinbutton', { name: 'X (' }),
    group.getByRole('spinbutton', { name: 'Y (' }),
  ];
  await expect(x).toHaveValue(String(Number(before.posed[1][0].toFixed(1))));
  await x.fill('450');
  await y.focus();
  await page.keyboard.press('Shift+ArrowUp');
  await expect(editor.button('Undo: move a corner of bar 1')).toBeEnabled();
  expect(await editor.projectHandle('bar-1')).toMatchObject({
    posed: [before.posed[0], [450, before.posed[1][1] + 10]],
    rest: before.rest,
  });
  // Two corners are needed. A third is added halfway, and removed again.
  await expect(editor.button('Delete the corner')).toBeDisabled();
  await editor.button('Add a corner').click();
  const third = page.getByRole('group', { name: 'Corner 2 of 3' });
  await expect(third.getByRole('spinbutton', { name: 'X (' })).toHaveValue(
    String(Number(((before.posed[0]?.[0] ?? 0) / 2 + 225).toFixed(1))),
  );
  await editor.button('Delete the corner').click();
  await expect(page.getByRole('group', { name: 'Corner 1 of 2' })).toBeVisible();
  // The handle as a whole.
  await editor.handle('bar 1').focus();
  await expect(page.getByRole('group', { name: 'Corner' })).toBeHidden();
});

test('the draft line follows the pointer when the view moves', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Draw a bar').click();
  const head = await editor.position('head');
  await page.mouse.click(head.x, head.y + 50);
  await page.mouse.move(head.x + 60, head.y + 40);
  const line = page.locator('c2-warp .draft .next');
  /** Returns the end of the line on the page, from the path data. */
  const end = () =>
    line.evaluate((path: SVGPathElement) => {
      const [x = 0, y = 0] = (path.getAttribute('d') ?? '').split('L').at(-1)?.split(',').map(Number) ?? [];
      const stage = path.ownerSVGElement?.getBoundingClientRect();
      return [Math.round(x + (stage?.x ?? 0)), Math.round(y + (stage?.y ?? 0))];
    });
  const pointer = [Math.round(head.x + 60), Math.round(head.y + 40)];
  await expect.poll(end).toEqual(pointer);
  const corner = page.locator('c2-warp .draft .corner');
  const left = Number(await corner.getAttribute('cx'));
  await page.mouse.wheel(30, 50);
  await expect.poll(async () => Number(await corner.getAttribute('cx'))).toBeCloseTo(left - 30);
  expect(await end()).toEqual(pointer);
  const zoom = await editor.zoom();
  await page.keyboard.press('+');
  await expect.poll(() => editor.zoom()).toBeGreaterThan(zoom);
  expect(await end()).toEqual(pointer);
});

test('a polygon closes on its first corner and moves the picture inside', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('g');
  const belly = [at(440, 780), at(584, 780), at(560, 900), at(464, 900)];
  await clicks(editor, belly);
  const first = at(442, 782);
  await page.mouse.move(first.x, first.y);
  await expect(page.locator('c2-warp .draft .hot')).toBeAttached();
  await page.mouse.click(first.x, first.y);
  await expect(editor.handle('polygon 1')).toBeVisible();
  await page.keyboard.press('v');
  // Dragged by its inside, away from corners, ring and middle.
  const inside = at(480, 800);
  await editor.drag(inside, { x: 30, y: 20 });
  const [dx, dy] = [30, 20].map((by) => by / (at(1, 0).x - at(0, 0).x));
  await expect.poll(async () => (await editor.shownPose('polygon 1')).rotation).toBe(0);
  await expect
    .poll(() => editor.mappedDistance([512, 840], [512 + (dx ?? 0), 840 + (dy ?? 0)]))
    .toBeLessThan(12);
  await expect(editor.button('Undo: move polygon 1')).toBeEnabled();
});

test('a draft survives a reload and continues with its tool', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('g');
  await clicks(editor, [at(440, 700), at(570, 720)]);
  const kept = async () =>
    (await editor.storedWork()).drawings?.map(({ kind, corners }) => [kind, corners.length]);
  await expect.poll(kept).toEqual([['polygon', 2]]);
  await page.reload();
  await editor.ready();
  const corners = page.locator('c2-warp .draft .corner');
  await expect(corners).toHaveCount(2);
  await expect(editor.button('Draw a polygon')).toHaveAttribute('aria-pressed', 'true');
  await clicks(editor, [at(520, 800)]);
  await editor.waitForSolve(() => page.keyboard.press('Enter'));
  const polygon = await editor.projectHandle('polygon-1');
  expect(polygon?.kind === 'polygon' && polygon.posed).toHaveLength(3);
  // No draft is stored any more.
  await expect.poll(kept).toEqual([]);
});

test('Backspace and Ctrl Z remove the last corner; Escape the draft', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const corners = page.locator('c2-warp .draft .corner');
  await page.keyboard.press('g');
  await clicks(editor, [at(440, 780), at(584, 780), at(560, 900)]);
  await expect(corners).toHaveCount(3);
  await page.keyboard.press('Backspace');
  await expect(corners).toHaveCount(2);
  await page.keyboard.press('Control+z');
  await expect(corners).toHaveCount(1);
  await page.keyboard.press('Escape');
  await expect(corners).toHaveCount(0);
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('redo restores only the corner that was undone', async ({ page }) => {
  const editor = await Editor.open(page);
  const corners = page.locator('c2-warp .draft .corner');
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await page.keyboard.press('Control+z');
  await expect(editor.button('Redo: move left hand')).toBeEnabled();
  const told = await editor.shownPose('left hand');
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('g');
  await clicks(editor, [at(440, 780), at(584, 780), at(560, 900)]);
  await expect(editor.button('Redo')).toBeDisabled();
  await page.keyboard.press('Control+z');
  await expect(corners).toHaveCount(2);
  await page.keyboard.press('Control+Shift+z');
  await expect(corners).toHaveCount(3);
  await editor.button('Undo: place a corner').click();
  await expect(corners).toHaveCount(2);
  await editor.button('Redo: place a corner').click();
  await expect(corners).toHaveCount(3);
  // The first corner too. After the draft is discarded, redo applies to the hand again.
  for (const left of [2, 1, 0]) {
    await page.keyboard.press('Control+z');
    await expect(corners).toHaveCount(left);
  }
  await page.keyboard.press('Control+Shift+z');
  await expect(corners).toHaveCount(1);
  expect(await editor.shownPose('left hand')).toEqual(told);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+Shift+z');
  await expect(editor.button('Undo: move left hand')).toBeEnabled();
});

test('Enter finishes after a press on a button of the draft bar too', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('g');
  await clicks(editor, [at(440, 780), at(584, 780), at(560, 900), at(440, 900)]);
  await editor.button('Remove the last corner').click();
  await expect(page.locator('c2-warp .draft .corner')).toHaveCount(3);
  await page.keyboard.press('Enter');
  await expect(editor.handle('polygon 1')).toBeVisible();
  expect((await editor.projectHandle('polygon-1'))?.kind).toBe('polygon');
});

test('a draft ends with its tool, and its notice continues it', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const draft = page.locator('c2-warp .draft');
  const card = page.getByRole('group', { name: 'Drawing' });
  for (const [key, tool] of [
    ['b', 'Draw a bar'],
    ['g', 'Draw a polygon'],
    ['l', 'Lasso: draw around the part to bend'],
  ] as const) {
    for (const other of ['v', 'p', 'f', 'h', 'i']) {
      await page.keyboard.press(key);
      await clicks(editor, [at(440, 780), at(584, 780)]);
      await expect(draft).toBeAttached();
      await page.keyboard.press(other);
      await expect(draft).toHaveCount(0);
      await expect(card).toBeHidden();
      // The card of the lens closes.
      if (other === 'i') await page.keyboard.press(other);
      await page.keyboard.press(key);
      await expect(editor.button(tool)).toHaveAttribute('aria-pressed', 'true');
      await expect(draft).toHaveCount(0);
    }
  }
  await page.keyboard.press('g');
  await clicks(editor, [at(440, 780), at(584, 780), at(560, 900)]);
  await editor.button('Select and move').click();
  await expect(page.getByText('The drawing has ended.')).toBeVisible();
  await editor.button('Continue drawing').click();
  await expect(editor.button('Draw a polygon')).toHaveAttribute('aria-pressed', 'true');
  await expect(card).toContainText('Add corners, or finish');
  await page.keyboard.press('Enter');
  await expect(editor.handle('polygon 1')).toBeVisible();
});

test('keys draw a bar, move one end, turn it and delete it', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('b');
  await page.keyboard.press('Enter');
  await expect(page.getByText(/bar, corner 1: x \d+, y \d+/)).toBeAttached();
  for (let step = 0; step < 4; step++) await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Enter');
  // Without an arrow key in between, Enter finishes.
  await page.keyboard.press('Enter');
  await expect(editor.handle('bar 1')).toBeFocused();
  await expect.poll(async () => (await editor.shownPose('bar 1')).rotation).toBe(0);

  await page.keyboard.press('Tab');
  await expect(editor.corner(1, 'bar 1')).toBeFocused();
  const before = await editor.shownPose('bar 1');
  for (let step = 0; step < 3; step++) await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await editor.shownPose('bar 1')).x).toBe(before.x + 15);
  await expect(editor.button('Undo: move a corner of bar 1')).toBeEnabled();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect.poll(async () => (await editor.shownPose('bar 1')).x).toBe(before.x + 5);
  const turned = await editor.settled(() => editor.shownPose('bar 1'));
  await page.keyboard.press('Shift+Period');
  await expect.poll(async () => (await editor.shownPose('bar 1')).rotation).toBe(turned.rotation + 15);
  await page.keyboard.press('Delete');
  await expect(editor.handle('bar 1')).toBeHidden();
});

test('the panel moves, turns beyond half a turn, and resets a bar', async ({ page }) => {
  const editor = await Editor.open(page);
  await leg(editor);
  const rest = await editor.projectHandle('bar-1');
  await editor.field('x').fill('360');
  await editor.field('x').press('Enter');
  await editor.field('rotation').fill('270');
  await editor.field('rotation').press('Enter');
  await expect.poll(() => editor.shownPose('bar 1')).toMatchObject({ x: 360, rotation: 270 });
  await expect(editor.button('Auto rotation')).toBeHidden();
  await editor.button('Reset to rest').click();
  // The turn took the bar across the other leg. Its depth is not a part of the pose.
  await expect.poll(() => editor.projectHandle('bar-1')).toEqual({ ...rest, depth: 1 });
});

test('selection box, Shift-click and arrow keys work on bars and points', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await leg(editor);
  await page.keyboard.press('Escape');
  await page.keyboard.press('v');
  const [corner, opposite] = [at(250, 960), at(400, 1180)];
  await editor.drag(corner, { x: opposite.x - corner.x, y: opposite.y - corner.y });
  await expect(page.getByRole('heading', { name: '2 handles' })).toBeVisible();
  const [bar, foot] = [await editor.shownPose('bar 1'), await editor.shownPose('left foot')];
  await page.keyboard.press('ArrowUp');
  await expect.poll(async () => (await editor.shownPose('bar 1')).y).toBe(bar.y - 1);
  await expect.poll(async () => (await editor.shownPose('left foot')).y).toBe(foot.y - 1);
  await page.keyboard.down('Shift');
  const line = at(380, 930);
  await page.mouse.click(line.x, line.y);
  await page.keyboard.up('Shift');
  await expect(page.getByRole('heading', { name: 'Left foot' })).toBeVisible();
});

test('a rejected bar leaves nothing behind, and the next bar is one of its own', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const draft = page.locator('c2-warp .draft');
  const legs = [at(330, 900), at(330, 1000)] as const;
  await page.keyboard.press('b');
  await editor.drag(at(60, 900), { x: 40, y: 40 });
  await expect(editor.notice).toContainText('“bar 1” lies outside the shape');
  await expect(draft).toHaveCount(0);
  await expect(editor.handles).toHaveCount(5);
  await page.keyboard.press('v');
  await expect(draft).toHaveCount(0);
  await page.keyboard.press('b');
  await editor.drag(legs[0], { x: 0, y: legs[1].y - legs[0].y });
  await expect(editor.handle('bar 1')).toBeVisible();
  const bar = await editor.projectHandle('bar-1');
  expect(bar?.kind === 'bar' && bar.posed).toHaveLength(2);
});

test('a rejected bar is continued by its notice, and later changes stay', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await replies.hold();
  await page.keyboard.press('b');
  await clicks(editor, [at(60, 900), at(160, 1000)]);
  await page.keyboard.press('Enter');
  await page.keyboard.press('p');
  const heart = at(512, 600);
  await page.mouse.click(heart.x, heart.y);
  await replies.release();
  await expect(editor.notice).toContainText('“bar 1” lies outside the shape');
  await expect(page.locator('c2-warp .draft')).toHaveCount(0);
  await expect(editor.handles).toHaveCount(6);
  await editor.button('Continue drawing').click();
  await expect(page.locator('c2-warp .draft .corner')).toHaveCount(2);
  // One more corner, on the leg.
  await clicks(editor, [at(380, 950)]);
  await page.keyboard.press('Enter');
  await expect(editor.handle('bar 1')).toBeVisible();
  await expect(page.getByText('Part of bar 1 lies outside the picture')).toBeVisible();
  const bar = await editor.projectHandle('bar-1');
  expect(bar?.kind === 'bar' && bar.posed).toHaveLength(3);
  await expect(editor.handle('handle 1')).toBeVisible();
});

test('a switch holds the boundary, as one step', async ({ page }) => {
  const editor = await Editor.open(page);
  const rim = [980, 516] as const;
  await editor.switch('Lock the outline').click();
  await expect(editor.switch('Lock the outline')).toBeChecked();
  await expect(editor.button('Undo: lock the outline')).toBeEnabled();
  const held = () =>
    page.locator('c2-warp').evaluate((element) => (element as HTMLElementTagNameMap['c2-warp']).project);
  await expect.poll(async () => (await held()).fix_boundary).toBe(true);
  await editor.dragHandle('right hand', { x: 0, y: -12 });
  const told = await editor.settled(() => editor.shownPose('right hand'));
  const lift = 516 - told.y;
  expect(lift).toBeGreaterThan(10);
  // The hand moves, and its edge hardly moves.
  await expect.poll(() => editor.mappedDistance([900, 516], [told.x, told.y])).toBeLessThan(1);
  await expect.poll(() => editor.mappedDistance(rim, rim)).toBeLessThan(lift / 2);

  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await held()).fix_boundary).toBe(false);
  await editor.dragHandle('right hand', { x: 0, y: -12 });
  await expect.poll(() => editor.mappedDistance(rim, rim)).toBeGreaterThan(lift / 2);
});

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });

  /** Browsers send the click of a tap some time after the touch ends. */
  const tapTool = async (editor: Editor, name: string) => {
    await editor.button(name).tap();
    await expect(editor.button(name)).toHaveAttribute('aria-pressed', 'true');
  };

  test('a bar is drawn by taps, finished by its button and bent by its end', async ({ page }) => {
    const editor = await Editor.open(page);
    const at = await editor.fromImage('head', [512, 260]);
    await tapTool(editor, 'Draw a bar');
    for (const place of [at(...HIP), at(...ANKLE)]) await page.touchscreen.tap(place.x, place.y);
    await expect(page.locator('c2-warp .draft .corner')).toHaveCount(2);
    await editor.button('Remove the last corner').tap();
    await expect(page.locator('c2-warp .draft .corner')).toHaveCount(1);
    const ankle = at(...ANKLE);
    await page.touchscreen.tap(ankle.x, ankle.y);
    await expect(page.locator('c2-warp .draft .corner')).toHaveCount(2);
    await editor.button('Finish').tap();
    await expect(editor.handle('bar 1')).toBeVisible();
    const end = await editor.centre(editor.corner(1, 'bar 1'));
    expect((await editor.corner(1, 'bar 1').boundingBox())?.width).toBeGreaterThanOrEqual(44);
    const session = await page.context().newCDPSession(page);
    await touch(session, [[end], [{ x: end.x + 10, y: end.y - 10 }], [{ x: end.x + 20, y: end.y - 16 }]]);
    await expect(editor.button('Undo: move a corner of bar 1')).toBeEnabled();
  });

  test('a double tap adds a corner to a bar', async ({ page }) => {
    const editor = await Editor.open(page);
    const at = await editor.fromImage('head', [512, 260]);
    await tapTool(editor, 'Draw a bar');
    // In an arm, which the sheet does not cover.
    for (const place of [at(260, 560), at(480, 560)]) await page.touchscreen.tap(place.x, place.y);
    await expect(page.locator('c2-warp .draft .corner')).toHaveCount(2);
    await editor.button('Finish').tap();
    await expect(editor.handle('bar 1')).toBeVisible();
    await tapTool(editor, 'Select and move');
    const knee = await editor.position('bar 1');
    const session = await page.context().newCDPSession(page);
    // Sent without waiting: on a busy machine two taps would be too far apart.
    await Promise.all([
      send(session, 'Start', [knee]),
      send(session, 'End'),
      send(session, 'Start', [knee]),
      send(session, 'End'),
    ]);
    await expect(editor.corner(3, 'bar 1')).toBeVisible();
  });

  test('the bending mode can be changed without a selection', async ({ page }) => {
    const editor = await Editor.open(page);
    await expect(editor.button(/^Elastic$/)).toBeHidden();
    await editor.button('Bending settings').tap();
    await editor.button(/^Elastic$/).tap();
    await expect(editor.button(/^Elastic$/)).toHaveAttribute('aria-pressed', 'true');
    for (const control of await page.locator('c2-warp .panel').locator('button:visible, .switch').all()) {
      expect((await control.boundingBox())?.height).toBeGreaterThanOrEqual(44);
    }
    await editor.button('Bending settings').tap();
    await expect(editor.button(/^Elastic$/)).toBeHidden();
  });
});
