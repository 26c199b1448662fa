/** The shape in which a drag has left the picture: the project keeps it. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Around an arm, to a place below it. The straight way there leads elsewhere. */
const AROUND = [
  [512, 260],
  [750, 150],
  [850, 620],
  [512, 620],
] as const;

type Point = readonly [number, number];

/** The way in moves as short as those of a hand. */
const way = AROUND.flatMap(([x, y], k): readonly Point[] => {
  const [toX, toY] = AROUND[k + 1] ?? [x, y];
  const steps = k + 1 < AROUND.length ? 12 : 1;
  return Array.from({ length: steps }, (_, step) => [
    x + ((toX - x) * step) / steps,
    y + ((toY - y) * step) / steps,
  ]);
});

/** The posed places of a grid over the picture. */
const posedGrid = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => {
    const places = Array.from({ length: 500 }, (_, k) => [50 * (k % 20) + 25, 50 * Math.floor(k / 20) + 25]);
    return places.map((place) => (element as C2Warp).mapPoint(place as [number, number]));
  });

type Grid = Awaited<ReturnType<typeof posedGrid>>;

const farthest = (a: Grid, b: Grid): number =>
  Math.max(
    ...a.map((p, k) => Math.hypot((p?.[0] ?? 0) - (b[k]?.[0] ?? 0), (p?.[1] ?? 0) - (b[k]?.[1] ?? 0))),
  );

const samples = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.shape?.length ?? 0);

test('a picture opens in the shape that a drag left, and undo and redo restore it', async ({ page }) => {
  const editor = await Editor.open(page);
  const rest = await posedGrid(page);
  await editor.dragAlong(way);
  await expect.poll(() => samples(page)).toBeGreaterThan(10);
  const left = await editor.settled(() => posedGrid(page));
  const away = async (from: Grid) => farthest(from, await posedGrid(page));

  await page.keyboard.press('Control+z');
  await expect.poll(() => away(rest)).toBeLessThan(0.25);
  expect(await samples(page)).toBe(0);
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => away(left)).toBeLessThan(0.25);

  await expect.poll(async () => (await editor.storedWork()).step).toBe('Move head');
  await page.reload();
  await editor.ready();
  await expect.poll(() => samples(page)).toBeGreaterThan(10);
  await expect.poll(() => away(left)).toBeLessThan(0.25);

  // Without its shape, the project is elsewhere.
  await page.locator('c2-warp').evaluate((element) => {
    const { shape: _, ...plain } = (element as C2Warp).project;
    (element as C2Warp).project = plain;
  });
  await expect.poll(() => away(left)).toBeGreaterThan(5);
});
