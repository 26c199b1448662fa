/** `<c2-warp>` plays the clips of its project, with the words and events of media elements. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const warp = (page: Page) => page.locator('c2-warp');

/** Opens the sample with a clip in which the right hand rises. */
async function open(page: Page): Promise<Editor> {
  const editor = await Editor.open(page);
  await warp(page).evaluate((element) => {
    const warp = element as C2Warp;
    const keys = [
      { time: 0, posed: [900, 516] as const },
      { time: 1, posed: [860, 250] as const },
    ];
    const clips = [
      { name: 'rise', duration: 1, loop: 'none' as const, tracks: [{ handle: 'right-hand', keys }] },
    ];
    warp.project = { ...warp.project, clips };
    const heard: string[] = [];
    for (const type of ['play', 'pause', 'timeupdate', 'ended'])
      warp.addEventListener(type, () => heard.push(type));
    Object.assign(window, { heard });
  });
  return editor;
}

const heard = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => (window as unknown as { heard: string[] }).heard);
const read = <T extends 'paused' | 'ended' | 'currentTime' | 'duration'>(page: Page, name: T) =>
  warp(page).evaluate((element, name) => (element as C2Warp)[name], name);

test('a clip plays to its end, and tells of it', async ({ page }) => {
  const editor = await open(page);
  expect([await read(page, 'paused'), await read(page, 'duration')]).toEqual([true, 1]);
  await warp(page).evaluate((element) => (element as C2Warp).play());
  await expect.poll(() => read(page, 'ended')).toBe(true);
  expect([await read(page, 'paused'), await read(page, 'currentTime')]).toEqual([true, 1]);
  await expect.poll(async () => (await editor.shownPose('right hand')).y).toBe(250);
  const types = await heard(page);
  expect(types[0]).toBe('play');
  expect(types.slice(-3)).toEqual(['timeupdate', 'pause', 'ended']);
  // The file rests, and nothing is to be undone but the clip itself.
  expect(await editor.projectHandle('right-hand')).toMatchObject({ posed: [900, 516] });
  await expect(editor.button('Undo: set project')).toBeEnabled();
});

test('a time can be shown, and an unknown clip is rejected', async ({ page }) => {
  const editor = await open(page);
  await warp(page).evaluate((element) => {
    (element as C2Warp).currentTime = 0.5;
  });
  await expect.poll(async () => Math.round((await editor.shownPose('right hand')).y)).toBe(383);
  const refused = await warp(page).evaluate(async (element) => {
    const warp = element as C2Warp;
    warp.clip = 'jump';
    await warp.updateComplete;
    return warp.play().catch((error: Error) => error.message);
  });
  expect(refused).toBe('there is no clip "jump"');
  expect(await read(page, 'duration')).toBeNaN();
});

test('a handle that is taken while a clip plays eases back, and is no step', async ({ page }) => {
  const editor = await open(page);
  await warp(page).evaluate(async (element) => {
    const warp = element as C2Warp;
    warp.loop = true;
    warp.posable = true;
    await warp.updateComplete;
    await warp.play();
  });
  const at = await editor.position('left hand');
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x, at.y - 20);
  await page.mouse.move(at.x, at.y - 60);
  await expect.poll(async () => (await editor.shownPose('left hand')).y).toBeLessThan(500);
  const before = await read(page, 'currentTime');
  await expect.poll(() => read(page, 'currentTime')).not.toBe(before);
  expect((await editor.shownPose('left hand')).y).toBeLessThan(500);
  await page.mouse.up();
  await expect.poll(async () => (await editor.shownPose('left hand')).y).toBe(516);
  expect(await read(page, 'paused')).toBe(false);
  await warp(page).evaluate((element) => (element as C2Warp).pause());
  expect(await editor.projectHandle('left-hand')).toMatchObject({ posed: [124, 516] });
});

test('out of sight time stands still', async ({ page }) => {
  await open(page);
  await warp(page).evaluate(async (element) => {
    const warp = element as C2Warp;
    warp.loop = true;
    await warp.updateComplete;
    await warp.play();
  });
  await expect.poll(() => read(page, 'currentTime')).toBeGreaterThan(0);
  await page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync('c2-warp { position: absolute; top: 5000px; height: 400px; }');
    document.adoptedStyleSheets = [sheet];
  });
  const frames = () =>
    page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  // The element learns of it with a later frame.
  await expect
    .poll(async () => {
      const before = await read(page, 'currentTime');
      await frames();
      await frames();
      return (await read(page, 'currentTime')) === before;
    })
    .toBe(true);
});

test('an element with autoplay starts to play, unless people prefer reduced motion', async ({ page }) => {
  for (const reducedMotion of ['no-preference', 'reduce'] as const) {
    await open(page);
    await page.emulateMedia({ reducedMotion });
    const loaded = warp(page).evaluate(async (element) => {
      const warp = element as C2Warp;
      const { project } = warp;
      const other = document.createElement('c2-warp') as C2Warp;
      Object.assign(other, { autoplay: true, loop: true, id: 'other' });
      const load = new Promise((done) => other.addEventListener('load', done, { once: true }));
      warp.replaceWith(other);
      await other.updateComplete;
      await other.load('samples/gingerbread.png', project);
      await load;
    });
    await loaded;
    const paused = () => page.locator('#other').evaluate((element) => (element as C2Warp).paused);
    await expect.poll(paused).toBe(reducedMotion === 'reduce');
  }
});
