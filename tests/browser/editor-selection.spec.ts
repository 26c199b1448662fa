/** Selections in photographs: outlines along edges, their corners, and how they show while posing. */
import { decode, encode } from 'fast-png';
import type { C2Warp } from '../../web/src/element';
import { bytes, Editor, meanDifference, type Position } from './editor';
import { png } from './files';
import { expect, test } from './fixtures';

const [WIDTH, HEIGHT] = [400, 300];
const [CENTRE, RADIUS] = [[200, 150] as const, 90];

/** How light a disc on a dark ground is. */
const disc = (x: number, y: number): number => (Math.hypot(x - CENTRE[0], y - CENTRE[1]) < RADIUS ? 175 : 80);

/** An opaque picture with noise, the same in every run. @param level how light a place is. */
function photograph(level = disc): Buffer {
  let seed = 7;
  const noise = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return (seed / 0x7fffffff - 0.5) * 50;
  };
  const data = new Uint8Array(WIDTH * HEIGHT * 3);
  for (let pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
    const [x, y] = [(pixel % WIDTH) + 0.5, Math.floor(pixel / WIDTH) + 0.5];
    const light = level(x, y) + noise();
    data.set([light, light, light], pixel * 3);
  }
  return Buffer.from(encode({ width: WIDTH, height: HEIGHT, data, channels: 3 }));
}

type At = (x: number, y: number) => Promise<Position>;

async function opened(editor: Editor, picture = photograph()): Promise<At> {
  await editor.chooseFile(png('disc.png', picture));
  await expect.poll(() => project(editor).then(({ image }) => image.src)).toBe('disc.png');
  await expect(editor.solved).toContainText('mesh point');
  return (x, y) =>
    editor.page.locator('c2-warp').evaluate(
      (element, place) => {
        const [left = 0, top = 0] = (element as C2Warp).imageToClient(place) ?? [];
        return { x: left, y: top };
      },
      [x, y] as const,
    );
}

const project = ({ page }: Editor) =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

type Ring = readonly (readonly [number, number])[];

async function rings(editor: Editor): Promise<readonly Ring[]> {
  const { domain } = await project(editor);
  return domain?.kind === 'polygon' ? domain.rings : [];
}

const ring = async (editor: Editor): Promise<Ring> => (await rings(editor))[0] ?? [];

const areaOf = (corners: Ring): number =>
  Math.abs(
    corners.reduce((sum, [x, y], k) => {
      const [nextX, nextY] = corners[(k + 1) % corners.length] ?? [x, y];
      return sum + x * nextY - nextX * y;
    }, 0),
  ) / 2;

async function click({ page }: Editor, { x, y }: Position): Promise<void> {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.up();
}

/** Takes the lasso, and waits until it finds edges. */
async function takeLasso(editor: Editor): Promise<void> {
  await editor.page.keyboard.press('l');
  await expect(editor.switch('Snap to edges')).toHaveAttribute('aria-busy', 'false');
}

/** Clicks around the disc, a little beside its edge, and closes at the first corner. */
async function clickAround(editor: Editor, at: At, corners = 6): Promise<void> {
  for (let k = 0; k <= corners; k++) {
    const turn = (2 * Math.PI * k) / corners;
    const radius = RADIUS + (k % 2 === 0 ? 3 : -3);
    await click(editor, await at(CENTRE[0] + radius * Math.cos(turn), CENTRE[1] + radius * Math.sin(turn)));
  }
}

const away = (corners: Ring): number =>
  Math.max(...corners.map(([x, y]) => Math.abs(Math.hypot(x - CENTRE[0], y - CENTRE[1]) - RADIUS)));

/** A square selection by clicks, without snapping: from (100, 80) to (300, 220). */
async function selectRectangle(editor: Editor, at: At): Promise<void> {
  await takeLasso(editor);
  await editor.switch('Snap to edges').click();
  for (const [x, y] of [
    [100, 80],
    [300, 80],
    [300, 220],
    [100, 220],
    [100, 80],
  ] as const)
    await click(editor, await at(x, y));
  await expect.poll(() => ring(editor)).toHaveLength(4);
}

