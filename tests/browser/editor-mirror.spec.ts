/** Mirroring handles to the other side of the domain. */
import { corners } from '../../web/src/document/handle';
import type { Handle } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Returns the corners of a handle's mirror image. */
const flipped = (handle: Handle | undefined, of: 'rest' | 'posed') =>
  handle ? corners(handle, of).map(([x, y]) => [expect.closeTo(1024 - x, 1), expect.closeTo(y, 1)]) : [];
const places = (handle: Handle | undefined, of: 'rest' | 'posed') => (handle ? corners(handle, of) : []);

test('M poses and selects the hand on the other side', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  const left = await editor.projectHandle('left-hand');
  await page.keyboard.press('m');
  await expect(editor.handle('right hand')).toBeFocused();
  await expect(editor.handle('right hand')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handle('left hand')).toHaveAttribute('aria-pressed', 'false');
  await expect(page.getByText(/^Mirror left hand\. right hand: x \d+, y \d+, rotation/)).toBeAttached();
  const right = await editor.projectHandle('right-hand');
  expect(places(right, 'posed')).toEqual(flipped(left, 'posed'));
  expect(await editor.projectHandle('left-hand')).toEqual(left);
  // The picture follows equally on both sides.
  const one = await editor.settled(() => editor.mapped(200, 540));
  const other = await editor.mapped(824, 540);
  expect(
    Math.hypot(1024 - (one?.[0] ?? 0) - (other?.[0] ?? 0), (one?.[1] ?? 0) - (other?.[1] ?? 0)),
  ).toBeLessThan(3);

  await page.keyboard.press('ArrowUp');
  const [[x, y] = [0, 0]] = places(right, 'posed');
  expect((await editor.projectHandle('right-hand'))?.posed).toEqual([x, y - 1]);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(page.getByText('Undone: Mirror left hand')).toBeAttached();
  expect((await editor.projectHandle('right-hand'))?.posed).toEqual([900, 516]);
  expect(await editor.projectHandle('left-hand')).toEqual(left);
});

test('the button adds missing counterparts, bars too', async ({ page }) => {
  const editor = await Editor.open(page);
  const at = await editor.fromImage('left hand', [124, 516]);
  await editor.handle('right foot').focus();
  await editor.waitForSolve(() => page.keyboard.press('Delete'));
  await page.keyboard.press('b');
  const [hip, knee] = [at(400, 850), at(370, 990)];
  await editor.waitForSolve(() => editor.drag(hip, { x: knee.x - hip.x, y: knee.y - hip.y }));
  await expect(editor.corner(2, 'bar 1')).toBeVisible();
  await page.keyboard.press('v');
  await page.keyboard.down('Shift');
  const foot = await editor.position('left foot');
  await page.mouse.click(foot.x, foot.y);
  await page.keyboard.up('Shift');
  await expect(page.getByRole('heading', { name: '2 handles' })).toBeVisible();
  await editor.waitForSolve(() => editor.button('Mirror to the other side').click());
  await expect(editor.handle('right foot')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handle('bar 2')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handle('bar 1')).toHaveAttribute('aria-pressed', 'false');
  expect(await editor.projectHandle('right-foot')).toMatchObject({
    rest: [expect.closeTo(712, 0), 1126],
    rotation: 'auto',
  });
  const [bar, image] = [await editor.projectHandle('bar-1'), await editor.projectHandle('bar-2')];
  expect(places(image, 'rest')).toEqual(flipped(bar, 'rest'));
  await page.keyboard.press('Control+z');
  await expect(editor.handles).toHaveCount(7);
});

test('mirroring all handles flips the pose; unmatched ones are reported', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('m');
  await expect(page.getByText('Both sides already match')).toBeVisible();
  await expect(editor.button(/^Undo/)).toBeDisabled();

  await editor.dragHandle('head', { x: 40, y: 0 });
  await editor.dragHandle('left hand', { x: 0, y: -60 });
  const [head, hand] = [await editor.projectHandle('head'), await editor.projectHandle('left-hand')];
  await page.keyboard.press('Control+a');
  await page.keyboard.press('m');
  expect(places(await editor.projectHandle('head'), 'posed')).toEqual(flipped(head, 'posed'));
  expect(places(await editor.projectHandle('right-hand'), 'posed')).toEqual(flipped(hand, 'posed'));
  expect((await editor.projectHandle('left-hand'))?.posed).toEqual([124, 516]);

  // A lasso around one arm leaves nothing on the other side of the figure.
  const hold = () =>
    page.locator('c2-warp').evaluate((element) => {
      const editor = element as C2Warp;
      const { project } = editor;
      const ring = [
        [0, 380],
        [330, 380],
        [330, 460],
        [160, 460],
        [160, 660],
        [0, 660],
      ] as const;
      const handles = project.handles.filter(({ id }) => id === 'left-hand');
      // The clips of the sample move the other handles too.
      editor.project = { ...project, domain: { kind: 'polygon', rings: [ring] }, handles, clips: [] };
    });
  await editor.waitForSolve(hold);
  await expect(editor.handles).toHaveCount(1);
  await editor.handle('left hand').focus();
  await page.keyboard.press('m');
  await expect(page.getByText('The mirrored position of left hand is outside the picture.')).toBeVisible();
  await expect(editor.handle('left hand')).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.handles).toHaveCount(1);
});

test('a held key mirrors once', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('head', { x: 40, y: 0 });
  const head = await editor.projectHandle('head');
  for (let press = 0; press < 4; press++) await page.keyboard.down('m');
  await page.keyboard.up('m');
  expect(places(await editor.projectHandle('head'), 'posed')).toEqual(flipped(head, 'posed'));
  await page.keyboard.press('Control+z');
  expect(await editor.projectHandle('head')).toEqual(head);
});

test('a readonly editor mirrors nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 30, y: -80 });
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  await expect(editor.button('Mirror to the other side')).toBeDisabled();
  await editor.handle('left hand').focus();
  await page.keyboard.press('m');
  await editor.waitFrames();
  expect((await editor.projectHandle('right-hand'))?.posed).toEqual([900, 516]);
});
