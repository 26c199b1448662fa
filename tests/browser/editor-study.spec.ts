/** The study card: all settings of the project, and the figures of the method on the open picture. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Locator } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';

const card = ({ page }: Editor): Locator => page.getByRole('region', { name: 'How the warp works' });

const project = ({ page }: Editor) =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

/** Fails if axe finds anything in the editor. */
async function expectAccessible({ page }: Editor): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).include('c2-warp').analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join(' ')}`)).toEqual(
    [],
  );
}

async function openSettings(editor: Editor): Promise<void> {
  await editor.button('All settings').click();
  await expect(card(editor).getByRole('region', { name: 'Settings' })).toBeVisible();
}

/** A number of the settings page. */
const number = (editor: Editor, label: string): Locator =>
  card(editor).getByRole('spinbutton', { name: new RegExp(`^${label} `) });

test.describe('settings', () => {
  test('each is shown with a sentence, can be set, and is one step to undo', async ({ page }) => {
    const editor = await Editor.open(page);
    await openSettings(editor);
    for (const heading of await card(editor).getByRole('heading').all()) {
      const sentence = heading.locator('xpath=following-sibling::p');
      expect((await sentence.textContent())?.length, (await heading.textContent()) ?? '').toBeGreaterThan(30);
    }
    const before = await project(editor);
    const set = async (label: string, value: string) => {
      await number(editor, label).fill(value);
      await number(editor, label).press('Enter');
    };
    await editor.waitForSolve(() => set('At least', '20'));
    await editor.waitForSolve(() => set('Points', '4000'));
    await set('α', '0.5');
    await set('n', '9');
    await set('Opacity', '0.3');
    const choose = (group: string, name: string) =>
      card(editor).getByRole('group', { name: group }).getByRole('button', { name }).click();
    await choose('Support rule', 'Paper');
    await choose('Continuity', 'C²');
    await choose('Falloff shape', 'Half');
    await choose('Blend', 'Rigid');
    expect(await project(editor)).toMatchObject({
      samples: 4000,
      weighting: { shape_factor: 0.5, degree: 9, filling: 'half', support: 'paper', continuity: 'c2' },
      pose: { mode: 'rigid', blend: 'rigid', density: 20 },
      domain: { kind: 'alpha', threshold: 0.3 },
    });
    await expect(editor.solved).toContainText(/2\d helper points/);
    for (let step = 0; step < 9; step++) await editor.button(/^Undo/).click();
    expect(await project(editor)).toEqual(before);
    await expect(number(editor, 'α')).toHaveValue('1');
  });

  test('the slider of α is one step, by pointer and by keys', async ({ page }) => {
    const editor = await Editor.open(page);
    await openSettings(editor);
    const slider = card(editor).getByRole('slider', { name: 'Support factor α' });
    const box = await slider.boundingBox();
    if (!box) throw new Error('the slider is not visible');
    const y = box.y + box.height / 2;
    await page.mouse.move(box.x + box.width - 8, y);
    await page.mouse.down();
    for (const part of [0.8, 0.6, 0.5]) await page.mouse.move(box.x + part * box.width, y);
    await page.mouse.up();
    const alpha = async () => (await project(editor)).weighting?.shape_factor;
    expect(await alpha()).toBeCloseTo(0.5, 1);
    await editor.button(/^Undo/).click();
    expect(await alpha()).toBe(1);
    await slider.focus();
    await slider.press('ArrowLeft');
    expect(await alpha()).toBe(0.99);
  });

  test('those of the paper and of the editor are each one press', async ({ page }) => {
    const editor = await Editor.open(page);
    await openSettings(editor);
    const before = await project(editor);
    await editor.button('Paper defaults').click();
    const { weighting, pose } = await project(editor);
    expect(weighting).toEqual({ shape_factor: 1, degree: 5, filling: 'line', support: 'paper' });
    expect(pose).toEqual({ mode: 'harmonic', blend: 'linear', density: 0 });
    await editor.button('Editor defaults').click();
    expect(await project(editor)).toEqual(before);
  });

  test('the card takes the place of the panel, and Escape gives it back', async ({ page }) => {
    const editor = await Editor.open(page);
    const head = await editor.position('head');
    await openSettings(editor);
    await expect(page.getByRole('region', { name: 'Properties' })).toHaveCount(0);
    expect((await editor.position('head')).x).toBeLessThan(head.x);
    await expectAccessible(editor);
    await page.keyboard.press('Escape');
    await expect(card(editor)).toHaveCount(0);
    await expect(page.getByRole('region', { name: 'Properties' })).toBeVisible();
    expect(await editor.position('head')).toEqual(head);
  });
});

/** Opens a page of the card, by the lens. */
async function openPage(editor: Editor, name: string): Promise<void> {
  await editor.page.keyboard.press('i');
  if (name !== 'Lens') await card(editor).getByRole('button', { name, exact: true }).click();
  await expect(card(editor).getByRole('region', { name })).toBeVisible();
}

/** The row of a handle's weight in the lens. */
const weight = (editor: Editor, name: string): Locator =>
  card(editor).getByRole('button', { name: new RegExp(`^${name} `) });

/** Saves the figure of the page, and returns the SVG. */
async function savedFigure(editor: Editor): Promise<string> {
  const started = editor.page.waitForEvent('download');
  await editor.button('Save as SVG').click();
  const download = await started;
  const name = download.suggestedFilename();
  await expect(editor.page.getByText(`Saved as ${name}.`)).toBeVisible();
  expect(name).toMatch(/^gingerbread-(lens|cells|rounds|compare)\.svg$/);
  return (await bytes(download)).toString('utf8');
}

/** Fails unless a file is an SVG that needs nothing of the page. */
function expectOnItsOwn(file: string): void {
  const svg = file.replace(/;base64,[\w+/=]+/g, '');
  expect(svg).toContain('xmlns="http://www.w3.org/2000/svg"');
  expect(svg).not.toMatch(/class=|var\(|color\(|<!--|NaN|undefined|style=/);
}

test.describe('the lens', () => {
  test('follows the pointer, and stays where a press puts it', async ({ page }) => {
    const editor = await Editor.open(page);
    await openPage(editor, 'Lens');
    const head = await editor.position('head');
    const point = card(editor).getByRole('heading', { level: 3 }).first();
    await page.mouse.move(head.x, head.y + 6);
    await page.mouse.move(head.x, head.y);
    await expect(weight(editor, 'head')).toContainText('100 %');
    const foot = await editor.position('left foot');
    await page.mouse.click(foot.x, foot.y);
    await expect(weight(editor, 'left foot')).toContainText('100 %');
    // The lens looks through the handle. It is neither selected nor moved.
    const handles = page.getByRole('group', { name: 'Handles' });
    await expect(handles.getByRole('button', { pressed: true })).toHaveCount(0);
    const at = (await point.textContent()) ?? '';
    await page.mouse.move(head.x, head.y);
    await editor.waitFrames();
    expect(await point.textContent()).toBe(at);
    await editor.button('Follow the pointer').click();
    await page.mouse.move(head.x, head.y + 1);
    await expect(weight(editor, 'head')).toContainText('100 %');
    await expectAccessible(editor);
  });

  test('is moved by arrow keys, announced, and closed by its key', async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.handle('head').focus();
    await openPage(editor, 'Lens');
    const spoken = page.locator('c2-warp .shell > .spoken[role="status"]');
    await expect(spoken).toHaveText(/^x 512, y 260: head 100 %/);
    for (let press = 0; press < 3; press++) await page.keyboard.press('Shift+ArrowDown');
    await expect(spoken).toHaveText(/^x 512, y \d+: .*helper points \d+/);
    await page.keyboard.press('i');
    await expect(card(editor)).toHaveCount(0);
    await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
    await openPage(editor, 'Lens');
    await page.keyboard.press('Escape');
    await expect(card(editor)).toHaveCount(0);
    await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
  });

  test('shows the shortest paths, bent with the picture', async ({ page }) => {
    const editor = await Editor.open(page);
    await openPage(editor, 'Lens');
    const foot = await editor.position('left foot');
    await page.mouse.click(foot.x, foot.y);
    const ways = page.locator('.marks .lens .way:not(.pale)');
    await expect(ways).toHaveCount(5);
    await expect(weight(editor, 'right foot')).toContainText(/[0-9]{3} px/);
    const way = async () => (await ways.nth(4).getAttribute('d')) ?? '';
    const before = await way();
    // Around the crotch: far more than the straight line.
    expect(before.split('L').length).toBeGreaterThan(20);
    await page.keyboard.press('v');
    await editor.dragHandle('right foot', { x: 20, y: -16 });
    await editor.waitFrames();
    expect(await way()).not.toBe(before);
  });

  test('has a falloff whose end can be dragged in one step', async ({ page }) => {
    const editor = await Editor.open(page);
    await openPage(editor, 'Lens');
    const foot = await editor.position('left foot');
    await page.mouse.click(foot.x + 20, foot.y - 40);
    await card(editor).getByText('Helper points', { exact: true }).click();
    await weight(editor, 'Helper \\d+').first().click();
    await expect(card(editor).getByRole('heading', { name: /^Falloff of helper point/ })).toBeVisible();
    const grip = card(editor).locator('.grip');
    await grip.scrollIntoViewIfNeeded();
    const at = await editor.centre(grip);
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x - 12, at.y);
    await page.mouse.move(at.x - 24, at.y);
    await page.mouse.up();
    const alpha = async () => (await project(editor)).weighting?.shape_factor ?? 1;
    await expect.poll(alpha).toBeLessThan(1);
    await editor.button(/^Undo/).click();
    expect(await alpha()).toBe(1);
    await expect(editor.button('Undo')).toBeDisabled();
  });

  test('is saved as a self-contained SVG', async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.handle('head').focus();
    await openPage(editor, 'Lens');
    await expect(weight(editor, 'head')).toContainText('100 %');
    const svg = await savedFigure(editor);
    expectOnItsOwn(svg);
    expect(svg).toContain('>left hand</text>');
    expect(svg).toContain('Falloff of head');
  });

  test('is open to readers', async ({ page }) => {
    const editor = await Editor.open(page);
    await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
    await editor.button('Inspect the weights at a point').click();
    const scene = page.getByRole('application');
    const box = await scene.boundingBox();
    await page.mouse.click((box?.x ?? 0) + 300, (box?.y ?? 0) + 300);
    await expect(weight(editor, 'head')).toBeVisible();
    await expect(card(editor).getByRole('slider')).toBeDisabled();
  });
});

test.describe('cells and rounds', () => {
  test('cells show their radii on the picture and in a figure to save, with times', async ({ page }) => {
    const editor = await Editor.open(page);
    await openPage(editor, 'Cells');
    await expect(
      card(editor).getByRole('heading', { name: 'Cells: 5 of handles, 150 of helper points' }),
    ).toBeVisible();
    const farthest = page.locator('.marks .radii .of-farthest');
    await expect(farthest).toBeAttached();
    const lines = ((await farthest.getAttribute('d')) ?? '').split('M').length - 1;
    expect(lines).toBe(155);
    await expect(card(editor).locator('.times')).toContainText(/Weights\s*\d/);
    await expect(card(editor).locator('.map .border')).toBeAttached();
    expectOnItsOwn(await savedFigure(editor));
    await expectAccessible(editor);
  });

  test('rounds are stepped, slid through and played', async ({ page }) => {
    const editor = await Editor.open(page);
    await openPage(editor, 'Rounds');
    const count = card(editor).locator('output.number');
    const dots = card(editor).locator('.map .dot');
    await expect(count).toHaveText(/^(\d+) \/ \1$/);
    await expect(dots).toHaveCount(155);
    const slider = card(editor).getByRole('slider', { name: 'Round' });
    await slider.focus();
    await slider.press('Home');
    await expect(count).toHaveText(/^1 \//);
    await expect(dots).toHaveCount(5);
    const inserted = page.locator('.marks .round .inserted');
    await expect(inserted).toHaveCount(0);
    await expect(page.locator('.marks .round .entering:not(.pale)')).not.toHaveCount(0);
    const words = card(editor).locator('.round-words');
    await expect(words).toHaveText(/^Round 1: .* A helper point enters the cell of [a-z ]+, \d+ px away/);
    await editor.button('Next round').click();
    await expect(count).toHaveText(/^2 \//);
    expect(await dots.count()).toBeGreaterThan(5);
    expect(await inserted.count()).toBe((await dots.count()) - 5);
    await expectAccessible(editor);
    await slider.focus();
    await slider.press('End');
    for (let press = 0; press < 4; press++) await slider.press('ArrowLeft');
    await expect(count).not.toHaveText(/^(\d+) \/ \1$/);
    await editor.button('Play').click();
    await expect(count).toHaveText(/^(\d+) \/ \1$/);
    await expect(editor.button('Play')).toBeVisible();
    await expect(words).toHaveText(/^Round \d+: done/);
    const svg = await savedFigure(editor);
    expectOnItsOwn(svg);
    expect(svg).toContain('>limit</text>');
  });

  test('two close handles need rounds until the score is allowed', async ({ page }) => {
    const editor = await Editor.open(page);
    await page.locator('c2-warp').evaluate((element) => {
      (element as C2Warp).addHandle({ kind: 'point', id: 'close', rest: [530, 260] });
    });
    await expect(editor.handle('close')).toBeVisible();
    await openPage(editor, 'Settings');
    await editor.waitForSolve(() => editor.button('Paper defaults').click());
    await card(editor).getByRole('button', { name: 'Rounds' }).click();
    const score = card(editor).getByRole('img', { name: /^The score is/ });
    await expect(score).toHaveAttribute('aria-label', /^The score is -0\.\d+\. The limit is -0\.05\.$/);
    await card(editor).getByRole('slider', { name: 'Round' }).press('Home');
    await expect(score).toHaveAttribute('aria-label', /^The score is 0\.\d+/);
    await expect(card(editor).locator('.round-words')).toHaveText(
      /reaches \d+ px, beyond the limit of \d+ px/,
    );
  });
});

test('three methods stand side by side, and follow a drag', async ({ page }) => {
  const editor = await Editor.open(page);
  await openPage(editor, 'Compare');
  const names = ['as in the paper', 'in rigid mode', 'with plain distances'];
  const pictures = names.map((name) => card(editor).getByRole('img', { name: `The picture warped ${name}` }));
  for (const picture of pictures) await expect(picture.locator('canvas:not(.waiting)')).toBeVisible();
  const shots = () => Promise.all(pictures.map((picture) => picture.screenshot()));
  await editor.waitFrames();
  const before = await editor.settled(async () => (await shots()).map((shot) => shot.toString('base64')));
  await editor.dragHandle('left hand', { x: 30, y: 60 });
  await editor.waitFrames();
  const after = await editor.settled(async () => (await shots()).map((shot) => shot.toString('base64')));
  for (const [at, shot] of after.entries()) expect(shot, names[at]).not.toBe(before[at]);
  // Three methods make three pictures.
  expect(new Set(after).size).toBe(3);
  const svg = await savedFigure(editor);
  expectOnItsOwn(svg);
  const saved = svg.match(/href="data:image\/png;base64,[^"]+"/g) ?? [];
  expect(new Set(saved).size).toBe(3);
  await expectAccessible(editor);
  await card(editor).getByRole('button', { name: 'Settings' }).click();
  await expect(card(editor).locator('canvas')).toHaveCount(0);
  await card(editor).getByRole('button', { name: 'Compare' }).click();
  await expect(card(editor).locator('.variant canvas:not(.waiting)')).toHaveCount(3);
});
