/** Layout: in small frames, on pages with their own styles, in forced colours. */
import type { Locator, Page } from '@playwright/test';
import { insetsOf } from '../../web/src/editor/insets';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const box = async (shown: Locator) => {
  const found = await shown.boundingBox();
  if (!found) throw new Error(`${shown} is not shown`);
  return { ...found, right: found.x + found.width, bottom: found.y + found.height };
};

/** Returns the distances between the dots and their handles on the stage, CSS pixels. */
const misplaced = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => {
    const root = element.shadowRoot;
    const stage = root?.querySelector('.stage')?.getBoundingClientRect();
    const dots = [...(root?.querySelectorAll('.handle') ?? [])];
    return dots.map((dot) => {
      const [at, to] = [dot.getBoundingClientRect(), new DOMMatrix(getComputedStyle(dot).transform)];
      const [x, y] = [at.x + at.width / 2 - (stage?.x ?? 0), at.y + at.height / 2 - (stage?.y ?? 0)];
      return Math.round(Math.hypot(x - to.e, y - to.f));
    });
  });

test('text styles of the page move no handle', async ({ page }) => {
  await Editor.open(page);
  for (const [property, value] of [
    ['direction', 'rtl'],
    ['text-align', 'right'],
    ['text-indent', '40px'],
    ['white-space', 'pre'],
    ['letter-spacing', '0.3em'],
    ['writing-mode', 'vertical-rl'],
  ] as const) {
    await page.evaluate(([name, value]) => document.body.style.setProperty(name, value), [
      property,
      value,
    ] as const);
    expect(await misplaced(page), property).toEqual([0, 0, 0, 0, 0]);
    await page.evaluate((name) => document.body.style.removeProperty(name), property);
  }
});

test('Tab pans a handle into view beside the cards, without scrolling', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('1');
  for (let notch = 0; notch < 3; notch++) await page.keyboard.press('+');
  const [panel, stage] = [page.getByRole('region', { name: 'Properties' }), page.locator('c2-warp .stage')];
  for (const name of ['left hand', 'right hand', 'left foot']) {
    await page.keyboard.press('Tab');
    await expect(editor.handle(name)).toBeFocused();
    const at = await editor.settled(() => editor.position(name));
    const frame = await box(stage);
    expect(at.x, name).toBeGreaterThan(frame.x);
    expect(at.x, name).toBeLessThan((await box(panel)).x);
    expect(at.y, name).toBeGreaterThan(frame.y);
    expect(at.y, name).toBeLessThan(frame.bottom);
    expect(await stage.evaluate(({ scrollLeft, scrollTop }) => [scrollLeft, scrollTop])).toEqual([0, 0]);
  }
});

