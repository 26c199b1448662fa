/** Selections at their limits: of a pixel, of everything, in a picture of one colour, and fills that are cancelled. */
import { encode } from 'fast-png';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { png } from './files';
import { expect, test } from './fixtures';

type Place = readonly [number, number];

/** An opaque picture. */
function picture(width: number, height: number, level: (x: number, y: number) => number): Buffer {
  const data = new Uint8Array(width * height * 3);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const value = level(pixel % width, Math.floor(pixel / width));
    data.fill(value, 3 * pixel, 3 * pixel + 3);
  }
  return Buffer.from(encode({ width, height, data, channels: 3 }));
}

const checkered = (x: number, y: number) => (((x >> 4) + (y >> 4)) % 2 === 0 ? 90 : 160);

async function opened(page: Editor['page'], file: Buffer): Promise<Editor> {
  const editor = await Editor.open(page);
  await editor.chooseFile(png('photograph.png', file));
  await expect.poll(() => project(editor).then(({ image }) => image.src)).toBe('photograph.png');
  await expect(editor.solved).toContainText('mesh point');
  return editor;
}

const project = ({ page }: Editor) =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

/** Draws a lasso by one drag. */
async function drawLasso(editor: Editor, places: readonly Place[]): Promise<void> {
  await editor.page.keyboard.press('l');
  await expect(editor.switch('Snap to edges')).toHaveAttribute('aria-busy', 'false');
  await editor.dragAlong([...places, ...places.slice(0, 1)]);
}

/** A rectangle as a drag goes around it. */
const rectangle = ([left, top]: Place, [right, bottom]: Place): readonly Place[] => {
  const corners: readonly Place[] = [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ];
  return corners.flatMap(([x, y], k) => {
    const [toX, toY] = corners[(k + 1) % 4] ?? [x, y];
    return Array.from(
      { length: 8 },
      (_, step): Place => [x + ((toX - x) * step) / 8, y + ((toY - y) * step) / 8],
    );
  });
};

const rings = async (editor: Editor) => {
  const { domain } = await project(editor);
  return domain?.kind === 'polygon' ? domain.rings : [];
};

/** The colours of the export, each once. */
const colours = ({ page }: Editor): Promise<readonly string[]> =>
  page.locator('c2-warp').evaluate(async (element) => {
    const bitmap = await createImageBitmap(await (element as C2Warp).toBlob());
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen?.drawImage(bitmap, 0, 0);
    const { data = new Uint8ClampedArray() } = pen?.getImageData(0, 0, bitmap.width, bitmap.height) ?? {};
    return [...new Set(new Uint32Array(data.buffer))].map((colour) => colour.toString(16));
  });

test('a drag of a pixel sets one corner, and a selection of a pixel warps', async ({ page }) => {
  const file = picture(400, 300, checkered);
  const editor = await opened(page, file);
  await drawLasso(editor, [
    [150, 100],
    [151, 100],
    [151, 101],
  ]);
  await expect(page.getByRole('group', { name: 'Drawing' })).toContainText('2 more corners');
  await page.keyboard.press('Escape');
  expect(await rings(editor)).toEqual([]);

  const before = await colours(editor);
  await page.locator('c2-warp').evaluate((element) => {
    const project = (element as C2Warp).project;
    const ring = [
      [150, 100],
      [151, 100],
      [151, 101],
      [150, 101],
    ] as const;
    (element as C2Warp).project = {
      ...project,
      domain: { kind: 'polygon', rings: [ring] },
      fill: { method: 'patches', seed: 0 },
    };
  });
  await expect.poll(() => rings(editor)).toHaveLength(1);
  expect(await colours(editor)).toEqual(before);
});

test('a lasso around everything lies on the frame, and leaves nothing to fill from', async ({ page }) => {
  const editor = await opened(page, picture(400, 300, checkered));
  await drawLasso(editor, rectangle([-6, -6], [406, 306]));
  await expect(page.getByText('The selection leaves nothing to fill the background from')).toBeVisible();
  const { fill } = await project(editor);
  expect(fill).toBeUndefined();
  const [ring = []] = await rings(editor);
  expect(ring.every(([x, y]) => x === 0 || x === 400 || y === 0 || y === 300)).toBe(true);
  await editor.button(/^Undo: select the part to bend/).click();
  await expect.poll(() => rings(editor)).toEqual([]);
});

test('in a picture of one colour the lasso is as drawn, and its fill has that colour', async ({ page }) => {
  const editor = await opened(
    page,
    picture(400, 300, () => 128),
  );
  await drawLasso(editor, rectangle([150, 100], [250, 200]));
  await expect.poll(() => rings(editor)).toHaveLength(1);
  const [ring = []] = await rings(editor);
  expect(ring.every(([x, y]) => Math.min(x - 150, 250 - x, y - 100, 200 - y) > -3)).toBe(true);
  await page.locator('c2-warp').evaluate((element) => {
    const handles = [{ id: 'a', kind: 'point', rest: [200, 150], posed: [290, 150] }] as const;
    (element as C2Warp).project = { ...(element as C2Warp).project, handles };
  });
  await expect.poll(() => editor.mapped(200, 150)).toEqual([290, 150]);
  expect(await colours(editor)).toEqual(['ff808080']);
});

test('a fill larger than its surroundings is made, and can be cancelled at every stage', async ({ page }) => {
  const editor = await opened(page, picture(1600, 1200, checkered));
  await drawLasso(editor, rectangle([40, 40], [1560, 1160]));
  await expect.poll(() => rings(editor)).toHaveLength(1);
  const outline = await rings(editor);
  const bar = page.getByRole('progressbar', { name: 'Filling the background' });
  const done = async () => Number((await bar.getAttribute('aria-valuenow')) ?? 0);
  for (const part of [0, 10, 50]) {
    await expect(bar).toBeVisible();
    await expect.poll(done).toBeGreaterThanOrEqual(part);
    await page.getByRole('group', { name: 'Status' }).getByRole('button', { name: 'Cancel' }).click();
    await expect(bar).toBeHidden();
    await expect(editor.switch('Fill the background')).not.toBeChecked();
    expect(await rings(editor)).toEqual(outline);
    await editor.switch('Fill the background').click();
  }
  await expect(bar).toBeVisible();
  await expect(bar).toBeHidden({ timeout: 120_000 });
  await expect(editor.switch('Fill the background')).toBeChecked();
  expect(await rings(editor)).toEqual(outline);
});
