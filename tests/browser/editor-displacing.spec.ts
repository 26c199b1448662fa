/** The brush that moves the picture: its kinds, undo, the keyboard, Alt, folds, a held frame, touch, and the file. */
import { decode, encode } from 'fast-png';
import type { Project } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { bytes, Editor, type Position } from './editor';
import { png } from './files';
import { touch } from './fingers';
import { expect, test } from './fixtures';

type Place = readonly [number, number];

const project = ({ page }: Editor): Promise<Project> =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

const displacement = async (editor: Editor) => (await project(editor)).displacement ?? null;

/** The largest number of the displacement, in its own unit; 0 without one. */
async function largest(editor: Editor): Promise<number> {
  const { values = '' } = (await displacement(editor)) ?? {};
  const data = Buffer.from(values, 'base64');
  return Math.max(
    0,
    ...Array.from({ length: data.length / 2 }, (_, at) => Math.abs(data.readInt16LE(2 * at))),
  );
}

/** Image pixels between two places of the original, as they are posed. */
async function apart(editor: Editor, a: Place, b: Place): Promise<number> {
  const [from, to] = [await editor.mapped(...a), await editor.mapped(...b)];
  return Math.hypot((to?.[0] ?? 0) - (from?.[0] ?? 0), (to?.[1] ?? 0) - (from?.[1] ?? 0));
}

/** Where a place of the picture is drawn, if nothing moves it. */
const clientPlace = ({ page }: Editor, place: Place): Promise<Place> =>
  page
    .locator('c2-warp')
    .evaluate((element, place) => (element as C2Warp).imageToClient([...place]) ?? [0, 0], place);

/** The exported picture at a fifth of its size. */
async function pictureOf({ page }: Editor) {
  const file = await page
    .locator('c2-warp')
    .evaluate(async (element) => [
      ...new Uint8Array(await (await (element as C2Warp).toBlob({ scale: 0.2 })).arrayBuffer()),
    ]);
  return decode(Uint8Array.from(file));
}

/** The editor with its sample, and the brush in hand. */
async function brushing(
  page: Editor['page'],
): Promise<readonly [Editor, (x: number, y: number) => Position]> {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('f');
  await expect(editor.button('Push')).toHaveAttribute('aria-pressed', 'true');
  return [editor, at];
}

test('a push moves the picture at once, and undo takes strokes back one by one', async ({ page }) => {
  const [editor, at] = await brushing(page);
  const before = await editor.mapped(512, 640);
  await editor.drag(at(512, 640), { x: 30, y: 0 });
  await expect(editor.button('Undo: push')).toBeEnabled();
  const moved = await editor.settled(() => editor.mapped(512, 640));
  expect(moved?.[0]).toBeGreaterThan(530);
  await editor.button('Bloat').click();
  await editor.drag(at(512, 800), { x: 20, y: 0 });
  await expect(editor.button('Undo: bloat')).toBeEnabled();
  const stroked = await displacement(editor);
  const buffer = await bytes(await editor.download('Save the project file'));
  await editor.button('Undo: bloat').click();
  await editor.button('Undo: push').click();
  expect(await largest(editor)).toBe(0);
  await expect.poll(() => editor.mappedDistance([512, 640], before ?? [0, 0])).toBeLessThan(1e-6);
  await editor.chooseFile({ name: 'gingerbread.c2warp.json', mimeType: 'application/json', buffer });
  await expect.poll(() => displacement(editor)).toEqual(stroked);
});

test('strokes and their history are restored after a reload', async ({ page }) => {
  const [editor, at] = await brushing(page);
  for (const y of [560, 640, 720]) await editor.drag(at(512, y), { x: 20, y: 0 });
  const stroked = await displacement(editor);
  await expect.poll(() => editor.storedWork().then(({ step }) => step)).toBe('Push');
  await page.reload();
  await editor.ready();
  await expect.poll(() => displacement(editor)).toEqual(stroked);
  for (let k = 0; k < 3; k++) await editor.button('Undo: push').click();
  expect(await largest(editor)).toBe(0);
});

test('pinch and bloat change distances, and Alt swaps them', async ({ page }) => {
  const [editor, at] = await brushing(page);
  const [a, b]: readonly [Place, Place] = [
    [492, 640],
    [532, 640],
  ];
  const before = await apart(editor, a, b);
  const pressed = async (): Promise<number> => {
    const { x, y } = at(512, 640);
    const last = await displacement(editor);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.up();
    await expect.poll(() => displacement(editor)).not.toEqual(last);
    return editor.settled(() => apart(editor, a, b));
  };
  await editor.button('Pinch').click();
  expect(await pressed()).toBeLessThan(before);
  await editor.button('Undo: pinch').click();
  await editor.button('Bloat').click();
  expect(await pressed()).toBeGreaterThan(before);
  await editor.button('Undo: bloat').click();
  await page.keyboard.down('Alt');
  expect(await pressed()).toBeLessThan(before);
  await page.keyboard.up('Alt');
  await expect(editor.button('Undo: pinch')).toBeEnabled();
});

