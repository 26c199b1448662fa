/** Typed numbers: as people, input methods and locales write them, in every number field. */
import type { Locator, Page } from '@playwright/test';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const fullWidth = (text: string): string =>
  text.replace(/[!-~]/g, (sign) => String.fromCharCode(sign.charCodeAt(0) + 0xfee0));

const value = async (field: Locator): Promise<number> => Number(await field.getAttribute('aria-valuenow'));

async function type(field: Locator, text: string): Promise<void> {
  await field.fill(text);
  await field.press('Enter');
}

/** Shows number fields, and returns them. */
const PLACES: Readonly<Record<string, (page: Page) => Promise<Locator>>> = {
  'the panel': async (page) => page.locator('c2-warp .panel [role=spinbutton]'),
  'the timeline': async (page) => {
    await page.locator('c2-warp .stage').focus();
    await page.keyboard.press('t');
    return page.locator('c2-warp .timeline [role=spinbutton]');
  },
  'the export of films': (page) => exportFields(page, 'Film'),
  'the export for engines': (page) => exportFields(page, 'Engine'),
};

async function exportFields(page: Page, kind: string): Promise<Locator> {
  const card = page.getByRole('dialog', { name: 'Export' });
  if (!(await card.isVisible())) await page.getByRole('button', { name: 'Export as …' }).click();
  await card.getByRole('button', { name: kind, exact: true }).click();
  return card.locator('[role=spinbutton]');
}

test('number fields read full-width digits, and reject words with a notice', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  for (const [place, show] of Object.entries(PLACES)) {
    const fields = await show(page);
    await expect(fields.first(), place).toBeVisible();
    for (const field of await fields.all()) {
      const [before, label] = [await value(field), await field.getAttribute('aria-label')];
      const most = Number((await field.getAttribute('aria-valuemax')) ?? Number.POSITIVE_INFINITY);
      await type(field, 'twelve');
      await expect(page.locator('c2-warp .notice'), label ?? '').toContainText(/number|from .* to/);
      expect(await value(field), label ?? '').toBe(before);
      const next = before + 1 > most ? before - 1 : before + 1;
      await type(field, fullWidth(String(next)));
      await expect.poll(() => value(field), label ?? '').toBeCloseTo(next, 1);
    }
  }
});

test('signs and groups of other locales are read', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  for (const [text, number] of [
    ['－１２．５', -12.5],
    ['−3,5', -3.5],
    ['1 024,5', 1024.5],
    ['1 024', 1024],
    ['١٢٫٥', 12.5],
  ] as const) {
    await type(editor.field('x'), text);
    await expect(editor.field('x')).toHaveValue(String(number));
  }
  await expect(page.locator('c2-warp .notice')).toHaveCount(0);
});

test('keys of an input method are no shortcuts, and nothing is set before the text is', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  const x = editor.field('x');
  const before = await x.inputValue();
  await x.click();
  await page.keyboard.press('Control+a');
  const input = await page.context().newCDPSession(page);
  const compose = () =>
    input.send('Input.imeSetComposition', { text: '３００', selectionStart: 3, selectionEnd: 3 });
  await compose();
  for (const key of ['Enter', 'ArrowUp', 'Escape', 'Delete']) {
    // As input methods send them.
    for (const type of ['rawKeyDown', 'keyUp'] as const)
      await input.send('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode: 229 });
    await expect(x, key).toBeFocused();
    expect(await x.getAttribute('aria-valuenow'), key).toBe(before);
  }
  await expect(editor.button('Undo')).toBeDisabled();
  await input.send('Input.insertText', { text: '３００' });
  await page.keyboard.press('Enter');
  await expect(x).toHaveValue('300');
});
