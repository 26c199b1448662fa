/** The live figures of "The method explained": they answer pointers and keys, with the numbers of the core. */
import AxeBuilder from '@axe-core/playwright';
import type { Locator, Page } from '@playwright/test';
import { HANDLES, projectOf } from '../../web/site/figures/parts/handles';
import { SIZE } from '../../web/site/figures/parts/sizes';
import type * as Core from '../../web/src/core';
import { expect, test } from './fixtures';
import { BUILD_MS, openPage } from './site';

const PAGE = '/site/explained/';
/** In the order of the page. */
const FIGURES = ['distance', 'cells', 'insertion', 'basis', 'weights', 'modes'] as const;

test.describe.configure({ timeout: BUILD_MS + 120_000 });

/** Scrolls to a figure and waits until its controls exist. */
async function shown(page: Page, name: (typeof FIGURES)[number]): Promise<Locator> {
  const figure = page.locator('.live-figure').nth(FIGURES.indexOf(name));
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.locator('.panel')).toBeVisible();
  return figure;
}

async function opened(page: Page, name: (typeof FIGURES)[number]): Promise<Locator> {
  await openPage(page, PAGE);
  return shown(page, name);
}

const point = (figure: Locator, name: string | RegExp): Locator => figure.getByRole('button', { name });

/** The place of a point, in pixels of the picture. Style sheets keep six digits. */
const placeOf = (handle: Locator): Promise<readonly [number, number]> =>
  handle.evaluate(({ style }, { width, height }) => {
    const pixels = (text: string, size: number) =>
      Math.round(1000 * ((Number.parseFloat(text) * size) / 100)) / 1000;
    return [pixels(style.left, width), pixels(style.top, height)] as const;
  }, SIZE);

/** Drags a point with the mouse, by CSS pixels. */
async function drag(handle: Locator, dx: number, dy: number): Promise<void> {
  await handle.scrollIntoViewIfNeeded();
  const { x, y, width, height } = (await handle.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const { mouse } = handle.page();
  await mouse.move(x + width / 2, y + height / 2);
  await mouse.down();
  await mouse.move(x + width / 2 + dx, y + height / 2 + dy, { steps: 4 });
  await mouse.up();
}

/** The numbers of a figure, from the top. */
const numbers = (figure: Locator): Promise<readonly string[]> => figure.locator('dd').allTextContents();

/** The picture of a figure. */
const drawing = (figure: Locator): Promise<string> =>
  figure
    .locator('.board canvas')
    .first()
    .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

interface Asking {
  /** The core's warper of a page, opened once. */
  asking?: Promise<Core.Warper>;
}

/** The answers of the core about a project and a point. */
function core(page: Page, project: object, at: readonly [number, number] = [0, 0], from = at) {
  return page.evaluate(
    async ({ project, at, from, size }) => {
      const open = async () => {
        const { createWarper }: typeof Core = await import(`${location.origin}/site/core/core.js`);
        const image = new Image();
        image.src = '/site/samples/gingerbread.svg';
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), size);
        // As the figures do: graphics hardware draws other edges.
        const context = canvas.getContext('2d', { willReadFrequently: true });
        context?.drawImage(image, 0, 0, size.width, size.height);
        return createWarper(context?.getImageData(0, 0, size.width, size.height) as ImageData);
      };
      const page = globalThis as Asking;
      page.asking ??= open();
      const solution = await (await page.asking).solve(project);
      const { sites, rounds } = await solution.study();
      const weights = await solution.weights(Float64Array.from(at));
      const distances = from === at ? [] : await solution.distances(from, Float64Array.from(at));
      const { virtual_sites, folded_triangles } = solution.report;
      return {
        sites,
        rounds: rounds.length,
        distance: distances[0] ?? Number.NaN,
        weights: Array.from(weights.sites, (site, entry) => ({
          handle: sites[site]?.handle ?? -1,
          weight: weights.weights[entry] ?? 0,
        })),
        virtual: virtual_sites,
        folds: folded_triangles,
      };
    },
    { project, at, from, size: SIZE },
  );
}

const pixels = (length: number | null | undefined): string => `${Math.round(length ?? Number.NaN)} px`;