test('smoothing evens out a stroke, and restoring removes it', async ({ page }) => {
  const [editor, at] = await brushing(page);
  await editor.drag(at(512, 640), { x: 30, y: 0 });
  const pushed = await largest(editor);
  expect(pushed).toBeGreaterThan(0);
  await editor.button('Smooth').click();
  await editor.drag(at(500, 640), { x: 50, y: 0 });
  const smoothed = await largest(editor);
  expect(smoothed).toBeGreaterThan(0);
  expect(smoothed).toBeLessThan(pushed);
  await editor.button('Restore').click();
  // Smoothing has reached beyond its brush.
  for (let k = 0; k < 5; k++) await page.keyboard.press(']');
  for (let k = 0; k < 12 && (await displacement(editor)); k++) {
    await editor.drag(at(430, 640), { x: 160, y: 0 });
  }
  expect(await largest(editor)).toBe(0);
});

test('with the guard no stroke folds the picture; without it one does', async ({ page }) => {
  const [editor, at] = await brushing(page);
  const folds = () => editor.status.getByRole('button', { name: 'Show the folds' });
  const pushHard = async () => {
    for (let k = 0; k < 3; k++) await editor.drag(at(440, 700), { x: 90, y: 0 });
  };
  await pushHard();
  await expect(folds()).toBeVisible();
  for (let k = 0; k < 3; k++) await editor.button('Undo: push').click();
  await expect(folds()).toBeHidden();
  await editor.switch('Stop at folds').click();
  await pushHard();
  await editor.settled(() => editor.mapped(440, 700));
  expect(await displacement(editor)).not.toBeNull();
  await expect(folds()).toBeHidden();
});

test('the frame of a photograph stays where the brush pushes across it', async ({ page }) => {
  const editor = await Editor.open(page);
  const data = Uint8Array.from({ length: 400 * 300 * 3 }, (_, at) => 60 + ((at * 7) % 150));
  const file = Buffer.from(encode({ width: 400, height: 300, data, channels: 3 }));
  await editor.chooseFile(png('photograph.png', file));
  await expect.poll(() => project(editor).then(({ image }) => image.src)).toBe('photograph.png');
  await expect(editor.solved).toContainText('mesh point');
  await page.keyboard.press('f');
  const [from, to] = [await clientPlace(editor, [4, 150]), await clientPlace(editor, [200, 150])];
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= 10; k++)
    await page.mouse.move(from[0] + ((to[0] - from[0]) * k) / 10, from[1] + ((to[1] - from[1]) * k) / 10);
  await page.mouse.up();
  await expect(editor.button('Undo: push')).toBeEnabled();
  for (const [x, y] of [
    [0, 150],
    [0, 120],
    [200, 0],
    [400, 300],
  ] as const)
    expect(await editor.mappedDistance([x, y], [x, y])).toBeLessThan(1e-5);
  const { data: exported } = decode(await bytes(await editor.exported()));
  expect(exported.every((value, at) => at % 4 !== 3 || value === 255)).toBe(true);
});

test('keys hold and push the picture, and the bin clears', async ({ page }) => {
  const [editor, at] = await brushing(page);
  await page.keyboard.press('Enter');
  for (let k = 0; k < 8; k++) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await expect(editor.button('Undo: push')).toBeEnabled();
  expect(await displacement(editor)).not.toBeNull();
  const clear = page.getByRole('button', { name: 'Clear brush strokes', exact: true });
  await clear.click();
  expect(await largest(editor)).toBe(0);
  await expect(clear).toBeDisabled();
  // A push with Alt restores everything.
  await page.keyboard.down('Alt');
  await editor.drag(at(512, 640), { x: 10, y: 0 });
  await page.keyboard.up('Alt');
  expect(await largest(editor)).toBe(0);
});

