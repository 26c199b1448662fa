/** The lasso: its inside bends, and the rest of the picture stays. */
import { encode } from 'fast-png';
import { Editor, meanDifference, type Position } from './editor';
import { png } from './files';
import { expect, test } from './fixtures';

/** A ring around head and arms of the sample, image pixels. Only the head's handle lies inside. */
const [CENTRE, RADIUS] = [[512, 400] as const, 340];

function around(at: (x: number, y: number) => Position, corners = 24): readonly Position[] {
  return Array.from({ length: corners }, (_, k) => {
    const turn = (2 * Math.PI * k) / corners;
    return at(CENTRE[0] + RADIUS * Math.cos(turn), CENTRE[1] + RADIUS * Math.sin(turn));
  });
}

/** Draws with one press and drag. */
async function draw({ page }: Editor, path: readonly Position[]): Promise<void> {
  const [first] = path;
  if (!first) return;
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  for (const { x, y } of path.slice(1)) await page.mouse.move(x, y);
  await page.mouse.up();
}

const ids = ({ page }: Editor): Promise<readonly string[]> =>
  page.evaluate(() => document.querySelector('c2-warp')?.project.handles.map(({ id }) => id) ?? []);

const domain = ({ page }: Editor): Promise<{ kind: string; rings?: readonly (readonly unknown[])[] }> =>
  page.evaluate(() => document.querySelector('c2-warp')?.project.domain ?? { kind: 'none' });

test('only the inside of a lasso bends; undo restores the handles outside', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  // The picture is posed, which shows that the lasso is drawn on the original.
  await editor.dragHandle('head', { x: 30, y: 20 });
  const bent = await editor.screenshot(at(512, 260));
  await page.keyboard.press('l');
  await expect(editor.button('Draw around the part to bend')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handle('head')).toBeHidden();
  await expect
    .poll(async () => meanDifference(bent, await editor.screenshot(at(512, 260))))
    .toBeGreaterThan(3);

  await draw(editor, around(at));
  await expect(page.getByText('4 handles outside the lasso were removed.')).toBeVisible();
  expect(await ids(editor)).toEqual(['head']);
  const { kind, rings } = await domain(editor);
  expect(kind).toBe('polygon');
  expect(rings).toHaveLength(1);
  await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
  // Once solved, the outside does not move.
  await expect.poll(() => editor.mapped(312, 1126)).toBeNull();

  // The next step dismisses the lasso notice, which would cover the foot.
  await page.getByRole('button', { name: 'Dismiss' }).click();
  const foot = await editor.screenshot(at(312, 1126));
  const neck = await editor.screenshot(at(512, 500));
  await editor.dragHandle('head', { x: 40, y: 30 });
  await expect
    .poll(async () => meanDifference(neck, await editor.screenshot(at(512, 500))))
    .toBeGreaterThan(3);
  expect(meanDifference(foot, await editor.screenshot(at(312, 1126)))).toBe(0);

  // The lasso tool shows the current lasso.
  await page.keyboard.press('l');
  await expect(page.locator('c2-warp .domain .dashes')).toBeAttached();
  await page.keyboard.press('v');
  await expect(page.locator('c2-warp .domain')).not.toBeAttached();

  await editor.button('Undo: move head').click();
  await editor.button('Undo: select the part to bend').click();
  expect(await ids(editor)).toHaveLength(5);
  expect((await domain(editor)).kind).toBe('alpha');
  await expect.poll(() => editor.mapped(312, 1126)).not.toBeNull();
});

test('the panel restores the whole picture as domain', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('l');
  await draw(editor, around(at));
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await editor.button('Remove the selection').click();
  expect(await domain(editor)).toEqual({ kind: 'alpha', threshold: 0.5 });
  await expect(editor.button('Remove the selection')).toBeHidden();
  await expect.poll(() => editor.mapped(312, 1126)).not.toBeNull();
});

test('an empty lasso and a handle outside the lasso are rejected', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('l');
  await draw(editor, [at(-300, 500), at(-200, 500), at(-200, 600), at(-300, 600), at(-300, 505)]);
  await expect(page.getByText('The lasso is empty')).toBeVisible();
  expect((await domain(editor)).kind).toBe('alpha');
  await expect(editor.button('Draw around the part to bend')).toHaveAttribute('aria-pressed', 'true');

  await draw(editor, around(at));
  await expect.poll(() => ids(editor)).toEqual(['head']);
  await expect.poll(() => editor.mapped(312, 1126)).toBeNull();
  await page.keyboard.press('p');
  const foot = at(312, 1126);
  await page.mouse.click(foot.x, foot.y);
  await expect(page.getByText('The picture does not bend outside the selection.')).toBeVisible();
  expect(await ids(editor)).toEqual(['head']);
  await editor.waitForSolve(() => editor.button('Extend the selection').click());
  await expect(editor.button('Undo: extend the selection')).toBeEnabled();
  await page.mouse.click(foot.x, foot.y);
  await expect.poll(() => ids(editor)).toHaveLength(2);
});

