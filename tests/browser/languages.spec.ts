/** Languages: every text is in the table, fits when it is longer, and changes at run time without a loss. */
import { readFileSync } from 'node:fs';
import type { Locator, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { de } from '../../web/src/texts/de';
import { en } from '../../web/src/texts/en';
import { es } from '../../web/src/texts/es';
import { fr } from '../../web/src/texts/fr';
import { ja } from '../../web/src/texts/ja';
import { zh } from '../../web/src/texts/zh';
import { Editor } from './editor';
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
    /** Each finding with the first state that it was seen in. */
    const found = new Map<string, string>();
    const checked = async (state: string) => {
      for (const finding of [...(await unmarked(page)), ...(await unfitting(page))])
        if (!found.has(finding)) found.set(finding, state);
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
      await shown('.clip-key');
      await checked('the timeline');
      await warp(element, (editor) => {
        const { clips: _, ...project } = editor.project;
        editor.project = project;
      });
      await shown('.first-clip');
      await checked('the timeline without a clip');
      await element.locator('[data-preset="sway"]').click();
      await shown('.clip-key');
      await element.locator('[data-command="play"]').first().click();
      await element.locator('.clip-key').first().click();
      await checked('a new clip');
      await inPopover(element, 'export', async (card) => {
        await card.locator('.segments').first().getByRole('button').nth(1).click();
        await shown('#export .formats');
        await checked('the export of a film');
      });
    });

    await test.step('notices and pages', async () => {
      await element.locator('[popovertarget="files"]').click();
      await element.locator('input[name="address"]').fill('nowhere');
      await keyboard.press('Enter');
      await shown('.notice.error');
      await checked('an error');
      await warp(element, (editor) => {
        editor.addHandle({ id: 'blob', kind: 'point', rest: [500, 640] });
        editor.addHandle({ id: 'other', kind: 'point', rest: [500, 640] });
      });
      await expect(element.locator('.notice.error')).toContainText('sámé pláçé');
      await checked('a refusal of the solver');
      for (const name of ['disabled', 'posable'] as const) {
        await element.evaluate((editor, name) => editor.setAttribute(name, ''), name);
        await checked(name);
        await element.evaluate((editor, name) => editor.removeAttribute(name), name);
      }
    });
    expect([...found]).toEqual([]);
  });
}

const openLabel = (page: Page) => page.locator('c2-warp [data-command="open"]').first();

const MANUAL = readFileSync(new URL('../../web/docs/languages.md', import.meta.url), 'utf8');

const LANGUAGES = { de, es, fr, ja, zh } as const;

test('each language loads by the address, and marks the page', async ({ page }) => {
  for (const [tag, texts] of Object.entries(LANGUAGES)) {
    await page.goto(`/?lang=${tag}`);
    for (const name of ['open', 'save', 'undo', 'reset-all', 'compare', 'timeline'] as const) {
      const button = page.locator(`c2-warp .top [data-command="${name}"]`).first();
      await expect(button).toHaveAttribute('aria-label', texts.commands[name]);
    }
    await expect(page.locator('html')).toHaveAttribute('lang', tag);
    await expect(page.locator('c2-warp .shell')).toHaveAttribute('lang', tag);
  }
  const languages = await page.locator('c2-warp').evaluate((element) => {
    const { languages } = element.constructor as typeof C2Warp;
    return languages;
  });
  expect(languages).toEqual(['en', ...Object.keys(LANGUAGES)]);
  await page.goto('/?lang=xx');
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
});