for (const [width, height] of [
  [240, 240],
  [320, 240],
  [320, 480],
  [500, 240],
  [640, 240],
  [667, 331],
] as const) {
  test(`every toolbar and status button lies inside ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await Editor.open(page);
    const buttons = page.locator('c2-warp').locator('.top .button, .tools .button, .status .button');
    for (const button of await buttons.filter({ visible: true }).all()) {
      const name = (await button.getAttribute('aria-label')) ?? '';
      const { x, y, right, bottom } = await box(button);
      expect(Math.min(x, y, width - right, height - bottom), name).toBeGreaterThanOrEqual(0);
    }
    const [tools, status] = [page.locator('c2-warp .tools'), page.locator('c2-warp .status')];
    expect((await box(tools)).bottom).toBeLessThanOrEqual((await box(status)).y);
  });
}

const SMALL = [
  [280, 240],
  [400, 240],
  [320, 300],
  [360, 340],
  [280, 400],
  [400, 400],
  [640, 240],
  [640, 320],
  [900, 400],
] as const;

/** A button that a pointer reaches, also by scrolling, within the window. */
async function expectReached(button: Locator, name: string): Promise<void> {
  await button.scrollIntoViewIfNeeded();
  const isHit = await button.evaluate((element) => {
    const { x, y, width, height } = element.getBoundingClientRect();
    const root = element.getRootNode() as ShadowRoot;
    const hit = root.elementFromPoint(x + width / 2, y + height / 2);
    return element.contains(hit);
  });
  expect(isHit, name).toBe(true);
}

for (const pointer of ['fine', 'coarse'] as const)
  test.describe(`small elements, with a ${pointer} pointer`, () => {
    test.use(pointer === 'coarse' ? { hasTouch: true, isMobile: true } : {});

    for (const [width, height] of SMALL)
      test(`every tool is within reach at ${width} × ${height}, ${pointer}`, async ({ page }) => {
        await page.setViewportSize({ width, height });
        const editor = await Editor.open(page);
        const words = {
          select: 'Select and move',
          point: 'Add a point handle',
          bar: 'Draw a bar',
          polygon: 'Draw a polygon',
          lasso: /^Lasso/,
          brush: 'Brush',
          hand: 'Pan',
          lens: /^Inspect the weights/,
        };
        for (const [name, label] of Object.entries(words)) {
          const tool = page.locator(`c2-warp .tools [data-command='${name}']`);
          if (await tool.isVisible()) {
            await expectReached(tool, name);
            continue;
          }
          await editor.button('More').click();
          await expectReached(page.locator('c2-warp #more').getByRole('button', { name: label }), name);
          await page.keyboard.press('Escape');
        }
        const bars = page
          .locator('c2-warp')
          .locator('.top .button, .status .button')
          .filter({ visible: true });
        for (const button of await bars.all())
          await expectReached(button, (await button.getAttribute('aria-label')) ?? '');
      });

    for (const [width, height] of SMALL)
      test(`no hint covers the middle of the picture at ${width} × ${height}, ${pointer}`, async ({
        page,
      }) => {
        await page.setViewportSize({ width, height });
        const editor = await Editor.open(page);
        const warp = page.locator('c2-warp');
        const free = async (name: string, isShown = true) => {
          const hint = page.locator('c2-warp .hint');
          if (isShown) await expect(hint, name).toBeVisible();
          else if (!(await hint.isVisible())) return;
          const [shown, middle] = [
            await box(hint),
            await warp.evaluate((element) => {
              const { naturalWidth, naturalHeight, imageToClient } = element as C2Warp;
              return imageToClient.call(element, [naturalWidth / 2, naturalHeight / 2]) ?? [0, 0];
            }),
          ];
          const [x, y] = middle;
          const covers = x > shown.x - 8 && x < shown.right + 8 && y > shown.y - 8 && y < shown.bottom + 8;
          expect(covers, `${name}: ${JSON.stringify(shown)} at ${middle}`).toBe(false);
          const tools = await box(page.locator('c2-warp .tools'));
          expect(shown.x >= tools.right || shown.bottom <= tools.y, `${name} beside the tools`).toBe(true);
        };
        // The hint of the page, at each handle.
        for (const id of ['head', 'left-hand', 'right-hand', 'left-foot', 'right-foot']) {
          await warp.evaluate((element, id) => element.setAttribute('hint-for', id), id);
          await free(id, false);
        }
        await warp.evaluate((element) => element.removeAttribute('hint'));
        for (const lang of ['en', 'fr', 'de']) {
          await warp.evaluate((element, lang) => element.setAttribute('lang', lang), lang);
          await expect(warp.locator('.shell')).toHaveAttribute('lang', lang);
          for (const tool of ['bar', 'polygon', 'lasso']) {
            await warp.evaluate((element, tool) => Object.assign(element, { tool }), tool);
            await free(`${tool}, ${lang}`);
          }
        }
        await warp.evaluate(async (element) => {
          const warp = element as C2Warp;
          for (const { id } of warp.project.handles) warp.removeHandle(id);
          warp.tool = 'point';
          await warp.updateComplete;
        });
        await expect(editor.handles).toHaveCount(0);
        await free('without handles');
      });
  });

test('an element with content width is visible', async ({ page }) => {
  await Editor.open(page);
  const widths = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const row = document.createElement('div');
    document.body.append(row);
    row.append(warp);
    warp.style.position = 'relative';
    const layouts = ['display: block', 'display: flex', 'display: grid; justify-items: center'];
    return ['auto', '200px'].map((width) => {
      warp.style.width = width;
      return layouts.map((layout) => {
        row.style.cssText = `width: 500px; ${layout}`;
        return warp.offsetWidth;
      });
    });
  });
  expect(widths).toEqual([
    [500, 320, 320],
    [200, 200, 200],
  ]);
});

for (const [width, height] of [
  [240, null],
  [500, null],
  [320, 320],
  [500, 360],
  [500, 420],
] as const) {
  test(`the picture is visible beside the cards at ${width} × ${height ?? 'default height'}`, async ({
    page,
  }) => {
    const editor = await Editor.open(page);
    await page.evaluate(
      ([width, height]) => {
        const frame = document.createElement('div');
        frame.style.width = `${width}px`;
        const warp = document.querySelector('c2-warp');
        if (!warp) return;
        warp.style.position = 'relative';
        warp.style.inset = 'auto';
        warp.style.height = height === null ? 'auto' : `${height}px`;
        document.body.append(frame);
        frame.append(warp);
      },
      [width, height] as const,
    );
    await expect(editor.handles).toHaveCount(5);
    const [tools, stage] = [page.locator('c2-warp .tools'), page.locator('c2-warp .stage')];
    const [zoom, room] = [await editor.zoom(), await box(stage)];
    // It fills the height, or the width of a narrow element.
    const filled = Math.max((1280 * zoom) / room.height, (1024 * zoom) / (room.right - room.x));
    expect(filled).toBeGreaterThan(0.65);
    const panel = page.getByRole('region', { name: 'Properties' });
    for (const name of ['left hand', 'head', 'left foot', 'right foot']) {
      const { x, y } = await editor.position(name);
      const card = await box(tools);
      expect(x > card.right || y < card.y, name).toBe(true);
      await page.mouse.click(x, y);
      await expect(editor.handle(name)).toHaveAttribute('aria-pressed', 'true');
      const sheet = await box(panel);
      expect(y < sheet.y || y > sheet.bottom, `${name}, with its sheet`).toBe(true);
      await page.keyboard.press('Escape');
      await expect(panel).toBeHidden();
    }
  });
}

test('draft bar and notices lie beside the cards', async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 400 });
  const editor = await Editor.open(page);
  const [tools, panel] = [page.locator('c2-warp .tools'), page.getByRole('region', { name: 'Properties' })];
  const beside = async (card: Locator) => {
    const { x, right } = await box(card);
    expect(x).toBeGreaterThanOrEqual((await box(tools)).right);
    expect(right).toBeLessThanOrEqual((await box(panel)).x);
  };
  await editor.button('Draw a polygon').click();
  const head = await editor.position('head');
  await page.mouse.click(head.x, head.y + 40);
  await beside(page.getByRole('group', { name: 'Drawing' }));
  await page.keyboard.press('Escape');
  const name = `${'a-holiday-photograph-'.repeat(6)}7.c2warp.json`;
  await editor.chooseFile({
    name,
    mimeType: 'application/json',
    buffer: Buffer.from('{"format": "c2warp/9"}'),
  });
  await expect(editor.notice).toContainText('….c2warp.json'.slice(1));
  await expect(editor.notice).toContainText('…');
  await beside(editor.notice);
});

for (const [width, height] of [
  [1000, 700],
  [1000, 350],
  [1000, 280],
  [800, 600],
  [800, 350],
] as const) {
  test(`hints are centred over the fitted picture at ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await Editor.open(page);
    const stage = await box(page.locator('c2-warp .stage'));
    const { left, right } = insetsOf({ stage, coarse: false, sheet: 'none', bare: null });
    const cards = await page.locator('c2-warp .middle').evaluate((middle) => {
      const style = getComputedStyle(middle);
      return ['--_start', '--_end'].map((name) => Number.parseFloat(style.getPropertyValue(name)));
    });
    expect(cards).toEqual([left, right]);
  });
}

