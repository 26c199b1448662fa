/** Input from the moment of requesting a picture: none of it is lost, even on a slow machine. */
import type { CDPSession, Page } from '@playwright/test';
import { encode } from 'fast-png';
import type { Handle } from '../../web/src/document/project';
import { among, randomOf } from '../../web/src/editor/random';
import type { C2Warp } from '../../web/src/element';
import { Editor, type Position } from './editor';
import { expect, test } from './fixtures';

type Random = () => number;
/** Image pixels. */
type Place = readonly [number, number];

const SMALL = { width: 400, height: 300 };
/** 12 megapixels. */
const LARGE = { width: 4000, height: 3000 };

const picture = ({ width, height }: typeof SMALL) => ({
  name: `${width}.png`,
  mimeType: 'image/png',
  buffer: Buffer.from(
    encode({ width, height, channels: 3, data: new Uint8Array(3 * width * height).fill(130) }),
  ),
});

/** A key, or a click on the picture. */
type Action = string | Place;

/** What a person does, and its result. */
interface Sequence {
  readonly actions: readonly Action[];
  /** The places of all handles, in their order. */
  readonly handles: readonly (readonly Place[])[];
  readonly lasso: readonly Place[] | null;
}

/** Places in different cells of a grid, as fractions of the picture. */
function apart(count: number, random: Random): Place[] {
  const cells = Array.from({ length: 20 }, (_, cell) => ({ cell, order: random() }));
  cells.sort((a, b) => a.order - b.order);
  return cells
    .slice(0, count)
    .map(({ cell }) => [
      ((cell % 5) + 0.35 + 0.3 * random()) / 5,
      (Math.floor(cell / 5) + 0.35 + 0.3 * random()) / 4,
    ]);
}

/** The corners of a ring around the middle. */
function ring(random: Random): Place[] {
  const count = 4 + Math.floor(3 * random());
  return Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * (k + 0.4 * random())) / count;
    return [0.5 + 0.36 * Math.cos(angle), 0.5 + 0.36 * Math.sin(angle)];
  });
}

function sequence(random: Random): Sequence {
  const kind = among(['points', 'lasso', 'lines'] as const, random);
  if (kind === 'lasso') {
    const lasso = ring(random);
    return { actions: ['l', ...lasso, 'Enter'], handles: [], lasso };
  }
  if (kind === 'points') {
    const places = apart(3 + Math.floor(6 * random()), random);
    return { actions: ['p', ...places], handles: places.map((place) => [place]), lasso: null };
  }
  const polygon = ring(random);
  const [a = [0, 0], b = [0, 0]] = apart(2, random);
  return { actions: ['g', ...polygon, 'Enter', 'b', a, b, 'Enter'], handles: [polygon, [a, b]], lasso: null };
}

const VIRTUAL: Readonly<Record<string, number>> = { Enter: 13 };

/** Sends input without waiting for its effect, as hands do. */
class Hands {
  readonly #page: Page;
  readonly #session: CDPSession;
  readonly #sent: Promise<unknown>[] = [];

  constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async of(page: Page): Promise<Hands> {
    const session = await page.context().newCDPSession(page);
    await session.send('Emulation.setCPUThrottlingRate', { rate: 6 });
    return new Hands(page, session);
  }

  async do(actions: readonly Action[], onPage: (place: Place) => Position, random: Random): Promise<void> {
    for (const action of actions) {
      if (random() < 0.3) await this.#page.evaluate(() => new Promise(requestAnimationFrame));
      if (typeof action === 'string') this.#press(action);
      else this.#click(onPage(action));
    }
    await Promise.all(this.#sent.splice(0));
  }

  #press(key: string): void {
    const code = key.length === 1 ? `Key${key.toUpperCase()}` : key;
    const text = key === 'Enter' ? '\r' : key;
    const windowsVirtualKeyCode = VIRTUAL[key] ?? key.toUpperCase().charCodeAt(0);
    const event = { key, code, text, windowsVirtualKeyCode };
    this.#sent.push(this.#session.send('Input.dispatchKeyEvent', { type: 'keyDown', ...event }));
    this.#sent.push(this.#session.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event }));
  }

  #click(at: Position): void {
    for (const type of ['mouseMoved', 'mousePressed', 'mouseReleased'] as const) {
      const button = type === 'mouseMoved' ? ('none' as const) : ('left' as const);
      const buttons = type === 'mousePressed' ? 1 : 0;
      this.#sent.push(
        this.#session.send('Input.dispatchMouseEvent', { type, ...at, button, buttons, clickCount: 1 }),
      );
    }
  }
}

/** The map from fractions of the open picture to the page. */
async function pageMap(page: Page): Promise<(place: Place) => Position> {
  const [from, to] = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const { width, height } = warp.project.image;
    return [warp.imageToClient([0, 0]) ?? [0, 0], warp.imageToClient([width, height]) ?? [0, 0]] as const;
  });
  return ([x, y]) => ({ x: from[0] + x * (to[0] - from[0]), y: from[1] + y * (to[1] - from[1]) });
}

const project = (page: Page) => page.locator('c2-warp').evaluate((element) => (element as C2Warp).project);

