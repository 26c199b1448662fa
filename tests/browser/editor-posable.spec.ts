/** `<c2-warp posable>` in an article: readers pose the existing handles, and all other input belongs to the page. */
import type { Locator, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position, type ShownPose } from './editor';
import { send, touch } from './fingers';
import { expect, test } from './fixtures';

/** One of the two rigs of the article. */
class Rig {
  readonly element: Locator;
  readonly stage: Locator;
  readonly settled: Editor['settled'];

  constructor(page: Page, id: 'first' | 'second' = 'first') {
    const editor = new Editor(page);
    this.settled = (ask) => editor.settled(ask);
    this.element = page.locator(`#${id}`);
    this.stage = this.element.locator('.stage');
  }

  /** The article, with both rigs solved and the first in view. */
  static async open(page: Page): Promise<Rig> {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto('/article/');
    // Adopted, since the policy of the page forbids style elements.
    await page.evaluate(() => {
      const column = new CSSStyleSheet();
      column.replaceSync('body { max-width: 600px; margin: 0 auto } c2-warp { width: 340px }');
      document.adoptedStyleSheets = [column];
      Object.assign(globalThis, { left: [] });
      // Events that nobody has prevented by now belong to the page.
      for (const type of ['keydown', 'wheel', 'contextmenu', 'dragover', 'drop', 'paste', 'touchstart'])
        document.addEventListener(
          type,
          (event) => !event.defaultPrevented && Reflect.get(globalThis, 'left').push(type),
        );
    });
    const rig = new Rig(page);
    for (const id of ['first', 'second'] as const) await new Rig(page, id).solved();
    await rig.element.evaluate((element) => element.scrollIntoView({ block: 'center' }));
    return rig;
  }

  async solved(): Promise<void> {
    const belly = () => this.element.evaluate((element) => (element as C2Warp).mapPoint([512, 700]));
    await expect.poll(belly).not.toBeNull();
    await expect(this.handle('head')).toBeVisible();
  }

  handle(name: string): Locator {
    return this.element.getByRole('button', { name: `Handle ${name}, ` });
  }

  get handles(): Locator {
    return this.element.getByRole('group', { name: 'Handles' }).getByRole('button');
  }

  async shownPose(name: string): Promise<ShownPose> {
    const label = (await this.handle(name).getAttribute('aria-label')) ?? '';
    const number = (word: string) => Number(label.match(new RegExp(`${word} (-?[\\d.]+)`))?.[1]);
    return { x: number('x'), y: number('y'), rotation: number('rotation') };
  }