test('a displaced picture follows its handles, its clips and exports', async ({ page }) => {
  const [editor, at] = await brushing(page);
  await editor.drag(at(512, 640), { x: 30, y: 0 });
  const pushed = await editor.settled(() => editor.mapped(512, 640));
  const exported = () =>
    page.locator('c2-warp').evaluate(async (element) => {
      const digest = await crypto.subtle.digest(
        'SHA-256',
        await (await (element as C2Warp).toBlob()).arrayBuffer(),
      );
      return [...new Uint8Array(digest)].join();
    });
  const displaced = await exported();
  await page.keyboard.press('v');
  await editor.dragHandle('head', { x: 40, y: 0 });
  const posed = await editor.settled(() => editor.mapped(512, 640));
  expect(posed).not.toEqual(pushed);
  await editor.button('Undo: move head').click();
  await expect.poll(() => editor.mapped(512, 640)).toEqual(pushed);
  expect(await exported()).toBe(displaced);
  await editor.button('Undo: push').click();
  await expect.poll(exported).not.toBe(displaced);
});

test('strokes stay while a clip plays, and where its playhead is set', async ({ page }) => {
  const place: Place = [512, 640];
  const [editor] = await brushing(page);
  await page.keyboard.press('t');
  const playhead = page.getByRole('slider', { name: 'Playhead' });
  const posedAt = async (steps: number) => {
    await playhead.focus();
    await page.keyboard.press('Home');
    for (let k = 0; k < steps; k++) await page.keyboard.press('Shift+ArrowRight');
    return editor.settled(() => editor.mapped(...place));
  };
  const before = [await posedAt(0), await posedAt(1)];
  await posedAt(0);
  await page.keyboard.press('f');
  const [x = 0, y = 0] = await clientPlace(editor, place);
  await editor.drag({ x, y }, { x: 30, y: 0 });
  await expect(editor.button('Undo: push')).toBeEnabled();
  const stroked = await displacement(editor);
  for (const [steps, plain] of before.entries()) {
    const [x = 0] = (await posedAt(steps)) ?? [];
    expect(x - (plain?.[0] ?? 0)).toBeGreaterThan(15);
  }
  await page.keyboard.press('k');
  for (let k = 0; k < 10; k++) {
    await editor.waitFrames();
    const [x = 0] = (await editor.mapped(...place)) ?? [];
    expect(x - place[0]).toBeGreaterThan(10);
  }
  await page.keyboard.press('k');
  expect(await displacement(editor)).toEqual(stroked);
});

test('a picture without handles is pushed, exported, saved and opened', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await expect(editor.handles).toHaveCount(0);
  await page.keyboard.press('f');
  const [from, to] = [await clientPlace(editor, [512, 640]), await clientPlace(editor, [552, 640])];
  const plain = await pictureOf(editor);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 6 });
  await page.mouse.up();
  await expect(editor.button('Undo: push')).toBeEnabled();
  expect(await editor.mappedDistance([512, 640], [552, 640])).toBeLessThan(4);
  expect(await editor.mappedDistance([512, 260], [512, 260])).toBeLessThan(1e-5);
  const stroked = await displacement(editor);
  expect(stroked).not.toBeNull();
  const shown = await pictureOf(editor);
  expect([shown.width, shown.height]).toEqual([plain.width, plain.height]);
  /** The mean difference of bytes in a row of the two pictures. */
  const apart = (y: number) => {
    const rows = [shown, plain].map(({ width, data }) => data.slice(4 * y * width, 4 * (y + 1) * width));
    const [a = [], b = []] = rows;
    return [...a].reduce((sum, value, at) => sum + Math.abs(value - (b[at] ?? 0)), 0) / a.length;
  };
  expect(apart(128)).toBeGreaterThan(1);
  // Far below the stroke nothing has moved. Only edges are redrawn.
  expect(apart(200)).toBeLessThan(0.1);
  const buffer = await bytes(await editor.download('Save the project file'));
  await editor.button('Undo: push').click();
  expect(await displacement(editor)).toBeNull();
  await expect.poll(() => editor.mappedDistance([512, 640], [512, 640])).toBeLessThan(1e-5);
  expect((await pictureOf(editor)).data).toEqual(plain.data);
  await editor.chooseFile({ name: 'gingerbread.c2warp.json', mimeType: 'application/json', buffer });
  await expect.poll(() => displacement(editor)).toEqual(stroked);
  await expect.poll(() => editor.mappedDistance([512, 640], [552, 640])).toBeLessThan(4);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });

  test('a finger pushes the picture', async ({ page }) => {
    const editor = await Editor.open(page);
    const at = await editor.fromImage('head', [512, 260]);
    await editor.button('Brush').tap();
    const from = at(512, 640);
    const session = await page.context().newCDPSession(page);
    await touch(
      session,
      Array.from({ length: 7 }, (_, k) => [{ x: from.x + 3 * k, y: from.y }]),
    );
    await expect.poll(() => displacement(editor)).not.toBeNull();
    await expect(editor.button('Undo: push')).toBeEnabled();
  });
});