test('an opaque picture opens with its boundary held; the switch frees it', async ({ page }) => {
  const editor = await Editor.open(page);
  expect((await project(editor)).fix_boundary).toBe(false);
  await opened(editor);
  await expect(editor.switch('Lock the outline')).toBeChecked();
  await editor.switch('Lock the outline').click();
  expect((await project(editor)).fix_boundary).toBe(false);
  // By its address only, as on other pages.
  await page.locator('c2-warp').evaluate(
    (element, address) => {
      element.removeAttribute('project');
      element.setAttribute('src', address);
    },
    `data:image/png;base64,${photograph().toString('base64')}`,
  );
  await expect.poll(() => project(editor).then(({ fix_boundary }) => fix_boundary)).toBe(true);
});

test('clicks around a disc select it along its edge, within two pixels', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await takeLasso(editor);
  await clickAround(editor, at);
  await expect.poll(() => ring(editor)).not.toHaveLength(0);
  const corners = await ring(editor);
  expect(corners.length).toBeGreaterThan(12);
  expect(corners.length).toBeLessThan(60);
  expect(away(corners)).toBeLessThan(2);
});

test('clicks up a side of a thin rocket keep to that side and all corners', async ({ page }) => {
  const editor = await Editor.open(page);
  // From a tip at (200, 20) down to a foot at y = 280, 12 px wide. The ground to its right is nearly as light.
  const rocket = (x: number, y: number): number => {
    const half = Math.min(6, (y - 20) / 8);
    return y < 280 && Math.abs(x - 200) < half ? 200 : x < 200 ? 60 : 130;
  };
  const at = await opened(editor, photograph(rocket));
  await takeLasso(editor);
  const clicked = [
    [200, 21],
    [194, 280],
    [206, 280],
  ] as const;
  for (const [x, y] of [...clicked, clicked[0]]) await click(editor, await at(x, y));
  await expect.poll(() => ring(editor)).not.toHaveLength(0);
  const corners = await ring(editor);
  expect(await rings(editor)).toHaveLength(1);
  for (const [x, y] of clicked)
    expect(Math.min(...corners.map((corner) => Math.hypot(corner[0] - x, corner[1] - y)))).toBeLessThan(9);
  expect(areaOf(corners)).toBeGreaterThan(2200);
  expect(areaOf(corners)).toBeLessThan(4000);
});

test('a drag in the form of an eight selects both lobes, and both bend', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await takeLasso(editor);
  const places: Position[] = [];
  for (let k = 0; k <= 48; k++) {
    const turn = (2 * Math.PI * (k + 0.5)) / 48;
    places.push(await at(200 + 150 * Math.cos(turn), 150 + 90 * Math.sin(2 * turn)));
  }
  const [first = { x: 0, y: 0 }] = places;
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  for (const { x, y } of places.slice(1)) await page.mouse.move(x, y);
  await page.mouse.up();
  await expect.poll(() => rings(editor)).toHaveLength(2);
  for (const lobe of await rings(editor)) expect(areaOf(lobe)).toBeGreaterThan(8000);
  for (const x of [110, 290]) await expect.poll(() => editor.mapped(x, 150)).not.toBeNull();
  await expect(editor.notice).toBeHidden();
});