  async position(name: string): Promise<Position> {
    const box = await this.handle(name).boundingBox();
    if (!box) throw new Error(`${name} is not shown`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  set(properties: Partial<C2Warp>): Promise<void> {
    return this.element.evaluate((element, properties) => {
      Object.assign(element, properties);
      return (element as C2Warp).updateComplete.then(() => undefined);
    }, properties as object);
  }

  project(): Promise<string> {
    return this.element.evaluate((element) => JSON.stringify((element as C2Warp).project));
  }

  selection(): Promise<readonly string[]> {
    return this.element.evaluate((element) => (element as C2Warp).selection);
  }
}

const scrolled = (page: Page) => page.evaluate(() => Math.round(scrollY));

/** Returns the events that reached the page since the last call. */
const left = (page: Page) => page.evaluate(() => (Reflect.get(globalThis, 'left') as string[]).splice(0));

const by = ({ x, y }: Position, dx: number, dy: number): Position => ({ x: x + dx, y: y + dy });

async function drag(page: Page, from: Position, to: Position): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
}

/** A point on the stage beside the figure, without handles. */
const beside = async (rig: Rig) => by(await rig.position('head'), 110, 0);

/** Waits two frames: one to pose, one to show. */
const drawn = (page: Page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

test('a rig shows picture and handles only, with the picture’s height', async ({ page }) => {
  const rig = await Rig.open(page);
  await expect(rig.element.getByRole('button')).toHaveCount(5);
  await expect(rig.element.locator('.top, .tools, .panel, .status, .draft-bar, .notice')).toHaveCount(0);
  await expect(rig.stage).toHaveAccessibleName('Picture gingerbread.png, with handles to pose it');
  const { width, height } = (await rig.element.boundingBox()) ?? { width: 0, height: 0 };
  expect(height).toBeCloseTo((width * 1280) / 1024, 0);
  const grounds = await rig.stage.evaluate((stage) => {
    const host = (stage.getRootNode() as ShadowRoot).host;
    return [getComputedStyle(host).backgroundColor, getComputedStyle(stage).backgroundColor];
  });
  expect(grounds).toEqual(['rgba(0, 0, 0, 0)', 'rgba(0, 0, 0, 0)']);
  await expect(rig.element.getByText('Drag a hand')).toBeVisible();
  await expect(page.locator('#second .hint')).toHaveCount(0);
  await page.locator('#second').evaluate((element: HTMLElement) => {
    element.style.height = '200px';
  });
  await expect.poll(async () => (await page.locator('#second').boundingBox())?.height).toBe(200);
});

test('a hand can be dragged, turned, nudged and undone', async ({ page }) => {
  const rig = await Rig.open(page);
  const second = await new Rig(page, 'second').project();
  const hand = await rig.position('right hand');
  await drag(page, hand, by(hand, -10, -40));
  const raised = await rig.shownPose('right hand');
  expect(raised.y).toBeLessThan(450);
  await expect(rig.handle('right hand')).toBeFocused();
  await expect(rig.element.getByText('Drag a hand')).toBeHidden();
  // No mark of the rest position: only the editor shows it.
  await expect(rig.element.locator('.rest')).toHaveCount(0);

  const now = await rig.position('right hand');
  await drag(page, by(now, 0, 40), by(now, -40, 0));
  const turned = await rig.shownPose('right hand');
  expect(Math.abs(turned.rotation - raised.rotation)).toBeGreaterThan(60);

  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Shift+.');
  expect(await rig.shownPose('right hand')).toMatchObject({
    x: turned.x - 1,
    rotation: turned.rotation + 15,
  });
  for (let k = 0; k < 4; k++) await page.keyboard.press('ControlOrMeta+z');
  expect(await rig.shownPose('right hand')).toEqual({ x: 900, y: 516, rotation: 0 });
  await page.keyboard.press('ControlOrMeta+Shift+z');
  expect(await rig.shownPose('right hand')).toEqual(raised);
  await rig.handle('right hand').click();
  await page.keyboard.press('r');
  expect(await rig.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
  expect(await new Rig(page, 'second').project()).toBe(second);
});

test('a handle dragged out of view is fitted; undo restores the size', async ({ page }) => {
  const rig = await Rig.open(page);
  const [hand, foot] = [await rig.position('right hand'), await rig.position('left foot')];
  await drag(page, hand, by(hand, 150, -60));
  const box = await rig.element.boundingBox();
  const right = (box?.x ?? 0) + (box?.width ?? 0);
  await expect.poll(async () => (await rig.position('right hand')).x).toBeLessThan(right - 10);
  await page.keyboard.press('ControlOrMeta+z');
  await expect.poll(() => rig.position('left foot')).toEqual(foot);
});

test('the wheel scrolls the page, also with Ctrl, and the view stays', async ({ page }) => {
  const rig = await Rig.open(page);
  const before = await scrolled(page);
  const [head, hand] = [await rig.position('head'), await rig.position('right hand')];
  await page.mouse.move(head.x, head.y);
  await page.mouse.wheel(0, 120);
  await expect.poll(() => scrolled(page)).toBe(before + 120);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -2);
  await page.keyboard.up('Control');
  expect((await left(page)).filter((type) => type === 'wheel')).toHaveLength(2);
  await expect
    .poll(async () => (await rig.position('right hand')).y + (await scrolled(page)))
    .toBeCloseTo(hand.y + before, 0);
});

test('a press beside the handles deselects; drag and menu are the page’s', async ({ page }) => {
  const rig = await Rig.open(page);
  const empty = await beside(rig);
  await rig.handle('head').click();
  expect(await rig.selection()).toEqual(['head']);
  const project = await rig.project();
  await drag(page, empty, by(empty, -120, 200));
  await expect(rig.element.locator('.box')).toHaveCount(0);
  expect(await rig.selection()).toEqual(['head']);
  await page.mouse.click(empty.x, empty.y);
  await expect.poll(() => rig.selection()).toEqual([]);
  const hand = await rig.position('right hand');
  await left(page);
  await page.mouse.click(empty.x, empty.y, { button: 'right' });
  expect(await left(page)).toContain('contextmenu');
  await page.mouse.move(empty.x, empty.y);
  await page.mouse.down({ button: 'middle' });
  await page.mouse.move(empty.x, empty.y + 20);
  await page.mouse.up({ button: 'middle' });
  expect(await rig.position('right hand')).toEqual(hand);
  expect(await rig.project()).toBe(project);
});

test('a right click on a handle opens the menu; keys open none elsewhere', async ({ page }) => {
  const rig = await Rig.open(page);
  const at = await rig.position('right hand');
  await drag(page, at, by(at, 0, -20));
  await expect.poll(async () => (await rig.shownPose('right hand')).y).toBeLessThan(516);
  const hand = await rig.position('right hand');
  await left(page);
  await page.mouse.click(hand.x, hand.y, { button: 'right' });
  await expect(page.getByRole('menuitem')).toHaveText([/Reset\s+R/, /Reset all/, /Undo/, /Redo/]);
  await page.getByRole('menuitem', { name: 'Reset', exact: true }).click();
  await expect.poll(async () => (await rig.shownPose('right hand')).y).toBe(516);
  expect(await left(page)).not.toContain('contextmenu');
  await rig.stage.focus();
  await page.keyboard.press('Shift+F10');
  await expect(page.getByRole('menu')).toHaveCount(0);
});

test('nothing is placed, drawn, deleted or reordered with any tool', async ({ page }) => {
  const rig = await Rig.open(page);
  await rig.set({ tool: 'point' });
  await rig.element.evaluate((element) => {
    const ends = [
      [440, 800],
      [590, 800],
    ] as const;
    (element as C2Warp).addHandle({ id: 'belt', kind: 'bar', rest: ends, posed: ends });
  });
  await expect(rig.handle('belt')).toBeAttached();
  const project = await rig.project();
  const belly = await rig.position('belt');
  await page.mouse.dblclick(belly.x - 12, belly.y);
  await page.mouse.click(belly.x, belly.y - 60);
  await rig.handle('head').click();
  await left(page);
  const keys = ['v', 'p', 'b', 'g', 'h', 'c', 'x', '[', ']', '0', '1', '+', '-', 'Delete', 'Backspace'];
  for (const key of keys) await page.keyboard.press(key);
  // Prevents the browser's own shortcuts during the test.
  await page.evaluate(() => addEventListener('keydown', (event) => event.preventDefault()));
  for (const key of ['o', 's', 'e', 'p']) await page.keyboard.press(`Control+${key}`);
  const pressed = (await left(page)).filter((type) => type === 'keydown');
  // Four combinations, each with the key of Ctrl itself.
  expect(pressed).toHaveLength(keys.length + 8);
  expect(await rig.project()).toBe(project);

  const files = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    data.items.add(new File(['no picture'], 'other.png', { type: 'image/png' }));
    return data;
  });
  for (const type of ['dragover', 'drop'])
    await rig.stage.dispatchEvent(type, { dataTransfer: files, bubbles: true, composed: true });
  await rig.stage.evaluate((stage, clipboardData) => {
    const paste = { clipboardData, bubbles: true, composed: true, cancelable: true };
    stage.dispatchEvent(new ClipboardEvent('paste', paste));
  }, files);
  expect(await left(page)).toEqual(['dragover', 'drop', 'paste']);
  await expect(rig.element).not.toHaveClass(/dropping/);
  expect(await rig.project()).toBe(project);
});

