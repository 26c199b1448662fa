/** The editor under WCAG 2.2 AA: axe-core in the main states, and rules that axe cannot check. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Locator, Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor, meanDifference } from './editor';
import { expect, test } from './fixtures';

/** Each step begins in the state that the one before left. */
const STATES: Readonly<Record<string, (editor: Editor) => Promise<void>>> = {
  'a picture is open': async () => {},
  'settings are open beside a selected handle': async (editor) => {
    await editor.handle('head').focus();
    await editor.page.keyboard.press('ArrowRight');
    await editor.page.locator('c2-warp summary').click();
  },
  'a bar is selected': async (editor) => {
    await editor.page.locator('c2-warp').evaluate((element) => {
      const warp = element as C2Warp;
      const rest = [
        [420, 680],
        [350, 1000],
      ] as const;
      warp.addHandle({ kind: 'bar', id: 'leg', rest });
      warp.selection = ['leg'];
    });
    await expect(editor.corner(2, 'leg')).toBeVisible();
  },
  'a context menu is open': async (editor) => {
    await editor.corner(2, 'leg').focus();
    await editor.page.keyboard.press('ContextMenu');
    await expect(editor.page.getByRole('menu')).toBeVisible();
  },
  'a reach is shown': async (editor) => {
    // The open menu may lie over the bar.
    await editor.page.keyboard.press('Escape');
    await editor.button('Overlays').click();
    await editor.page.getByRole('checkbox', { name: 'Reach' }).click();
  },
  'creases are shown': async (editor) => {
    await editor.page.keyboard.press('Escape');
    await fold(editor);
    await editor.button(/Show the folds/).click();
  },
  'a notice is shown over a drawing': async (editor) => {
    await editor.button('Draw a bar').click();
    const head = await editor.position('head');
    await editor.page.mouse.click(head.x, head.y + 40);
    const buffer = Buffer.from('{"format": "c2warp/9"}');
    await editor.chooseFile({ name: 'newer.c2warp.json', mimeType: 'application/json', buffer });
    await expect(editor.notice).toBeVisible();
  },
  'the original is shown': async (editor) => {
    await editor.button(/compare/).evaluate((button) => (button as HTMLElement).click());
  },
  'nothing can be changed': async (editor) => {
    await editor.page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  },
};

/** Pushes the upright head below the arms, so that the picture folds. In the Rigid mode it would give way. */
const fold = (editor: Editor): Promise<void> =>
  editor.page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const { project } = warp;
    if (!project || typeof project === 'string') throw new Error('a project is open');
    const handles = project.handles.map((handle) =>
      handle.id === 'head' ? { ...handle, rotation: 0, posed: [512, 1100] } : handle,
    );
    warp.project = { ...project, pose: { ...project.pose, mode: 'harmonic' }, handles } as typeof project;
  });

/** Returns the violations that axe finds, one line per element. */
async function violations(page: Page): Promise<readonly string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(' ')}\n${failureSummary}`),
  );
}

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [width, height] of [
    [1000, 740],
    [320, 640],
  ] as const) {
    test(`axe finds no violation in ${colorScheme} colours at ${width} × ${height}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height });
      const editor = await Editor.open(page);
      for (const [name, reach] of Object.entries(STATES)) {
        if (width < 640 && name.startsWith('settings')) continue;
        await test.step(name, async () => {
          await reach(editor);
          expect(await violations(page), name).toEqual([]);
        });
      }
    });
  }
}

test('axe finds no violation on a phone with an open settings sheet', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  const editor = await Editor.open(page);
  await editor.button('Bending settings').click();
  await expect(editor.switch('Stop at folds')).toBeVisible();
  expect(await violations(page)).toEqual([]);
});

test('axe finds no violation in an empty editor and in an article', async ({ page }) => {
  await page.goto('/plain/');
  await page.evaluate(() => document.body.replaceChildren(document.createElement('c2-warp')));
  await expect(page.getByRole('button', { name: 'Open a picture', exact: true })).toBeVisible();
  expect(await new AxeBuilder({ page }).include('c2-warp').analyze()).toMatchObject({ violations: [] });
  await page.goto('/article/');
  await expect(page.getByRole('button', { name: 'Handle head, ' })).toHaveCount(2);
  expect(await new AxeBuilder({ page }).include('c2-warp').analyze()).toMatchObject({ violations: [] });
});

/** Returns the WCAG contrast ratio between the colours of two styles of one element. */
const contrast = (shown: Locator, of: keyof CSSStyleDeclaration, ground: Locator): Promise<number> =>
  ground
    .evaluateHandle((element) => getComputedStyle(element).backgroundColor)
    .then((behind) =>
      shown.evaluate(
        (element, [of, behind]) => {
          const brush = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
          const luminance = (colour: string) => {
            if (!brush) return 0;
            brush.fillStyle = colour;
            brush.fillRect(0, 0, 1, 1);
            const [r = 0, g = 0, b = 0] = [...brush.getImageData(0, 0, 1, 1).data].map((byte) =>
              byte <= 10 ? byte / 3294 : ((byte / 255 + 0.055) / 1.055) ** 2.4,
            );
            return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05;
          };
          const [a, b] = [luminance(String(getComputedStyle(element)[of])), luminance(behind)];
          return Math.max(a, b) / Math.min(a, b);
        },
        [of, behind] as const,
      ),
    );

