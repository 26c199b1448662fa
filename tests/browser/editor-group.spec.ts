/** Turning and scaling several handles as a group, by their ring: with mouse, touch and keys. */
import type { CDPSession, Page } from '@playwright/test';
import type { Handle } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { touch } from './fingers';
import { expect, test } from './fixtures';

/** The head and two cheeks, one with a set turn and one with an automatic turn, and a bar. */
const GROUP = ['head', 'left-cheek', 'right-cheek', 'mouth'];
const centre: Position = { x: 510, y: 318 };

async function opened(page: Page, selection = GROUP): Promise<Editor> {
  const editor = await Editor.open(page);
  await editor.waitForSolve(() =>
    page.locator('c2-warp').evaluate(async (element, selection) => {
      const warp = element as C2Warp;
      const events: string[] = [];
      Object.assign(globalThis, { events });
      warp.addHandle({ id: 'left-cheek', kind: 'point', rest: [422, 330], rotation: 10 });
      warp.addHandle({ id: 'right-cheek', kind: 'point', rest: [600, 330], rotation: 'auto' });
      const line = [
        [456, 352],
        [556, 352],
      ] as const;
      warp.addHandle({ id: 'mouth', kind: 'bar', rest: line, posed: line });
      warp.selection = selection;
      await warp.updateComplete;
      for (const type of ['input', 'change']) warp.addEventListener(type, () => events.push(type));
    }, selection),
  );
  return editor;
}

const select = (page: Page) =>
  page.locator('c2-warp').evaluate((element, selection) => {
    (element as C2Warp).selection = selection;
    return (element as C2Warp).updateComplete;
  }, GROUP);

const events = (page: Page) => page.evaluate(() => (Reflect.get(globalThis, 'events') as string[]).splice(0));
const knob = (editor: Editor) => editor.centre(editor.page.locator('c2-warp .ring circle.knob'));
const grip = (editor: Editor) => editor.centre(editor.page.locator('c2-warp .ring rect.knob'));
const handles = (editor: Editor) =>
  editor.page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.handles);

/** Returns the centre of the selection on the page. */
const middle = async (editor: Editor): Promise<Position> => {
  const [x, y] = await editor.page
    .locator('c2-warp')
    .evaluate((element, { x, y }) => (element as C2Warp).imageToClient([x, y]) ?? [Number.NaN, 0], centre);
  return { x, y };
};

/** Turns a point about a pivot by degrees, and scales its distance. */
function around(pivot: Position, { x, y }: Position, degrees: number, growth = 1): Position {
  const [dx, dy, turn] = [x - pivot.x, y - pivot.y, (degrees * Math.PI) / 180];
  const [cos, sin] = [growth * Math.cos(turn), growth * Math.sin(turn)];
  return { x: pivot.x + cos * dx - sin * dy, y: pivot.y + sin * dx + cos * dy };
}

const corners = (handle: Handle) => (handle.kind === 'point' ? [handle.posed] : handle.posed);

/** Returns the largest distance of a handle from its place in the turned and scaled group, image pixels. */
function off(before: readonly Handle[], after: readonly Handle[], degrees: number, growth = 1): number {
  const ways = before
    .filter(({ id }) => GROUP.includes(id))
    .flatMap((handle) => {
      const posed = after.find(({ id }) => id === handle.id);
      return corners(handle).map(([x, y], k) => {
        const goal = around(centre, { x, y }, degrees, growth);
        const [px, py] = (posed && corners(posed)[k]) ?? [Number.POSITIVE_INFINITY, 0];
        return Math.hypot(px - goal.x, py - goal.y);
      });
    });
  return Math.max(...ways);
}

const field = (all: readonly Handle[], id: string) => all.find((handle) => handle.id === id);

/** The rounding to hundredths in x and y. */
const ROUNDED = 0.01;

async function lead(page: Page, from: Position, to: Position): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 6 });
}

