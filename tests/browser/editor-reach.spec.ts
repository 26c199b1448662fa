/** The heat map of the reach of selected handles: hot and cold areas, and its visibility. */
import { decode } from 'fast-png';
import { Editor, meanDifference, type Position, SAME } from './editor';
import { expect, test } from './fixtures';

/** A radius around a handle, inside its ring. */
const RADIUS = 9;

/** The most that the reach of one handle changes the mean colour around another. */
const COLD = 6;

type Colour = readonly [red: number, green: number, blue: number];

/** Returns the mean colour around a position. */
async function colour(editor: Editor, at: Position): Promise<Colour> {
  const { data, channels } = decode(await editor.screenshot(at, RADIUS));
  const mean = (channel: number) => {
    let sum = 0;
    for (let pixel = channel; pixel < data.length; pixel += channels) sum += data[pixel] ?? 0;
    return (sum * channels) / data.length;
  };
  return [mean(0), mean(1), mean(2)];
}

/** Whether a colour is like the upper end of the ramp, over a brown picture. */
const isHot = ([red, green, blue]: Colour) => red > 190 && green > 180 && blue < 110;

const reachBox = (editor: Editor) => editor.page.getByRole('checkbox', { name: 'Reach' });

async function switchReach(editor: Editor): Promise<void> {
  await editor.button('Overlays').click();
  await reachBox(editor).click();
  await editor.page.keyboard.press('Escape');
}

const legend = (editor: Editor) => editor.page.getByRole('img', { name: /yellow follows/ });

const NAMES = ['left hand', 'right hand', 'head', 'left foot', 'right foot'] as const;

for (const mode of ['Rigid', 'Elastic'] as const) {
  test(`${mode}: selected handles are hot, others cold; none without selection`, async ({ page }) => {
    const editor = await Editor.open(page);
    if (mode === 'Elastic') await editor.waitForSolve(() => editor.button('Elastic').click());
    const places = Object.fromEntries(
      await Promise.all(NAMES.map(async (name) => [name, await editor.position(name)] as const)),
    ) as Record<(typeof NAMES)[number], Position>;
    const before = new Map<string, Buffer>();
    for (const name of NAMES) before.set(name, await editor.screenshot(places[name], RADIUS));
    const changed = async (name: (typeof NAMES)[number]) =>
      meanDifference(await editor.screenshot(places[name], RADIUS), before.get(name) ?? Buffer.alloc(0));

    await switchReach(editor);
    await expect(page.getByText('Select a handle to see its reach')).toBeVisible();
    for (const name of NAMES) expect(await changed(name), name).toBeLessThan(SAME);

    await editor.handle('left hand').click();
    await expect(page.getByText('Select a handle to see its reach')).toBeHidden();
    await expect(legend(editor)).toBeVisible();
    expect(isHot(await colour(editor, places['left hand']))).toBe(true);
    for (const name of NAMES.slice(1)) expect(await changed(name), name).toBeLessThan(COLD);

    // The selected handles move together, and their reaches add up.
    await editor.handle('right foot').click({ modifiers: ['Shift'] });
    expect(isHot(await colour(editor, places['left hand']))).toBe(true);
    expect(isHot(await colour(editor, places['right foot']))).toBe(true);
    expect(await changed('head')).toBeLessThan(2 * COLD);

    await page.keyboard.press('Escape');
    await expect(legend(editor)).toBeHidden();
    for (const name of NAMES) expect(await changed(name), name).toBeLessThan(SAME);
  });
}

test('the reach follows a drag, and equals that of the final pose', async ({ page }) => {
  const editor = await Editor.open(page);
  await switchReach(editor);
  const [hand, head] = [await editor.position('right hand'), await editor.position('head')];
  const elbow = { x: (hand.x + head.x) / 2, y: hand.y };
  const raise = async () => {
    await page.mouse.move(hand.x, hand.y);
    await page.mouse.down();
    await page.mouse.move(hand.x - 60, hand.y - 110, { steps: 4 });
  };
  await raise();
  expect(isHot(await colour(editor, await editor.position('right hand')))).toBe(true);
  await page.mouse.up();
  const settled = Buffer.from(
    await editor.settled(async () => (await editor.screenshot(elbow, 40)).toString('base64')),
    'base64',
  );
  await page.keyboard.press('Control+z');
  await expect
    .poll(async () => meanDifference(await editor.screenshot(elbow, 40), settled))
    .toBeGreaterThan(5);
  // The same drag again. Before the release, the picture has not quite come to rest.
  await raise();
  await expect.poll(async () => meanDifference(await editor.screenshot(elbow, 40), settled)).toBeLessThan(2);
  await page.mouse.up();
  await expect
    .poll(async () => meanDifference(await editor.screenshot(elbow, 40), settled))
    .toBeLessThan(SAME);
});

test('the original view and a disabled overlay show no reach', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  const head = await editor.position('head');
  const before = await editor.screenshot(head, RADIUS);
  await switchReach(editor);
  expect(isHot(await colour(editor, head))).toBe(true);
  await editor.handle('head').focus();
  await page.keyboard.down('o');
  await expect(page.locator('c2-warp p.hint', { hasText: 'Original' })).toBeVisible();
  await expect(legend(editor)).toBeHidden();
  expect(isHot(await colour(editor, head))).toBe(false);
  await page.keyboard.up('o');
  await expect(legend(editor)).toBeVisible();
  expect(isHot(await colour(editor, head))).toBe(true);
  await switchReach(editor);
  await expect(legend(editor)).toBeHidden();
  expect(meanDifference(await editor.screenshot(head, RADIUS), before)).toBeLessThan(SAME);
});

test('a readonly editor shows the reach of handles selected by keys', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => element.toggleAttribute('readonly', true));
  await editor.button('Overlays').focus();
  await page.keyboard.press('Enter');
  await expect(reachBox(editor)).toBeVisible();
  for (let tab = 0; tab < 6; tab++) await page.keyboard.press('Tab');
  await expect(reachBox(editor)).toBeFocused();
  await page.keyboard.press('Space');
  await expect(reachBox(editor)).toBeChecked();
  await expect(reachBox(editor)).toHaveAccessibleDescription(/follows/);
  await page.keyboard.press('Escape');
  await page.getByRole('region', { name: 'Properties' }).getByRole('button', { name: 'Head' }).press('Enter');
  await expect(legend(editor)).toBeVisible();
  expect(isHot(await colour(editor, await editor.position('head')))).toBe(true);
});

test('a handle being placed shows its reach after the solve', async ({ page }) => {
  const editor = await Editor.open(page);
  await switchReach(editor);
  const [left, right] = [await editor.position('left hand'), await editor.position('right hand')];
  const belly = { x: (left.x + right.x) / 2, y: left.y + 120 };
  await page.keyboard.press('p');
  await editor.waitForSolve(() => page.mouse.click(belly.x, belly.y));
  await expect.poll(async () => isHot(await colour(editor, belly))).toBe(true);
  await page.keyboard.press('Control+z');
  await expect(editor.handle('handle 1')).toBeHidden();
  expect(isHot(await colour(editor, belly))).toBe(false);
});