for (const colorScheme of ['light', 'dark'] as const) {
  test(`controls contrast with their card in ${colorScheme} colours`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    const editor = await Editor.open(page);
    const card = page.getByRole('region', { name: 'Properties' });
    const guard = editor.switch('Stop at folds');
    expect(await contrast(guard, 'backgroundColor', card)).toBeGreaterThan(3);
    await editor.handle('head').focus();
    const field = page.locator('c2-warp .field').first();
    expect(await contrast(field, 'borderBottomColor', card)).toBeGreaterThan(3);
  });
}

test('animations stop within five seconds', async ({ page }) => {
  await page.goto('/');
  await new Editor(page).ready();
  const ends = await page
    .locator('c2-warp .stage')
    .evaluate((stage) =>
      stage.getAnimations({ subtree: true }).map(({ effect }) => Number(effect?.getComputedTiming().endTime)),
    );
  expect(ends).toHaveLength(5);
  expect(Math.max(...ends)).toBeLessThan(5000);
});

test('announcements appear in an existing live region', async ({ page }) => {
  const editor = await Editor.open(page);
  const region = page.locator('c2-warp .notices');
  await expect(region).toHaveAttribute('role', 'status');
  await region.evaluate((element) => element.classList.add('before'));
  await editor.handle('head').click();
  await editor.field('depth').fill('deep');
  await page.keyboard.press('Enter');
  await expect(page.locator('c2-warp .before')).toContainText('Depth: enter a number');
});

test('a notice stays while the pointer is on it', async ({ page }) => {
  await page.clock.install();
  const editor = await Editor.open(page);
  await editor.handle('head').click();
  await editor.field('depth').fill('deep');
  await page.keyboard.press('Enter');
  const notice = page.getByText('Depth: enter a number');
  await notice.hover();
  await page.clock.runFor(20_000);
  await expect(notice).toBeVisible();
  await editor.button('Fit').hover();
  await page.clock.runFor(20_000);
  await expect(notice).toBeHidden();
});

test('a fold is announced once, for any number of triangles', async ({ page }) => {
  const editor = await Editor.open(page);
  const told = page.getByRole('status').getByText('The picture has folds');
  await expect(told).toHaveCount(0);
  await fold(editor);
  await expect(page.getByRole('button', { name: /folds?\. Show the folds/ })).toBeVisible();
  await expect(told).toHaveCount(1);
});

test('a moved corner is announced instead of its bar', async ({ page }) => {
  const editor = await Editor.open(page);
  await STATES['a bar is selected']?.(editor);
  await editor.corner(2, 'leg').focus();
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('status').getByText('Corner 2 of leg: x 349, y 1000')).toBeAttached();
});

test('accessible names contain the visible labels', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').focus();
  await page.keyboard.press('ArrowRight');
  for (const field of await page.locator('c2-warp .panel .field').all()) {
    const word = (await field.locator('.label').textContent()) ?? '';
    await expect(field.getByRole('spinbutton')).toHaveAccessibleName(new RegExp(word));
  }
  await expect(page.getByRole('button', { name: 'head moved', exact: true })).toBeVisible();
  await expect(page.locator('c2-warp .shell')).toHaveAttribute('lang', 'en');
});

test('the focus ring of the stage shows on a picture that fills it', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = editor.handle('head');
  await head.focus();
  await page.keyboard.press('1');
  for (let notch = 0; notch < 3; notch++) await page.keyboard.press('+');
  const edge = async () => {
    await editor.waitFrames();
    const box = await page.locator('c2-warp .stage').boundingBox();
    return page.screenshot({ clip: { x: 0, y: (box?.y ?? 0) + 300, width: 2, height: 100 } });
  };
  const before = await edge();
  await page.keyboard.press('Shift+Tab');
  await expect(page.locator('c2-warp .stage')).toBeFocused();
  expect(meanDifference(before, await edge())).toBeGreaterThan(20);
});

test('the sheet of a small window does not cover a focused tool', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 256 });
  const editor = await Editor.open(page);
  await editor.handle('left foot').focus();
  const tool = editor.button('Select and move');
  const inFront = () =>
    tool.evaluate((button) => {
      const { x, y, width, height } = button.getBoundingClientRect();
      const root = button.getRootNode() as ShadowRoot;
      return button.contains(root.elementFromPoint(x + width / 2, y + height / 2));
    });
  await expect.poll(inFront).toBe(false);
  await tool.focus();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Tab');
  await expect(tool).toBeFocused();
  await expect.poll(inFront).toBe(true);
});

/** Returns the names of images and applications in Chromium's accessibility tree. */
async function told(page: Page): Promise<readonly string[]> {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  return nodes
    .filter(({ ignored, role }) => !ignored && /^(image|application)$/.test(String(role?.value)))
    .map(({ role, name }) => `${role?.value}: ${name?.value}`);
}

test('a disabled editor still exposes its picture', async ({ page }) => {
  await Editor.open(page);
  expect(await told(page)).toEqual(['application: Picture gingerbread.png']);
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('disabled', ''));
  await expect.poll(() => told(page)).toEqual(['image: Picture gingerbread.png, disabled']);
});

test('a picture in an article has the alternative text of its page', async ({ page }) => {
  await page.goto('/article/');
  const first = page.locator('#first');
  await expect(first.getByRole('button', { name: 'Handle head, ' })).toBeVisible();
  await first.evaluate((element) => element.setAttribute('alt', 'A figure of dough'));
  const figure = first.getByRole('application', { name: 'A figure of dough, with handles to pose it' });
  await expect(figure).toHaveAccessibleDescription(/^Arrow keys move/);
  await first.evaluate((element) => element.setAttribute('readonly', ''));
  await expect(first.getByRole('img', { name: 'A figure of dough', exact: true })).toBeVisible();
});