test('the group ring turns the selection in one step; Escape reverts it', async ({ page }) => {
  const editor = await opened(page);
  await expect(page.locator('c2-warp .ring')).toHaveCount(1);
  const before = await handles(editor);
  const [pivot, top] = [await middle(editor), await knob(editor)];
  await page.keyboard.down('Shift');
  await lead(page, top, around(pivot, top, 43));
  await expect.poll(async () => off(before, await handles(editor), 45)).toBeLessThan(ROUNDED);
  // The knob follows the pointer, except for snapping.
  const held = around(pivot, top, 45);
  await expect.poll(async () => Math.abs((await knob(editor)).x - held.x)).toBeLessThan(1);
  expect((await events(page)).every((type) => type === 'input')).toBe(true);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.keyboard.up('Shift');
  expect(await handles(editor)).toEqual(before);

  await page.keyboard.down('Shift');
  await lead(page, top, around(pivot, top, 31, 2));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const after = await handles(editor);
  expect(off(before, after, 30)).toBeLessThan(ROUNDED);
  expect(field(after, 'left-cheek')?.rotation).toBe(40);
  expect(field(after, 'right-cheek')?.rotation).toBe('auto');
  expect(field(after, 'mouth')?.rotation).toBe(30);
  expect(after.filter(({ id }) => !GROUP.includes(id))).toEqual(
    before.filter(({ id }) => !GROUP.includes(id)),
  );
  expect((await events(page)).filter((type) => type === 'change')).toEqual(['change']);
  await expect(page.getByText('Turn 4 handles. 4 handles: x 510, y 318, rotation 30 degrees')).toBeAttached();
  await page.keyboard.press('Control+z');
  expect(await handles(editor)).toEqual(before);
});

test('the grip on the ring scales the selection, and the panel shows it', async ({ page }) => {
  const editor = await opened(page);
  const before = await handles(editor);
  const [pivot, from] = [await middle(editor), await grip(editor)];
  await page.mouse.move(from.x, from.y);
  await expect(page.locator('c2-warp .stage')).toHaveCSS('cursor', 'nwse-resize');
  await page.keyboard.down('Shift');
  // A little more than 1.5 times as far, snapped to tenths by the farthest handle.
  await lead(page, from, around(pivot, from, 0, 1.38));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const after = await handles(editor);
  const scale = field(after, 'head')?.scale ?? 0;
  expect(scale).toBeGreaterThan(1.3);
  expect(scale * 10).toBeCloseTo(Math.round(scale * 10));
  expect(GROUP.map((id) => field(after, id)?.scale)).toEqual(GROUP.map(() => scale));
  expect(off(before, after, 0, scale)).toBeLessThan(ROUNDED);
  expect(field(after, 'right-cheek')?.rotation).toBe('auto');
  await expect(editor.field('scale')).toHaveValue(String(scale));
  await expect(page.getByText(`rotation 0 degrees, scale ${scale}`)).toBeAttached();
  await editor.button('Undo: scale 4 handles').click();
  expect(await handles(editor)).toEqual(before);
});

test('an Alt-drag of a selected handle turns the group', async ({ page }) => {
  const editor = await opened(page);
  const before = await handles(editor);
  const [pivot, cheek] = [await middle(editor), await editor.position('right cheek')];
  await page.keyboard.down('Alt');
  await page.keyboard.down('Shift');
  await lead(page, cheek, around(pivot, cheek, 62, 3));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await page.keyboard.up('Alt');
  expect(off(before, await handles(editor), 60)).toBeLessThan(ROUNDED);
});

test('comma and full stop turn the group, and scale it with Alt', async ({ page }) => {
  const editor = await opened(page);
  const before = await handles(editor);
  await editor.handle('head').focus();
  await page.keyboard.press('Shift+Period');
  await page.keyboard.press('Period');
  await page.keyboard.press('Comma');
  expect(off(before, await handles(editor), 15)).toBeLessThan(3 * ROUNDED);
  await expect(page.getByText('4 handles: x 510, y 318, rotation 15 degrees')).toBeAttached();
  await page.keyboard.press('Alt+Shift+Period');
  expect(off(before, await handles(editor), 15, 1.1)).toBeLessThan(5 * ROUNDED);
  await page.keyboard.press('Alt+Comma');
  await expect(page.getByText('rotation 15 degrees, scale 1.09')).toBeAttached();
  // Consecutive turns are one step, and so are consecutive scalings.
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await handles(editor)).toEqual(before);
});

