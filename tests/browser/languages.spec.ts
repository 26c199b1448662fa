/** Languages: every text is in the table, fits when it is longer, and changes at run time without a loss. */
import type { Locator, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { expect, test } from './fixtures';
import { unfitting, unmarked } from './marked_texts';

/** The harness with an editor in the pseudo-language. */
async function openPseudo(page: Page): Promise<Locator> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('/harness/');
  await page.waitForFunction(() => 'harness' in globalThis);
  await page.evaluate(async () => (await harness.pseudo()).pseudoEditor());
  const element = page.locator('c2-warp');
  await expect(element.locator('.top')).toHaveAttribute('aria-label', /^⟦/);
  return element;
}

const warp = <R>(element: Locator, act: (editor: C2Warp) => R | Promise<R>): Promise<R> =>
  element.evaluate(act as never) as Promise<R>;

/** Opens a popover by its button, checks it on each page that `pages` shows, and closes it. */
async function inPopover(
  element: Locator,
  id: string,
  look: (card: Locator) => Promise<void>,
): Promise<void> {
  const card = element.locator(`#${id}`);
  await element.locator(`[popovertarget="${id}"]`).first().click();
  await expect(card).toBeVisible();
  await look(card);
  await element.page().keyboard.press('Escape');
  await expect(card).toBeHidden();
}

for (const [width, height] of [
  [1280, 800],
  [320, 640],
] as const) {
  test(`every text is in the table, and fits in ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    const isPhone = width < 500;
    const element = await openPseudo(page);
    const { keyboard } = page;
    const checked = async (state: string) => {
      expect.soft(await unmarked(page), `${state}: every text is marked`).toEqual([]);
      expect.soft(await unfitting(page), `${state}: every text fits`).toEqual([]);
    };
    const shown = (selector: string) => expect(element.locator(selector).first()).toBeVisible();

    await shown('.empty .primary');
    await checked('without a picture');
    await warp(element, (editor) =>
      editor.load('/samples/gingerbread.png', '/samples/gingerbread.c2warp.json'),
    );
    await warp(element, (editor) => editor.focus());
    await expect(element.locator('.solved')).toContainText('⟦');
    await checked('a picture');

    await test.step('menus and lists', async () => {
      await inPopover(element, 'files', () => checked('the menu of files'));
      if (isPhone) await inPopover(element, 'more', () => checked('the menu of a phone'));
      await keyboard.press('?');
      await shown('#keys');
      await checked('the list of keys');
      await keyboard.press('Escape');
      await element.locator('[data-control="overlay-button"]').click();
      await shown('.overlays');
      await element.locator('.overlays input').nth(6).check();
      await checked('the list of overlays');
      await element.locator('.overlays .button').click();
      await inPopover(element, 'export', async (card) => {
        for (const k of [0, 1, 2, 3, 4]) {
          await card.locator('.segments').first().getByRole('button').nth(k).click();
          await expect(card.locator('.row')).toBeVisible();
          await checked(`export ${k}`);
        }
        for (const k of [4, 5]) {
          await card.locator('.map-kinds').getByRole('button').nth(k).click();
          await checked(`map ${k}`);
        }
      });
    });

    await test.step('handles', async () => {
      await warp(element, (editor) => {
        editor.addHandle({
          id: 'arm',
          kind: 'bar',
          rest: [
            [400, 600],
            [600, 600],
          ],
        });
        editor.selection = ['arm'];
      });
      await shown('.properties');
      if (isPhone) await element.locator('.unfold').click();
      await element.locator('[data-corner="1"]').focus();
      await checked('the corner of a bar');
      await keyboard.press('Shift+F10');
      await shown('[role="menu"]');
      await checked('the menu of a corner');
      await keyboard.press('Escape');
      const x = element.locator('.field input[name="x"]');
      await x.fill('words');
      await x.press('Enter');
      await shown('.notice');
      await checked('a refused number');
      await warp(element, (editor) => {
        editor.selection = ['head'];
      });
      await element.locator('[data-handle="head"]').focus();
      await keyboard.press('F2');
      await element.locator('[data-control="name"]').fill('');
      await shown('.fault');
      await checked('a name that is refused');
      await keyboard.press('Escape');
      await warp(element, (editor) => {
        editor.selection = [];
      });
      await keyboard.press('Shift+F10');
      await shown('[role="menu"]');
      await checked('the menu of the picture');
      await keyboard.press('Escape');
      if (!isPhone) return;
      await element.locator('[data-command="settings"]').click();
      await checked('how the picture bends');
      await keyboard.press('Escape');
    });

    await test.step('tools', async () => {
      await warp(element, (editor) => editor.focus());
      await keyboard.press('f');
      for (const kind of ['push', 'pinch', 'bloat', 'smooth', 'restore', 'stiffen']) {
        await element.locator(`[data-brush="${kind}"]`).click();
        await checked(`the brush, ${kind}`);
      }
      for (const key of ['b', 'g', 'l']) {
        await warp(element, (editor) => editor.focus());
        await keyboard.press(key);
        await shown('.hint');
        await checked(`the tool ${key}`);
      }
      await element.locator('.stage').click({ position: { x: width / 2, y: 200 } });
      await shown('.draft-bar');
      await checked('a drawing');
      await keyboard.press('Escape');
      await keyboard.press('v');
    });

    await test.step('the study card', async () => {
      await keyboard.press('i');
      await shown('.study');
      await keyboard.press('ArrowRight');
      await shown('.study .weights');
      for (const k of [0, 1, 2, 3, 4]) {
        await element.locator('.study header .segment').nth(k).click();
        await shown('.study .page');
        if (k === 1) await shown('.study .times');
        if (k === 2) await shown('.study .player');
        await checked(`the study card ${k}`);
      }
      await element.locator('.study header > .button').click();
    });

    await test.step('the timeline', async () => {
      await warp(element, (editor) => editor.focus());
      await keyboard.press('t');
      await shown('.first-clip');
      await checked('the timeline without a clip');
      await element.locator('[data-preset="sway"]').click();
      await shown('.clip-key');
      await element.locator('[data-command="play"]').first().click();
      await element.locator('.clip-key').first().click();
      await checked('the timeline');
      await inPopover(element, 'export', async (card) => {
        await card.locator('.segments').first().getByRole('button').nth(1).click();
        await shown('#export .formats');
        await checked('the export of a film');
      });
    });

    await test.step('notices and pages', async () => {
      await inPopover(element, 'files', async (card) => {
        await card.locator('input[name="address"]').fill('nowhere');
        await card.locator('form .button').click();
      }).catch(() => {});
      await shown('.notice.error');
      await checked('an error');
      await warp(element, (editor) => {
        editor.addHandle({ id: 'blob', kind: 'point', rest: [500, 640] });
        editor.addHandle({ id: 'other', kind: 'point', rest: [500, 640] });
      });
      await expect(element.locator('.notice.error')).toContainText('⟦hándlés');
      await checked('a refusal of the solver');
      for (const name of ['disabled', 'posable'] as const) {
        await element.evaluate((editor, name) => editor.setAttribute(name, ''), name);
        await checked(name);
        await element.evaluate((editor, name) => editor.removeAttribute(name), name);
      }
    });
  });
}