test('the hint hides when its handle is out of view', async ({ page }) => {
  const editor = await Editor.open(page);
  const hint = page.getByText('Drag a hand');
  await expect(hint).toBeVisible();
  await page.keyboard.press('1');
  await page.keyboard.press('+');
  await expect(hint).toBeHidden();
  await editor.button('Fit').click();
  await expect(hint).toBeVisible();
});

test('a long list scrolls to the selection; long names wrap', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    for (let k = 0; k < 20; k++) {
      const at = [400 + 12 * k, 700] as const;
      (element as C2Warp).addHandle({ kind: 'point', id: k === 3 ? 'x'.repeat(90) : `mark-${k}`, rest: at });
    }
  });
  await expect(editor.handle('mark 19')).toBeVisible();
  await editor.handle('mark 19').click();
  const listed = page.locator('c2-warp .item').filter({ hasText: 'mark 19' });
  await expect(listed).toBeInViewport({ ratio: 1 });
  await expect(editor.field('x')).toBeInViewport({ ratio: 1 });
  const list = page.locator('c2-warp .list ul');
  expect(await list.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBe(0);
});

test('forced colours show the selection', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active', reducedMotion: 'reduce' });
  await page.goto('/');
  const editor = new Editor(page);
  await editor.ready();
  await editor.handle('head').click();
  const ground = (shown: Locator) => () =>
    shown.evaluate((element) => getComputedStyle(element).backgroundColor);
  const chosen = await page.evaluate(() => {
    document.body.style.backgroundColor = 'Highlight';
    return getComputedStyle(document.body).backgroundColor;
  });
  await expect.poll(ground(editor.button('Select and move'))).toBe(chosen);
  await expect.poll(ground(editor.button('Draw a bar'))).not.toBe(chosen);
  await expect.poll(ground(editor.button('Auto rotation'))).toBe(chosen);
  await expect.poll(ground(page.locator('c2-warp .item').filter({ hasText: 'head' }))).toBe(chosen);
  await page.locator('c2-warp summary').click();
  await expect.poll(ground(editor.button('Rigid'))).toBe(chosen);
  await expect.poll(ground(editor.button('Elastic'))).not.toBe(chosen);
  await editor.switch('Stop at folds').click();
  await expect.poll(ground(editor.switch('Stop at folds'))).toBe(chosen);
});