test('a lasso is drawn by keys, and its draft survives a reload', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('l');
  await page.locator('c2-warp .stage').focus();
  const corner = async (key: string, times: number) => {
    for (let k = 0; k < times; k++) await page.keyboard.press(`Shift+${key}`);
    await page.keyboard.press('Enter');
  };
  await corner('ArrowUp', 3);
  await corner('ArrowRight', 3);
  const kept = async () =>
    (await editor.storedWork()).drawings?.map(({ kind, corners }) => [kind, corners.length]);
  await expect.poll(kept).toEqual([['lasso', 2]]);
  await page.reload();
  await expect(page.locator('c2-warp .draft')).toBeAttached();
  await expect(page.locator('c2-warp .solved')).toContainText('mesh point');
  await page.keyboard.press('l');
  await expect(page.getByRole('group', { name: 'Drawing' })).toContainText('One more corner');
  await page.locator('c2-warp .stage').focus();
  await corner('ArrowDown', 6);
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await domain(editor)).rings?.map((ring) => ring.length)).toEqual([3]);
});

test('a self-crossing line makes a lasso; the list selects the select tool', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('l');
  // One and a half times around.
  const [once, more] = [around(at), around((x, y) => at(x - 20, y + 10)).slice(0, 12)];
  await draw(editor, [...once, ...more]);
  // It ends on the other side of its beginning, so that more could follow.
  await page.keyboard.press('Enter');
  await expect.poll(() => ids(editor)).toEqual(['head']);
  await expect.poll(() => editor.mapped(312, 1126)).toBeNull();
  expect((await domain(editor)).rings).toHaveLength(1);

  await page.keyboard.press('l');
  await expect(editor.handle('head')).toBeHidden();
  await page.getByRole('listitem').filter({ hasText: 'Head' }).getByRole('button').click();
  await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
});

test('the lasso panel offers to hold the boundary', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('l');
  // All handles lie inside.
  await draw(editor, [at(10, 10), at(1014, 10), at(1014, 1270), at(10, 1270), at(10, 20)]);
  await expect(page.getByText('It leaves a gap where it moves away.')).toBeVisible();
  expect(await ids(editor)).toHaveLength(5);
  await editor.button('Lock its outline').click();
  await expect(editor.switch('Lock the outline')).toBeChecked();
  await expect(page.getByText('It leaves a gap where it moves away.')).toBeHidden();
});

test('a lasso begun with Alt cuts a hole; a separate one adds a part', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('head', [512, 260]);
  const square = (x: number, y: number, side: number) => [
    at(x, y),
    at(x + side, y),
    at(x + side, y + side),
    at(x, y + side),
    at(x, y + 5),
  ];
  await page.keyboard.press('l');
  await draw(editor, around(at));
  await page.keyboard.press('l');
  await page.keyboard.down('Alt');
  await draw(editor, square(480, 400, 60));
  await page.keyboard.up('Alt');
  await page.keyboard.press('l');
  await draw(editor, square(200, 950, 200));
  expect((await domain(editor)).rings).toHaveLength(3);
  await expect.poll(() => editor.mapped(510, 430)).toBeNull();
  await expect.poll(() => editor.mapped(300, 1050)).not.toBeNull();
});

test('a part of a photograph turns by a polygon in place of its lasso', async ({ page }) => {
  const editor = await Editor.open(page);
  const data = new Uint8Array(300 * 300 * 3).map((_, at) => (at * 7) % 256);
  const photograph = Buffer.from(encode({ width: 300, height: 300, data, channels: 3 }));
  await editor.chooseFile(png('photograph.png', photograph));
  await expect(editor.solved).toContainText('300 × 300 px');
  await page.locator('c2-warp').press('l');
  const stage = await page.locator('c2-warp .stage').boundingBox();
  if (!stage) throw new Error('The stage is not visible.');
  const { x, y, width, height } = stage;
  const circle = Array.from({ length: 24 }, (_, k): Position => {
    const turn = (2 * Math.PI * k) / 24;
    return { x: x + width * 0.4 + 70 * Math.cos(turn), y: y + height * 0.45 + 70 * Math.sin(turn) };
  });
  await draw(editor, [...circle, ...circle.slice(0, 1)]);
  await editor.button('Turn this part, bend the rest').click();
  await expect(editor.handle('polygon 1')).toBeVisible();
  expect(await domain(editor)).toEqual({ kind: 'image' });
  // Its ring turns it.
  await expect.poll(() => editor.mapped(150, 150)).not.toBeNull();
  const centre = await editor.position('polygon 1');
  await editor.drag({ x: centre.x, y: centre.y - 40 }, { x: 11, y: 2 });
  await expect.poll(async () => (await editor.shownPose('polygon 1')).rotation).toBeGreaterThan(8);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await domain(editor)).kind).toBe('polygon');
  expect(await ids(editor)).toEqual([]);
});
