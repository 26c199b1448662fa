/** `<c2-warp>` in somebody's page: attributes, methods, events, and what it gives back when it goes. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { apart, Editor } from './editor';
import { expect, test } from './fixtures';

test('it tells of input while dragging, of change once committed, of selection and history', async ({
  page,
}) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    const heard: string[] = [];
    Object.assign(globalThis, { heard });
    for (const type of ['input', 'change', 'selectionchange', 'historychange']) {
      element.addEventListener(type, () => heard.push(type));
    }
  });
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const heard = async () => {
    const all = await page.evaluate(() => Reflect.get(globalThis, 'heard') as string[]);
    return all.filter((type, k) => type !== all[k - 1]);
  };
  await expect.poll(heard).toEqual(['selectionchange', 'input', 'historychange', 'input', 'change']);
});

test('methods do what tools do', async ({ page }) => {
  const editor = await Editor.open(page);
  const answers = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const id = warp.addHandle({ kind: 'point', rest: [512, 700], posed: [512, 700] });
    warp.updateHandle('head', { rotation: 20 });
    const handles = warp.project.handles.map((handle) => handle.id);
    warp.undo();
    warp.removeHandle(id);
    warp.selection = ['head'];
    const png = await warp.toBlob(0.25);
    const { width, height } = await createImageBitmap(png);
    return {
      id,
      handles,
      selection: warp.selection,
      size: [width, height],
      left: warp.project.handles.length,
    };
  });
  expect(answers).toEqual({
    id: 'handle-6',
    handles: ['head', 'left-hand', 'right-hand', 'left-foot', 'right-foot', 'handle-6'],
    selection: ['head'],
    size: [256, 320],
    left: 5,
  });
  await expect.poll(async () => (await editor.told('head')).rotation).toBe(0);
});

test('what no handle can be is refused at once, and leaves no step', async ({ page }) => {
  await Editor.open(page);
  const refusals = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const tries = [
      () => warp.updateHandle('nobody', { scale: 2 }),
      () => warp.removeHandle('nobody'),
      () => warp.updateHandle('head', { scale: -1 }),
      () => warp.updateHandle('head', { posed: [Number.NaN, 1] }),
      () => warp.addHandle({ id: 'head', kind: 'point', rest: [512, 700] }),
      () => warp.addHandle({ id: 'bar', kind: 'bar', rest: [[512, 700]] }),
    ];
    return tries.map((attempt) => {
      try {
        attempt();
        return 'taken';
      } catch (error) {
        return error instanceof RangeError ? error.message : String(error);
      }
    });
  });
  expect(refusals).toEqual([
    'there is no handle "nobody"',
    'there is no handle "nobody"',
    'handle "head", scale: expected a number above 0',
    'handle "head", posed: expected a point [x, y]',
    'there is a handle "head" already',
    'handle "bar", rest: expected 2 points or more [x, y]',
  ]);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('a point is told where it goes', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('right hand').click();
  await editor.field('y').fill('400');
  await editor.field('y').press('Enter');
  const mapped = (x: number, y: number) =>
    page
      .locator('c2-warp')
      .evaluate((element, point) => (element as C2Warp).mapPoint(point), [x, y] as const);
  await expect.poll(async () => (await mapped(900, 516))?.[0]).toBeCloseTo(900, 0);
  await expect.poll(async () => (await mapped(900, 516))?.[1]).toBeCloseTo(400, 0);
  expect(await mapped(5, 5)).toBeNull();
});

test('what is refused reaches the page as an error with a code', async ({ page }) => {
  const editor = await Editor.open(page);
  const code = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    return warp.load(new Blob([])).then(
      () => 'none',
      (error) => error.code,
    );
  });
  expect(code).toBe('picture');
  await expect(editor.handles).toHaveCount(5);
});

test('removed, it gives back its context; put back, it has its document', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const told = await editor.still(() => editor.told('right hand'));
  const lost = await page.locator('c2-warp').evaluate(async (element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    const context = canvas?.getContext('webgl2');
    element.remove();
    await new Promise((done) => setTimeout(done, 50));
    document.body.append(element);
    return context?.isContextLost();
  });
  expect(lost).toBe(true);
  await expect(editor.handles).toHaveCount(5);
  await expect.poll(() => editor.told('right hand')).toEqual(told);
  await editor.button('Undo: move right hand').click();
  await expect.poll(() => editor.told('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('readonly shows, pans and zooms, and changes nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  const hand = await editor.place('right hand');
  await editor.dragHandle('right hand', { x: 20, y: -40 });
  expect(await editor.still(() => editor.told('right hand'))).toMatchObject({ x: 900, y: 516 });
  await expect.poll(async () => (await editor.place('right hand')).y).toBeCloseTo(hand.y - 40, 0);
  await page.keyboard.press('Delete');
  await expect(editor.handles).toHaveCount(5);
});

test('a handle that cannot be solved is named and taken back, and the history with it', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ kind: 'point', rest: [20, 20], posed: [30, 30] });
  });
  await expect(editor.notice).toContainText('handle-6');
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Redo')).toBeDisabled();
  await editor.button('Undo: move right hand').click();
  await expect.poll(() => editor.told('right hand')).toMatchObject({ x: 900, y: 516 });
});

/** Asks for so many samples that the solve is noticed. */
const ponder = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.project = { ...warp.project, samples: 1_000_000 };
  });

test('dragging does not wait for a solve', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.place('right hand');
  const goal = { x: hand.x, y: hand.y - 70 };
  const before = await editor.look(goal);
  await ponder(page);
  await editor.dragHandle('right hand', { x: 0, y: -70 });
  await expect.poll(async () => apart(before, await editor.look(goal))).toBeGreaterThan(10);
  await expect(page.getByRole('progressbar')).toBeVisible();
});

test('a long solve shows progress, and can be cancelled', async ({ page }) => {
  const editor = await Editor.open(page);
  await ponder(page);
  await expect(page.getByRole('progressbar')).toBeVisible();
  await editor.button('Cancel').click();
  await expect(page.getByRole('progressbar')).toBeHidden();
  const samples = () => page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.samples);
  await expect.poll(samples).toBe(10_000);
});

test('the colours chosen stay chosen', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Dark colours').click();
  await page.reload();
  await expect(editor.button('Light colours')).toBeVisible();
});