const BRAND = {
  '--c2-surface': '#1d1033',
  '--c2-text': '#f1e9ff',
  '--c2-accent': '#ff7ad9',
  '--c2-radius': '3px',
  '--c2-font': '"Courier New", monospace',
};

for (const theme of ['auto', 'light', 'dark'])
  test(`every surface has the colours, corners and type of the page, theme ${theme}`, async ({ page }) => {
    await page.setViewportSize({ width: 1000, height: 700 });
    const editor = await Editor.open(page);
    const warp = page.locator('c2-warp');
    await warp.evaluate(
      (element, [brand, theme]) => {
        for (const [name, value] of Object.entries(brand)) (element as C2Warp).style.setProperty(name, value);
        (element as C2Warp).theme = theme as 'auto';
      },
      [BRAND, theme] as const,
    );
    /** Surfaces of the shown state, and elements in them. */
    const look = (selectors: string) =>
      warp.evaluate((element, selectors) => {
        const shown = [...(element.shadowRoot?.querySelectorAll(selectors) ?? [])].filter((one) =>
          one.checkVisibility(),
        );
        return shown.map((one) => {
          const { backgroundColor, color, fontFamily, borderRadius } = getComputedStyle(one);
          // Of controls, those with text.
          const controls = one.querySelectorAll<HTMLElement>(
            'button, select, summary, input[type=text], input:not([type])',
          );
          const inside = [...controls].filter(
            (control) =>
              control.checkVisibility() && (control.innerText.trim() !== '' || control.matches('input')),
          );
          const type = new Set(inside.map((control) => getComputedStyle(control).fontFamily));
          const corners = inside.map((control) => Number.parseFloat(getComputedStyle(control).borderRadius));
          return {
            name: one.className,
            backgroundColor,
            color,
            type: [...new Set([fontFamily, ...type])],
            round: Math.max(Number.parseFloat(borderRadius), ...corners.filter((corner) => corner < 10)),
          };
        });
      }, selectors);
    const check = async (selectors: string) => {
      // Some surfaces are loaded at their first use.
      await expect(warp.locator(selectors).first()).toBeVisible();
      const found = await look(selectors);
      expect(found.length, selectors).toBeGreaterThan(0);
      for (const { name, round, ...rest } of found) {
        expect(rest, name).toEqual({
          backgroundColor: 'rgb(29, 16, 51)',
          // The line at the bottom is faint: a mixture of both.
          color: name === 'status' ? expect.stringContaining('0.62') : 'rgb(241, 233, 255)',
          type: ['"Courier New", monospace'],
        });
        // Round parts of controls, such as switches, stay.
        expect(round, name).toBeLessThanOrEqual(7);
      }
    };
    await check('.hint');
    await check('.top, .tools, .panel, .status');
    for (const opener of ['Open recent work', 'Export as …']) {
      await editor.button(opener).click();
      await check('.popover:popover-open');
      await page.keyboard.press('Escape');
    }
    await page.keyboard.press('?');
    await check('.keys');
    await page.keyboard.press('Escape');
    await page.locator('c2-warp .stage').click({ button: 'right', position: { x: 300, y: 20 } });
    await check('.context');
    await page.keyboard.press('Escape');
    await warp.evaluate((element) => (element as C2Warp).inform('A sentence.'));
    await check('.notice');
    await page.keyboard.press('t');
    await check('.timeline');
    await page.keyboard.press('t');
    await page.keyboard.press('i');
    await check('.study');
    await editor.button(/^(Light|Dark) colours/).hover();
    const tip = await editor.button(/^(Light|Dark) colours/).evaluate((button) => {
      const { backgroundColor, color, borderRadius } = getComputedStyle(button, '::after');
      return [backgroundColor, color, Number.parseFloat(borderRadius)];
    });
    expect(tip).toEqual(['rgb(241, 233, 255)', 'rgb(29, 16, 51)', 1.8]);
  });

