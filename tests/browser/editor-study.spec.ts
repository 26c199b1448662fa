/** The study card: all settings of the project. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Locator } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const card = ({ page }: Editor): Locator => page.getByRole('region', { name: 'See the paper' });

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
    await choose('Rule of supports', 'Paper');
    await choose('Filling of the falloff', 'Half');
    await choose('Blend', 'Rigid');
    expect(await project(editor)).toMatchObject({
      samples: 4000,
      weighting: { shape_factor: 0.5, degree: 9, filling: 'half', support: 'paper' },
      pose: { mode: 'rigid', blend: 'rigid', density: 20 },
      domain: { kind: 'alpha', threshold: 0.3 },
    });
    await expect(editor.solved).toContainText(/2\d virtual handles/);
    for (let step = 0; step < 8; step++) await editor.button(/^Undo/).click();
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
    await editor.button('As in the paper').click();
    const { weighting, pose } = await project(editor);
    expect(weighting).toEqual({ shape_factor: 1, degree: 5, filling: 'line', support: 'paper' });
    expect(pose).toEqual({ mode: 'harmonic', blend: 'linear', density: 0 });
    await editor.button('As in the editor').click();
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