test('past half a turn the group keeps turning, in the harmonic mode too', async ({ page }) => {
  const editor = await opened(page, []);
  await editor.waitForSolve(() => editor.button('Elastic').click());
  // Automatic rotations do not follow whole turns of others, so every handle has its own here.
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    for (const { id, kind } of warp.project.handles)
      if (kind === 'point') warp.updateHandle(id, { rotation: id === 'left-cheek' ? 10 : 0 });
    return warp.updateComplete;
  });
  const places = [
    [512, 640],
    [250, 560],
    [512, 200],
  ] as const;
  const mapped = () =>
    Promise.all(
      places.map(async ([x, y]) => (await editor.mapped(x, y)) ?? ([Number.NaN, Number.NaN] as const)),
    );
  const before = await mapped();
  await page.locator('c2-warp .stage').focus();
  await page.keyboard.press('Control+a');
  for (let step = 0; step < 13; step++) await page.keyboard.press('Shift+.');
  const after = await mapped();
  const all = await handles(editor);
  expect(field(all, 'left-cheek')?.rotation).toBe(10 + 195);
  expect(field(all, 'mouth')?.rotation).toBeCloseTo(195, 1);
  /** Returns the vector between two points after a turn. */
  const way = ([from, to]: readonly (readonly [number, number])[], degrees: number) =>
    around(
      { x: 0, y: 0 },
      { x: (to?.[0] ?? 0) - (from?.[0] ?? 0), y: (to?.[1] ?? 0) - (from?.[1] ?? 0) },
      degrees,
    );
  for (const pair of [
    [0, 1],
    [0, 2],
  ]) {
    const [goal, found] = [
      way(
        pair.map((at) => before[at] ?? [0, 0]),
        195,
      ),
      way(
        pair.map((at) => after[at] ?? [0, 0]),
        0,
      ),
    ];
    // Each handle is rounded to hundredths in each of 13 steps.
    expect(Math.hypot(found.x - goal.x, found.y - goal.y)).toBeLessThan(0.5);
  }
});

test('the selection stays rigid where the guard stops a turn', async ({ page }) => {
  const editor = await opened(page, []);
  // In the Rigid mode, a turned head does not fold.
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await editor.switch('Stop at folds').click();
  await select(page);
  const before = await handles(editor);
  const [pivot, top] = [await middle(editor), await knob(editor)];
  await page.mouse.move(top.x, top.y);
  await page.mouse.down();
  for (const degrees of [60, 120, 160]) {
    const to = around(pivot, top, degrees);
    await page.mouse.move(to.x, to.y);
    await editor.waitFrames();
  }
  await expect(editor.button('Stopped at a fold')).toBeVisible();
  await page.mouse.up();
  const after = await handles(editor);
  const turn = Number(field(after, 'mouth')?.rotation);
  expect(turn).toBeGreaterThan(10);
  expect(turn).toBeLessThan(150);
  // The stopped pose is rounded too, once per move.
  expect(off(before, after, turn)).toBeLessThan(0.2);
  await expect(editor.button(/^\d+ folds?\./)).toBeHidden();
});

test('the group ring works in a posable picture', async ({ page }) => {
  const editor = await opened(page);
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).posable = true;
    return (element as C2Warp).updateComplete;
  });
  await editor.waitFrames();
  const before = await handles(editor);
  const [pivot, top] = [await middle(editor), await knob(editor)];
  await page.keyboard.down('Shift');
  await lead(page, top, around(pivot, top, -29));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  expect(off(before, await handles(editor), -30)).toBeLessThan(ROUNDED);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  const swipe = async (session: CDPSession, from: Position, to: Position) => {
    const half = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
    await touch(session, [[from], [half], [to]]);
  };

  test('a finger turns by the knob and scales by the grip, each 44 px wide', async ({ page }) => {
    const editor = await opened(page);
    // Sizes are for touch from here on.
    await editor.handle('left foot').tap();
    await select(page);
    await editor.waitFrames();
    const session = await page.context().newCDPSession(page);
    const before = await handles(editor);
    const pivot = await middle(editor);
    const top = await knob(editor);
    const beyond = { x: top.x, y: top.y - 21 };
    await swipe(session, beyond, around(pivot, beyond, 30));
    await expect.poll(async () => off(before, await handles(editor), 30)).toBeLessThan(1);
    const turned = await handles(editor);
    const turn = Number(field(turned, 'mouth')?.rotation);
    const corner = await grip(editor);
    const outside = around(pivot, corner, 0, 1 + 21 / Math.hypot(corner.x - pivot.x, corner.y - pivot.y));
    await swipe(session, outside, around(pivot, outside, 0, 1.3));
    await expect.poll(async () => field(await handles(editor), 'mouth')?.scale).toBeGreaterThan(1.3);
    const after = await handles(editor);
    expect(off(before, after, turn, field(after, 'mouth')?.scale)).toBeLessThan(0.1);
    expect(field(after, 'mouth')?.rotation).toBe(turn);
  });
});