test('the distance figure measures the path between two points that are dragged', async ({ page }) => {
  const figure = await opened(page, 'distance');
  const [start, end] = [point(figure, /^Start/), point(figure, /^End/)];
  const agrees = async () => {
    const [from, to] = [await placeOf(start), await placeOf(end)];
    const { distance } = await core(page, { samples: 500 }, to, from);
    const straight = Math.hypot(to[0] - from[0], to[1] - from[1]);
    expect(distance).toBeGreaterThan(straight);
    const expected = [pixels(distance), pixels(straight), (distance / straight).toFixed(2)];
    await expect.poll(() => numbers(figure)).toEqual(expected);
    return expected;
  };
  const before = await agrees();
  await drag(end, 120, -20);
  const dragged = await agrees();
  expect(dragged).not.toEqual(before);
  await start.press('ArrowDown');
  await start.press('Shift+ArrowLeft');
  expect(await agrees()).not.toEqual(dragged);
  // Outside of the shape, the point stays at the rim.
  await drag(end, 0, 400);
  await agrees();
  const circled = await drawing(figure);
  await figure.getByRole('checkbox').uncheck();
  await expect.poll(() => drawing(figure)).not.toBe(circled);
});

test('the figure of cells has the radii of the core, and tells when equation 3 fails', async ({ page }) => {
  const figure = await opened(page, 'cells');
  const { sites, virtual } = await core(page, projectOf(HANDLES));
  // Otherwise the cells of the core are not those of the handles alone.
  expect(virtual).toBe(0);
  const radii = (handle: number) => {
    const site = sites.find((site) => site.handle === handle);
    return [pixels(site?.cell_radius), pixels(site?.separation)];
  };
  await expect.poll(() => numbers(figure)).toEqual(radii(0));
  await expect(figure.getByText('Equation 3 holds for the head')).toBeVisible();
  const foot = point(figure, 'left foot');
  await foot.focus();
  await expect.poll(() => numbers(figure)).toEqual(radii(3));
  await expect(foot).toHaveAttribute('aria-pressed', 'true');
  const before = await drawing(figure);
  await drag(point(figure, 'right hand'), -90, -40);
  await expect(figure.getByText('Equation 3 fails for the right hand')).toBeVisible();
  expect(await drawing(figure)).not.toBe(before);
});

test('Algorithm 1 goes step by step to the virtual handles of the core', async ({ page }) => {
  const figure = await opened(page, 'insertion');
  const [back, next] = [
    figure.getByRole('button', { name: 'Back' }),
    figure.getByRole('button', { name: 'Next' }),
  ];
  const [slider, step] = [figure.getByRole('slider'), figure.getByRole('status').last()];
  const count = figure.locator('output');
  const solved = async () =>
    core(
      page,
      projectOf([
        { id: 'first', at: await placeOf(point(figure, /first/)) },
        { id: 'second', at: await placeOf(point(figure, /second/)) },
      ]),
    );
  const { rounds, virtual } = await solved();
  await expect(count).toHaveText(`1 of ${rounds}`);
  await expect(back).toHaveAttribute('aria-disabled', 'true');
  await next.click();
  await next.press('Enter');
  await expect(count).toHaveText(`3 of ${rounds}`);
  await back.click();
  await expect(count).toHaveText(`2 of ${rounds}`);
  await expect(step).toContainText('Score');
  const early = await drawing(figure);
  await slider.press('End');
  await expect(step).toHaveText(
    `Done: ${virtual} virtual handles. Each cell is small enough for its support.`,
  );
  await expect(next).toHaveAttribute('aria-disabled', 'true');
  expect(await drawing(figure)).not.toBe(early);
  await drag(point(figure, /second/), 20, 60);
  const apart = await solved();
  expect(apart.rounds).toBeLessThan(rounds);
  await slider.press('End');
  await expect(count).toHaveText(`${apart.rounds} of ${apart.rounds}`);
  await expect(step).toContainText(`Done: ${apart.virtual} virtual`);
});

