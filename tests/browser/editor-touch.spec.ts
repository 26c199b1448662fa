/** The editor under fingers, on a phone. */
import type { CDPSession, Page } from '@playwright/test';
import { Editor, type Place } from './editor';
import { expect, test } from './fixtures';

test.use({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });

/** Fingers on the glass: one step for each list of places. */
async function touch(session: CDPSession, steps: readonly (readonly Place[])[]): Promise<void> {
  for (const [index, touchPoints] of steps.entries()) {
    const type = index === 0 ? 'touchStart' : 'touchMove';
    await session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: touchPoints.map((at, id) => ({ ...at, id })),
    });
  }
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

const fingers = (page: Page) => page.context().newCDPSession(page);
const beside = ({ x, y }: Place, dx: number, dy: number): Place => ({ x: x + dx, y: y + dy });

test('one finger drags a hand, and the sheet tells its numbers', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.place('right hand');
  await touch(await fingers(page), [[hand], [beside(hand, -10, -30)], [beside(hand, -20, -60)]]);
  await expect.poll(async () => (await editor.told('right hand')).y).toBeLessThan(420);
  await expect(page.getByRole('heading', { name: 'Right hand' })).toBeVisible();
  await expect(editor.field('y')).toBeVisible();
  await editor.button('Undo').tap();
  await expect.poll(() => editor.told('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('two fingers navigate and never edit, even where the first lies on a handle', async ({ page }) => {
  const editor = await Editor.open(page);
  const [hand, zoom] = [await editor.place('right hand'), await editor.zoom()];
  const second = beside(hand, -120, 40);
  await touch(await fingers(page), [
    [hand],
    [beside(hand, 4, -20)],
    [beside(hand, 4, -20), second],
    [beside(hand, 14, -40), beside(second, -40, 60)],
  ]);
  expect(await editor.still(() => editor.told('right hand'))).toMatchObject({ x: 900, y: 516 });
  await expect.poll(() => editor.zoom()).toBeGreaterThan(zoom * 1.2);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('a second finger takes back a handle that the first has just placed', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Add a point handle').tap();
  const belly = beside(await editor.place('head'), 0, 140);
  await touch(await fingers(page), [[belly], [belly, beside(belly, 60, 60)], [belly, beside(belly, 80, 90)]]);
  await expect(editor.handles).toHaveCount(5);
  await touch(await fingers(page), [[belly]]);
  await expect(editor.handles).toHaveCount(6);
});

test('every control is a finger wide, and tools lie at the bottom', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('head').tap();
  for (const control of await page.locator('c2-warp').locator('button:visible').all()) {
    const box = await control.boundingBox();
    const name = await control.getAttribute('aria-label');
    expect(Math.min(box?.width ?? 0, box?.height ?? 0), name ?? '').toBeGreaterThanOrEqual(44);
  }
  const tools = await page.getByRole('group', { name: 'Tools' }).boundingBox();
  expect(tools?.y).toBeGreaterThan(600);
});