test('Tab passes through the handles, and unused keys scroll the page', async ({ page }) => {
  const rig = await Rig.open(page);
  await page.evaluate(() => scrollTo(0, 0));
  await page.keyboard.press('Tab');
  await expect(rig.handle('head')).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowDown');
  expect(await rig.shownPose('head')).toMatchObject({ x: 513, y: 270 });
  const [before, ring] = [await scrolled(page), rig.element.locator('.ring')];
  await page.keyboard.press('Space');
  await expect(ring).toHaveCount(0);
  await page.keyboard.press('Space');
  await expect(ring).toHaveCount(1);
  await page.keyboard.press('ControlOrMeta+z');
  await page.keyboard.press('ControlOrMeta+z');
  expect(await rig.shownPose('head')).toMatchObject({ x: 512, y: 260 });
  await page.keyboard.press('ControlOrMeta+a');
  expect(await rig.selection()).toHaveLength(5);
  await page.keyboard.down('o');
  await expect(rig.element.getByText('Original')).toBeVisible();
  await page.keyboard.up('o');
  await page.keyboard.press('Escape');
  expect(await rig.selection()).toEqual([]);
  expect(await scrolled(page)).toBe(before);
  await left(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('.');
  expect((await left(page)).filter((type) => type === 'keydown')).toHaveLength(3);
  const pressed = async (key: string) => {
    await page.keyboard.press(key);
    return scrolled(page);
  };
  // A busy Chromium sometimes misses a scroll by a short key press.
  await expect.poll(() => pressed('ArrowDown')).toBeGreaterThan(before);
  for (let k = 0; k < 5; k++) await page.keyboard.press('Tab');
  await expect(new Rig(page, 'second').handle('head')).toBeFocused();

  const empty = await beside(new Rig(page, 'second'));
  await page.mouse.click(empty.x, empty.y);
  const at = await scrolled(page);
  await expect.poll(() => pressed('Shift+Space')).toBeLessThan(at - 100);
});

test('switching `posable` during a drag reverts the drag', async ({ page }) => {
  const rig = await Rig.open(page);
  const tools = rig.element.locator('.tools');
  await rig.set({ tool: 'point' });
  for (const posable of [false, true, false]) {
    // The last drag may have ended over a tool, whose tooltip would cover the hand.
    await page.mouse.move(1, 1);
    const hand = await rig.position('left hand');
    await page.mouse.move(hand.x, hand.y);
    await page.mouse.down();
    await page.mouse.move(hand.x, hand.y - 30, { steps: 3 });
    await expect.poll(async () => (await rig.shownPose('left hand')).y).toBeLessThan(500);
    await rig.set({ posable });
    await page.mouse.move(hand.x, hand.y - 60, { steps: 3 });
    await page.mouse.up();
    await drawn(page);
    expect(await rig.shownPose('left hand')).toMatchObject({ x: 124, y: 516 });
    if (posable) await expect(tools).toHaveCount(0);
    else await expect(tools).toBeVisible();
  }
  // The tool of the attribute is selected again.
  await expect(rig.element.getByRole('button', { name: 'Add a point handle' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await expect(rig.element.getByRole('button', { name: 'Undo' }).first()).toBeDisabled();
});

test('overlays and drafts of the editor are hidden in a posable picture', async ({ page }) => {
  const rig = await Rig.open(page);
  await rig.set({ posable: false });
  await rig.element.evaluate((element: HTMLElement) => {
    element.style.width = '800px';
    element.style.height = '560px';
  });
  await rig.element.scrollIntoViewIfNeeded();
  const belly = by(await rig.position('head'), 0, 120);
  await page.mouse.move(belly.x, belly.y);
  await page.mouse.wheel(0, 60);
  await rig.handle('head').click();
  await page.keyboard.press('g');
  await page.mouse.click(belly.x, belly.y);
  await expect(rig.element.locator('.draft')).toHaveCount(1);
  await rig.set({ posable: true });
  await expect(rig.element.locator('.draft, .draft-bar, .hint:not(.bubble)')).toHaveCount(0);
  const { x, y, width, height } = (await rig.element.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const scale = (height - 32) / 1280;
  const head = await rig.position('head');
  expect(head.x).toBeCloseTo(x + width / 2, 0);
  expect(head.y).toBeCloseTo(y + 16 + 260 * scale, 0);
});

test('a readonly rig is an image that only the page poses', async ({ page }) => {
  const rig = await Rig.open(page);
  const label = page.getByRole('img', { name: 'Picture gingerbread.png' });
  await rig.element.evaluate((element) => {
    (element as C2Warp).selection = ['head'];
  });
  await rig.set({ readonly: true });
  await expect(rig.element.getByRole('button')).toHaveCount(0);
  await expect(rig.element.locator('.ring, .hint')).toHaveCount(0);
  await expect(label).toBeVisible();
  const box = (await rig.element.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const before = await rig.project();
  const at = { x: box.x + (box.width * 900) / 1024, y: box.y + (box.height * 516) / 1280 };
  await drag(page, at, by(at, 0, -40));
  await page.mouse.click(at.x, at.y);
  expect(await rig.stage.evaluate((stage) => stage.style.cursor)).toBe('default');
  await left(page);
  for (const key of ['ArrowUp', '.', 'r', 'o', 'Escape', ' ']) await page.keyboard.press(key);
  expect((await left(page)).filter((type) => type === 'keydown')).toHaveLength(6);
  expect(await rig.project()).toBe(before);
  expect(await rig.selection()).toEqual(['head']);
  const posed = await rig.element.evaluate((element) => {
    const warp = element as C2Warp;
    warp.updateHandle('right-hand', { posed: [880, 400] });
    warp.fit();
    return warp.mapPoint([900, 516]);
  });
  expect(posed?.map(Math.round)).toEqual([880, 400]);
  await rig.set({ readonly: false });
  await expect(rig.handles).toHaveCount(5);
});

test('the page opens another picture, and errors are shown', async ({ page }) => {
  const rig = await Rig.open(page);
  const refused = await rig.element.evaluate((element) => {
    const project = { format: 'c2warp/1', image: { src: '', width: 5, height: 5 }, handles: [] } as const;
    return (element as C2Warp).load('/samples/gingerbread.png', project).catch((error) => error.code);
  });
  expect(refused).toBe('image-size');
  await rig.element.evaluate((element) => {
    (element as C2Warp).addHandle({ kind: 'point', rest: [512, 260.001] });
  });
  await expect(rig.element.getByRole('alert')).toContainText('handle-1');
  await rig.element.getByRole('button', { name: 'Dismiss' }).click();
  await expect(rig.element.getByRole('alert')).toHaveCount(0);
  await rig.element.evaluate((element) => (element as C2Warp).load('/samples/gingerbread.png'));
  await expect(rig.element.getByRole('button')).toHaveCount(0);
  await expect(rig.element.locator('.hint')).toHaveCount(0);
});

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });

  const upwards = (from: Position) => [0, -20, -40, -60, -80, -100].map((dy) => [by(from, 0, dy)]);

  test('a finger beside the handles scrolls the page, one on a handle drags it', async ({ page }) => {
    const rig = await Rig.open(page);
    const fingers = await page.context().newCDPSession(page);
    await rig.handle('head').tap();
    await expect.poll(() => rig.selection()).toEqual(['head']);
    const [before, project] = [await scrolled(page), await rig.project()];
    await touch(fingers, upwards(await beside(rig)));
    await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 50);
    expect(await rig.project()).toBe(project);
    expect(await rig.selection()).toEqual(['head']);

    // Waits until the view stops: it follows the dragged handle.
    const { settled } = rig;
    const at = await settled(() => scrolled(page));
    await touch(fingers, upwards(await settled(() => rig.position('right hand'))));
    await expect.poll(async () => (await rig.shownPose('right hand')).y).toBeLessThan(350);
    expect(await scrolled(page)).toBe(at);
    expect(await rig.selection()).toEqual(['right-hand']);
    // Dragged by the ring, away from its buttons.
    const hand = await settled(() => rig.position('right hand'));
    const turned = (await rig.shownPose('right hand')).rotation;
    await touch(fingers, [[by(hand, -52, 0)], [by(hand, -40, 34)], [by(hand, -10, 52)], [by(hand, 0, 52)]]);
    await expect
      .poll(async () => Math.abs((await rig.shownPose('right hand')).rotation - turned))
      .toBeGreaterThan(40);
    expect(await scrolled(page)).toBe(at);

    const empty = await settled(() => beside(rig));
    await page.touchscreen.tap(empty.x, empty.y);
    await expect.poll(() => rig.selection()).toEqual([]);
  });

  test('a long press on a handle opens the menu and does not scroll the page', async ({ page }) => {
    const rig = await Rig.open(page);
    const fingers = await page.context().newCDPSession(page);
    const at = await rig.settled(() => rig.position('right hand'));
    await send(fingers, 'Start', [at]);
    await expect(page.getByRole('menu')).toHaveAccessibleName('right hand');
    await send(fingers, 'End');
    await expect(page.getByRole('menuitem', { name: 'Reset', exact: true })).toBeDisabled();
    const before = await scrolled(page);
    await touch(fingers, upwards(await beside(rig)));
    await expect(page.getByRole('menu')).toHaveCount(0);
    await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 50);
  });

  test('two fingers belong to the page, and revert the drag of the first', async ({ page }) => {
    const rig = await Rig.open(page);
    const fingers = await page.context().newCDPSession(page);
    const project = await rig.project();
    const hand = await rig.position('right hand');
    const second = by(hand, -120, 100);
    await touch(fingers, [
      [hand],
      [by(hand, -4, -30)],
      [by(hand, -4, -30), second],
      [by(hand, -14, -60), by(second, -20, 40)],
    ]);
    await drawn(page);
    expect(await rig.project()).toBe(project);
    expect(await page.evaluate(() => visualViewport?.scale)).toBe(1);

    const empty = await beside(rig);
    // Chromium recognizes a pinch only if the fingers are some way apart.
    const [a, b] = [by(empty, 0, -60), by(empty, 0, 200)];
    await touch(fingers, [[a, b], ...[15, 30, 45, 60].map((d) => [by(a, 0, -d), by(b, 0, d)])]);
    await expect.poll(() => page.evaluate(() => visualViewport?.scale ?? 1)).toBeGreaterThan(1.2);
    expect(await rig.project()).toBe(project);
  });
});
