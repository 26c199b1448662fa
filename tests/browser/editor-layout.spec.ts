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