test('a change of the language keeps the work, the tool, the selection and the focus', async ({ page }) => {
  const editor = await Editor.open(page);
  const element = page.locator('c2-warp');
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await page.keyboard.press('i');
  await page.keyboard.press('ArrowRight');
  await expect(element.locator('.study .weights')).toBeVisible();
  const now = () =>
    warp(element, (warp) => ({
      project: warp.project,
      selection: warp.selection,
      tool: warp.tool,
      focus: warp.shadowRoot?.activeElement?.className,
    }));
  const before = await now();
  const events = await element.evaluateHandle((warp) => {
    const labels: unknown[] = [];
    (warp as C2Warp).addEventListener('historychange', ({ detail }) => labels.push(detail.undo));
    return labels;
  });
  expect(MANUAL).toContain('<html lang="de-AT">');
  for (const [tag, texts] of [
    ['de-AT', de],
    ['en', en],
    ['fr', fr],
  ] as const) {
    // The nearest ancestor counts.
    await page.evaluate((tag) => {
      document.querySelector('main')?.setAttribute('lang', tag);
    }, tag);
    await expect(openLabel(page)).toHaveAttribute('aria-label', texts.commands.open);
    expect(await now()).toEqual(before);
  }
  await expect(element.locator('.shell')).toHaveAttribute('lang', 'fr');
  const undo = fr.toolbar.undoStep(fr.steps.move('left hand'));
  await expect(element.locator('[data-command="undo"]').first()).toHaveAttribute('aria-label', undo);
  await page.keyboard.press('Control+z');
  expect(await events.jsonValue()).toEqual([null]);
});

test('a page adds a language, and changes texts of one, as the manual does', async ({ page }) => {
  const element = await openPseudo(page);
  const label = element.locator('.top > .group .word').first();
  const [, code = ''] = /```js\n(import [^\n]*\n[\s\S]*?)```/.exec(MANUAL) ?? [];
  await page.evaluate(
    `{ const C2Warp = customElements.get('c2-warp'); ${code.replace(/^import .*$/m, '')} }`,
  );
  await page.evaluate(() => {
    document.documentElement.lang = 'nl-BE';
  });
  await expect(label).toHaveText('Openen');
  await expect(element.locator('.shell')).toHaveAttribute('lang', 'nl-BE');
  await expect(element.locator('[data-command="timeline"] .word')).toHaveText('Move');
  await expect(element.locator('.empty .primary')).toHaveText('Open a picture');
  await page.evaluate(async () => (await harness.pseudo()).addTexts('nl', { toolbar: { open: 'Open' } }));
  await expect(label).toHaveText('Open');
});

test('from right to left the layout mirrors, and pictures, numbers and times do not', async ({ page }) => {
  const editor = await Editor.open(page);
  const element = page.locator('c2-warp');
  const box = async (selector: string) => {
    const { x = 0, width = 0 } = (await element.locator(selector).first().boundingBox()) ?? {};
    return { left: x, right: x + width };
  };
  await editor.handle('left hand').focus();
  await page.keyboard.press('t');
  await expect(element.locator('.clip-key').first()).toBeVisible();
  const scale = await editor.scale();
  await page.evaluate(() => {
    document.documentElement.dir = 'rtl';
  });
  await expect(element.locator('.shell')).toHaveAttribute('dir', 'rtl');
  const [{ width }, panel, tools, names, time] = [
    page.viewportSize() ?? { width: 0 },
    await box('.panel'),
    await box('.tools'),
    await box('.track-name'),
    await box('.lane'),
  ];
  expect(panel.left).toBeLessThan(width / 4);
  expect(tools.right).toBeGreaterThan((3 * width) / 4);
  expect(names.left).toBeGreaterThanOrEqual(time.right - 1);
  // The picture is fitted between the cards, and its left hand is still at the left.
  const [left, right] = [await editor.position('left hand'), await editor.position('right hand')];
  expect(left.x).toBeLessThan(right.x);
  expect(left.x).toBeGreaterThan(panel.right);
  expect(right.x).toBeLessThan(tools.left);
  expect(await editor.scale()).toBeCloseTo(scale, 1);
  const seconds = element.locator('.second');
  const [first, last] = [await seconds.first().boundingBox(), await seconds.last().boundingBox()];
  expect(first?.x).toBeLessThan(last?.x ?? 0);
  expect(
    await element
      .locator('.field')
      .first()
      .evaluate((field) => getComputedStyle(field).direction),
  ).toBe('ltr');
});