const placesOf = ({ kind, posed }: Handle): readonly Place[] => (kind === 'point' ? [posed] : posed);

/** Returns the maximum distance between found and wanted places, or infinity if their numbers differ. */
function farthest(found: readonly Place[], wanted: readonly Place[]): number {
  if (found.length !== wanted.length) return Number.POSITIVE_INFINITY;
  return Math.max(
    0,
    ...found.map(([x, y], k) => Math.hypot(x - (wanted[k]?.[0] ?? 0), y - (wanted[k]?.[1] ?? 0))),
  );
}

/** The corners of a ring around a middle, wherever the ring begins. */
const around = (corners: readonly Place[], [x, y]: Place): readonly Place[] =>
  corners.toSorted((a, b) => Math.atan2(a[1] - y, a[0] - x) - Math.atan2(b[1] - y, b[0] - x));

/** Waits until the open picture has all of a sequence, each place within a pixel of the screen. */
async function expectMade(page: Page, { width, height }: typeof SMALL, made: Sequence): Promise<void> {
  const middle: Place = [width / 2, height / 2];
  const inImage = (places: readonly Place[]) => places.map(([x, y]): Place => [x * width, y * height]);
  const lasso = made.lasso ? [around(inImage(made.lasso), middle)] : [];
  const wanted = [...made.handles.map(inImage), ...lasso];
  const found = async () => {
    const { image, handles, domain } = await project(page);
    const rings = domain?.kind === 'polygon' ? domain.rings.map((ring) => around(ring, middle)) : [];
    const lines = [...handles.map(placesOf), ...rings];
    const far = Math.max(0, ...lines.map((line, k) => farthest(line, wanted[k] ?? [])));
    return { src: image.src, lines: lines.map(({ length }) => length), far: far > width / 300 };
  };
  const lines = wanted.map(({ length }) => length);
  await expect.poll(found).toEqual({ src: `${width}.png`, lines, far: false });
}

/** `npm run test:long` has all sequences of a group. */
const OF_GROUP = process.env.LONG_TESTS ? 10 : 2;

for (const group of [0, 1, 2, 3, 4]) {
  test(`nothing is lost while a picture is opened, random sequences of group ${group + 1}`, async ({
    page,
  }) => {
    test.slow();
    const editor = await Editor.open(page);
    await editor.chooseFile(picture(SMALL));
    await expect(editor.solved).toContainText('400 × 300 px');
    const onPage = await pageMap(page);
    const hands = await Hands.of(page);
    for (let seed = 10 * group; seed < 10 * group + OF_GROUP; seed++) {
      const random = randomOf(seed);
      const made = sequence(random);
      await editor.chooseFile(picture(SMALL));
      await test.step(`seed ${seed}`, async () => {
        await hands.do(made.actions, onPage, random);
        await expectMade(page, SMALL, made);
      });
    }
  });
}

test('nothing is lost while a picture of 12 megapixels is opened', async ({ page }) => {
  const editor = await Editor.open(page);
  const large = picture(LARGE);
  await editor.chooseFile(large);
  await expect(editor.solved).toContainText('4000 × 3000 px');
  const onPage = await pageMap(page);
  const hands = await Hands.of(page);
  const lasso: Place[] = [
    [0.2, 0.2],
    [0.8, 0.25],
    [0.7, 0.8],
    [0.3, 0.7],
  ];
  await editor.chooseFile(large);
  await hands.do(['l', ...lasso, 'Enter'], onPage, randomOf(1));
  await expectMade(page, LARGE, { actions: [], handles: [], lasso });
});

/** The bars of the project: the places of their ends, as fractions of the picture. */
const bars = async (page: Page): Promise<readonly (readonly Place[])[]> => {
  const { handles, image } = await project(page);
  return handles
    .filter(({ kind }) => kind === 'bar')
    .map((bar) => placesOf(bar).map(([x, y]): Place => [x / image.width, y / image.height]));
};

test('nothing is lost while the page opens its picture, or stored work', async ({ page }) => {
  const editor = await Editor.open(page);
  const onPage = await pageMap(page);
  const hands = await Hands.of(page);
  const stage = page.locator('c2-warp .stage');
  const first: Place[] = [
    [0.45, 0.5],
    [0.55, 0.6],
  ];
  const second: Place[] = [
    [0.42, 0.68],
    [0.5, 0.75],
  ];
  await page.goto('/', { waitUntil: 'commit' });
  await stage.waitFor();
  await hands.do(['b', ...first, 'Enter'], onPage, randomOf(7));
  await editor.ready();
  await expect.poll(async () => farthest((await bars(page))[0] ?? [], first)).toBeLessThan(0.01);
  await editor.dragHandle('right hand', { x: 0, y: -30 });
  await expect.poll(async () => (await editor.storedWork()).step).toBe('Move right hand');
  await page.reload({ waitUntil: 'commit' });
  await stage.waitFor();
  await hands.do(['b', ...second, 'Enter'], onPage, randomOf(8));
  await expect.poll(async () => farthest((await bars(page))[1] ?? [], second)).toBeLessThan(0.01);
});