test('degree and shape factor change the curve and the weight', async ({ page }) => {
  const figure = await opened(page, 'basis');
  const [degree, alpha] = [figure.getByLabel('Degree n'), figure.getByLabel('Shape factor α')];
  const agrees = async (degree: number, shape_factor: number) => {
    const { sites } = await core(page, projectOf(HANDLES, { weighting: { degree, shape_factor } }));
    const head = sites.find(({ handle }) => handle === 0);
    const lengths = [head?.cell_radius, head?.support_radius, head?.separation];
    await expect.poll(() => numbers(figure)).toEqual(lengths.map(pixels));
  };
  await agrees(5, 1);
  const before = await drawing(figure);
  await degree.press('End');
  await expect.poll(() => drawing(figure)).not.toBe(before);
  const steep = await drawing(figure);
  for (let k = 0; k < 10; k++) await alpha.press('ArrowLeft');
  await expect(figure.locator('output')).toHaveText(['20', '0.50']);
  await agrees(20, 0.5);
  await expect.poll(() => drawing(figure)).not.toBe(steep);
});

test('all weights at a point are those of the core, and sum to one', async ({ page }) => {
  const figure = await opened(page, 'weights');
  const probe = point(figure, /^Point/);
  const handles = [...HANDLES, { id: 'left elbow', at: [140, 268] }] as const;
  const agrees = async () => {
    const { weights } = await core(page, projectOf(handles), await placeOf(probe));
    const of = (handle: number) =>
      weights.filter((entry) => entry.handle === handle).reduce((sum, { weight }) => sum + weight, 0);
    const parts = [...handles.map((_, handle) => of(handle)), of(-1), 1];
    await expect.poll(() => numbers(figure)).toEqual(parts.map((part) => part.toFixed(3)));
    return parts;
  };
  await agrees();
  await drag(probe, -20, -15);
  expect((await agrees())[5]).toBeGreaterThan(0.1);
  const elbow = await drawing(figure);
  await figure.getByRole('radio', { name: 'Head' }).check();
  await expect.poll(() => drawing(figure)).not.toBe(elbow);
  await probe.press('Shift+ArrowUp');
  await agrees();
});

test('one drag of a hand is posed by both modes, with the folds that the core counts', async ({ page }) => {
  const figure = await opened(page, 'modes');
  const hands = [point(figure, /The paper/), point(figure, /Rigid/)];
  const agrees = async () => {
    const posed = await placeOf(hands[0] as Locator);
    expect(await placeOf(hands[1] as Locator)).toEqual(posed);
    const expected: string[] = [];
    for (const mode of ['harmonic', 'rigid']) {
      const handles = projectOf(HANDLES).handles?.map((handle) => ({
        ...handle,
        rotation: mode === 'rigid' ? 'auto' : 0,
        ...(handle.id === 'right hand' && { posed }),
      }));
      const pose = { mode, density: 150 };
      const project = { ...projectOf(HANDLES), weighting: { support: 'smooth' }, pose, handles };
      expected.push(String((await core(page, project)).folds));
    }
    await expect.poll(() => numbers(figure)).toEqual(expected);
    return expected.map(Number);
  };
  const [paper = 0, rigid = 0] = await agrees();
  expect(paper).toBeGreaterThan(10 * rigid);
  const before = await drawing(figure);
  await drag(hands[1] as Locator, 40, 60);
  await agrees();
  await expect.poll(() => drawing(figure)).not.toBe(before);
});

test('the figures suit axe in both themes, and fit a narrow screen', async ({ page }) => {
  await openPage(page, PAGE);
  for (const name of FIGURES) await shown(page, name);
  const figure = await shown(page, 'weights');
  await expect.poll(async () => (await numbers(figure)).at(-1)).toBe('1.000');
  const light = await drawing(figure);
  const moving = () =>
    page.evaluate(() => document.getAnimations().filter((one) => one instanceof CSSTransition).length);
  const suits = async () => {
    // Colours on their way from one theme to the other fit neither.
    await expect.poll(moving).toBe(0);
    const { violations } = await new AxeBuilder({ page }).include('main').analyze();
    expect(violations.map(({ id, nodes }) => [id, nodes.map(({ target }) => target)])).toEqual([]);
  };
  await suits();
  await page.emulateMedia({ colorScheme: 'dark' });
  await expect.poll(() => drawing(figure)).not.toBe(light);
  await suits();
  await page.setViewportSize({ width: 320, height: 640 });
  const beyond = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  await expect.poll(beyond).toBeLessThanOrEqual(0);
});

test('without WebAssembly the figures say so, and their texts stay', async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'WebAssembly'));
  await openPage(page, PAGE);
  const figure = page.locator('.live-figure').first();
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.getByRole('status')).toHaveText(/this browser has no WebAssembly/);
  await expect(figure.getByText('lines of equal distance')).toBeVisible();
});