test('drags and clicks make one outline, and Backspace takes the last back', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await takeLasso(editor);
  const bar = page.getByRole('group', { name: 'Drawing' });
  // Around a half of the disc along its edge, which Backspace takes back as one.
  await click(editor, await at(CENTRE[0] - RADIUS, CENTRE[1]));
  await click(editor, await at(CENTRE[0], CENTRE[1] - RADIUS));
  await expect(bar).toContainText('Add corners, or finish');
  await page.keyboard.press('Backspace');
  await expect(bar).toContainText('2 more corners');
  // With Alt held, a click sets a straight edge and a drag draws freely.
  await page.keyboard.down('Alt');
  await click(editor, await at(290, 150));
  await expect(bar).toContainText('One more corner');
  const path = [];
  for (let k = 0; k <= 10; k++) path.push(await at(300 + 5 * k, 160 + 10 * k));
  await page.mouse.move(path[0]?.x ?? 0, path[0]?.y ?? 0);
  await page.mouse.down();
  for (const { x, y } of path) await page.mouse.move(x, y);
  await page.mouse.up();
  await click(editor, await at(120, 260));
  await page.keyboard.up('Alt');
  await page.keyboard.press('Enter');
  // The straight drag has two corners. Enter closes by the straight line that was shown.
  await expect.poll(() => ring(editor)).not.toHaveLength(0);
  const corners = (await ring(editor)).map((corner) => corner.map(Math.round));
  for (const corner of [
    [290, 150],
    [300, 160],
    [350, 260],
    [120, 260],
  ])
    expect(corners).toContainEqual(corner);
  expect(corners).toHaveLength(5);
});

test('the selection shows while posing, and not in exports', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await selectRectangle(editor, at);
  await expect(page.locator('c2-warp .selection').first()).toBeAttached();
  const outside = await at(50, 250);
  const dimmed = await editor.screenshot(outside, 20);
  await editor.button('Overlays').click();
  await page.getByRole('checkbox', { name: 'Selection' }).uncheck();
  await expect(page.locator('c2-warp .selection')).toHaveCount(0);
  expect(meanDifference(dimmed, await editor.screenshot(outside, 20))).toBeGreaterThan(10);
  await page.getByRole('checkbox', { name: 'Selection' }).check();
  const { data } = decode(await bytes(await editor.exported()));
  const original = decode(photograph()).data;
  const channels = data.length / (WIDTH * HEIGHT);
  const corner = 4;
  expect(data[corner * channels]).toBe(original[corner * 3]);
});

test('a bar that begins outside of the selection says so, and can extend it', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await selectRectangle(editor, at);
  await page.keyboard.press('b');
  await click(editor, await at(350, 150));
  await expect(page.getByText('The picture does not bend outside the selection.')).toBeVisible();
  await editor.button('Extend the selection').click();
  await expect.poll(async () => Math.max(...(await ring(editor)).map(([x]) => x))).toBeGreaterThan(350);
  await click(editor, await at(280, 150));
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await project(editor)).handles.length).toBe(1);
});

test('corners of the selection are dragged, added and removed', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await opened(editor);
  await selectRectangle(editor, at);
  await page.keyboard.press('l');
  const drag = async (from: Position, to: Position) =>
    editor.drag(from, { x: to.x - from.x, y: to.y - from.y });
  await drag(await at(100, 80), await at(60, 40));
  await expect
    .poll(async () => (await ring(editor)).map((corner) => corner.map(Math.round)))
    .toContainEqual([60, 40]);
  await drag(await at(200, 220), await at(200, 270));
  await expect.poll(() => ring(editor)).toHaveLength(5);
  await expect(editor.button('Undo: add a corner to the selection')).toBeEnabled();
  const added = await at(200, 270);
  await page.mouse.dblclick(added.x, added.y);
  await expect.poll(() => ring(editor)).toHaveLength(4);
  // With the keyboard only: the corners are tab stops behind the stage.
  await page.locator('c2-warp .stage').focus();
  await page.keyboard.press('Tab');
  const first = page.getByRole('button', { name: /^Corner 1 of the selection/ });
  await expect(first).toBeFocused();
  const [[x, y] = [0, 0]] = await ring(editor);
  await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await ring(editor))[0]).toEqual([x + 10, y]);
  await page.keyboard.press('c');
  await expect.poll(() => ring(editor)).toHaveLength(5);
  await expect(page.getByRole('button', { name: /^Corner 2 of the selection/ })).toBeFocused();
  await page.keyboard.press('Delete');
  await expect.poll(() => ring(editor)).toHaveLength(4);
  await expect(first).toBeFocused();
});
