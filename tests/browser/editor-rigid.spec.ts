/** The rigid mode: automatic turns, pinned turns, and the switch to turns by hand. */
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const rotationInFile = (editor: Editor, id: string) =>
  editor.page
    .locator('c2-warp')
    .evaluate(
      (element, name) => (element as C2Warp).project.handles.find((handle) => handle.id === name)?.rotation,
      id,
    );

const turn = async (editor: Editor) => Number(await editor.field('rotation').inputValue());

test('a dragged hand turns automatically, and its field shows the turn', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: -60, y: -110 });
  // The arm points up now: the turn is counterclockwise.
  await expect.poll(() => turn(editor)).toBeLessThan(-15);
  await expect.poll(() => rotationInFile(editor, 'right-hand')).toBe('auto');
  await expect(editor.button('Auto rotation')).toHaveAttribute('aria-pressed', 'true');
  const shown = await editor.settled(() => turn(editor));
  // The name of the handle has whole degrees, the field tenths.
  const apart = async () => Math.abs((await editor.shownPose('right hand')).rotation - shown);
  await expect.poll(apart).toBeLessThan(0.6);

  await editor.button('Reset to rest').click();
  await expect.poll(() => rotationInFile(editor, 'right-hand')).toBe('auto');
  await expect.poll(() => turn(editor)).toBeCloseTo(0, 1);
});

test('a pinned hand keeps its turn until the automatic turn is back on', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: -60, y: -110 });
  await expect.poll(() => turn(editor)).toBeLessThan(-15);
  const shown = await editor.settled(() => turn(editor));
  const toggle = editor.button('Auto rotation');
  await toggle.click();
  await expect(toggle).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(() => turn(editor)).toBe(shown);
  await editor.dragHandle('right hand', { x: 40, y: 150 });
  await expect.poll(() => turn(editor)).toBe(shown);

  await toggle.click();
  await expect.poll(() => turn(editor)).not.toBe(shown);
  await page.keyboard.press('Control+z');
  await expect.poll(() => turn(editor)).toBe(shown);
});

test('the ring continues from the automatic turn', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: -60, y: -110 });
  await expect.poll(() => turn(editor)).toBeLessThan(-15);
  const shown = await editor.settled(() => turn(editor));
  const hand = await editor.settled(() => editor.position('right hand'));
  await editor.drag({ x: hand.x + 40, y: hand.y }, { x: -40, y: 40 });
  await expect.poll(async () => Math.abs((await turn(editor)) - (shown + 90))).toBeLessThan(2);
  await expect(editor.button('Auto rotation')).toHaveAttribute('aria-pressed', 'false');
});

test('the bending mode changes with one click and one undo step', async ({ page }) => {
  const editor = await Editor.open(page);
  const settings = () =>
    page.locator('c2-warp').evaluate((element) => {
      const { pose, weighting } = (element as C2Warp).project;
      return [pose?.mode, pose?.density, weighting?.support];
    });
  const [rigid, elastic] = ['Rigid', 'Elastic'].map((name) =>
    page.getByRole('button', { name, exact: true }),
  );
  if (!rigid || !elastic) throw new Error('two ways to bend');
  await expect(rigid).toHaveAttribute('aria-pressed', 'true');
  await elastic.focus();
  await page.keyboard.press('Enter');
  await expect(elastic).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('group', { name: 'Detail' })).toBeHidden();
  await expect.poll(() => settings()).toEqual(['harmonic', 0, 'paper']);

  await page.keyboard.press('Control+z');
  await expect(rigid).toHaveAttribute('aria-pressed', 'true');
  await expect(editor.button('Undo')).toBeDisabled();
  await expect.poll(() => settings()).toEqual(['rigid', 150, 'smooth']);

  await editor.waitForSolve(() => page.getByRole('button', { name: 'Fine', exact: true }).click());
  await expect.poll(() => settings()).toEqual(['rigid', 200, 'smooth']);
});

test('bending settings collapse with a selection; press and key open them', async ({ page }) => {
  const editor = await Editor.open(page);
  const elastic = page.getByRole('button', { name: 'Elastic', exact: true });
  await expect(elastic).toBeVisible();
  await editor.handle('head').click();
  await expect(elastic).toBeHidden();
  const line = page.locator('c2-warp summary').filter({ hasText: 'Bending' });
  await expect(line).toContainText('rigid, medium');
  await line.click();
  await expect(elastic).toBeVisible();
  await editor.handle('left hand').click();
  await expect(elastic).toBeVisible();
  await line.focus();
  await page.keyboard.press('Enter');
  await expect(elastic).toBeHidden();
  await expect(editor.handle('left hand')).toHaveAttribute('aria-pressed', 'true');
  await editor.button('Draw a bar').click();
  await expect(elastic).toBeVisible();
});

test('by hand, a switch keeps widths, as one step without a solve', async ({ page }) => {
  const editor = await Editor.open(page);
  const project = () =>
    page.locator('c2-warp').evaluate((element) => (element as HTMLElementTagNameMap['c2-warp']).project);
  await expect(editor.switch('Keep widths')).toBeHidden();
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await editor.switch('Keep widths').click();
  await expect(editor.switch('Keep widths')).toBeChecked();
  await expect.poll(async () => (await project()).pose?.blend).toBe('rigid');
  await editor.dragHandle('right hand', { x: -10, y: -80 });
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await project()).pose?.blend).not.toBe('rigid');
});

test('Elastic and back changes no handle, and looks like an elastic project', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: -60, y: -110 });
  await expect.poll(() => turn(editor)).toBeLessThan(-15);
  await page.keyboard.press('Escape');
  const places = () =>
    page.locator('c2-warp').evaluate((element) => {
      const map = (x: number, y: number) => (element as C2Warp).mapPoint([x, y]);
      return [map(880, 516), map(780, 560), map(512, 100), map(512, 600), map(312, 1126)];
    });
  const rigid = await editor.settled(async () => JSON.stringify(await places()));
  await editor.waitForSolve(() => editor.button('Elastic').click());
  await expect.poll(() => rotationInFile(editor, 'right-hand')).toBe('auto');
  const elastic = await editor.settled(async () => JSON.stringify(await places()));
  expect(elastic).not.toBe(rigid);
  await editor.waitForSolve(() => editor.button('Rigid').click());
  await expect.poll(async () => JSON.stringify(await places())).toBe(rigid);

  // The same handles in a project that has always been elastic.
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const { weighting, pose, ...project } = warp.project;
    warp.project = {
      ...project,
      weighting: { ...weighting, support: 'paper' },
      pose: { ...pose, mode: 'harmonic', density: 0 },
    };
  });
  await expect.poll(async () => JSON.stringify(await places())).toBe(elastic);
});