test('a page overlay covers the bars and cards of the editor', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const warp = document.querySelector('c2-warp');
    if (warp) Object.assign(warp.style, { position: 'relative', inset: 'auto', height: '600px' });
    const header = document.createElement('header');
    Object.assign(header.style, { position: 'fixed', inset: '0', zIndex: '1' });
    document.body.append(header);
  });
  for (const name of ['Undo', 'Draw a bar', 'Fit']) {
    const { x, y } = await editor.centre(editor.button(name));
    const over = await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.localName, [x, y] as const);
    expect(over, name).toBe('header');
  }
});

test('the element is styled in another document, created or moved there', async ({ page }) => {
  await Editor.open(page);
  await page.evaluate(() => {
    const frame = document.createElement('iframe');
    Object.assign(frame.style, { position: 'fixed', inset: '0', width: '100%', height: '100%' });
    document.body.append(frame);
    const made = document.createElement('c2-warp');
    made.id = 'made';
    const brought = document.querySelector('c2-warp');
    for (const warp of [brought, made]) {
      if (!warp) continue;
      Object.assign(warp.style, { display: 'block', height: '48vh' });
      frame.contentDocument?.body.append(warp);
    }
  });
  const frame = page.frameLocator('iframe');
  await expect(frame.getByRole('button', { name: 'Handle left hand, ' })).toBeVisible();
  for (const shell of await frame.locator('c2-warp .shell').all())
    await expect(shell).toHaveCSS('display', /grid|flex/);
  await expect(frame.locator('#made .shell')).toBeVisible();
});

test('a readonly editor shows no drawing hint', async ({ page }) => {
  const editor = await Editor.open(page);
  // Ends the hint for first visits, which has priority.
  await editor.dragHandle('left hand', { x: 10, y: -20 });
  await page.keyboard.press('Escape');
  const hint = page.getByText('Drag to draw a bar, or click its corners');
  await page.keyboard.press('b');
  await expect(hint).toBeVisible();
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  await expect(hint).toBeHidden();
  await expect(page.locator('c2-warp .stage')).toHaveCSS('cursor', 'grab');
});
