/** A page script that poses the handles in every frame, alone and during edits. */
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';

test('a pose set by the page shows without a step, event or announcement', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('head', { x: 10, y: -20 });
  await editor.button('Undo: move head').click();
  const spoken = page.locator('c2-warp .spoken[aria-live]');
  const before = await editor.settled(() => spoken.textContent());
  const results = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const heard: string[] = [];
    for (const type of ['input', 'change', 'selectionchange', 'historychange', 'error'])
      warp.addEventListener(type, () => heard.push(type));
    const places = [];
    for (let frame = 0; frame < 3; frame++) {
      warp.pose([
        { id: 'left-hand', posed: [130, 500 - 40 * frame] },
        { id: 'right-hand', posed: [890, 500 - 40 * frame], rotation: 5 * frame },
      ]);
      places.push(warp.mapPoint([900, 516])?.map(Math.round));
    }
    // The handles of a project are a valid pose.
    const { handles } = warp.project;
    warp.pose([{ id: 'left-hand', posed: [0, 0] }]);
    warp.pose(handles);
    return { heard, places, posed: warp.project.handles.slice(1, 3).map(({ posed }) => posed) };
  });
  expect(results).toEqual({
    heard: [],
    places: [
      [890, 500],
      [890, 460],
      [890, 420],
    ],
    posed: [
      [130, 420],
      [890, 420],
    ],
  });
  await expect.poll(() => editor.shownPose('right hand')).toEqual({ x: 890, y: 420, rotation: 10 });
  expect(await spoken.textContent()).toBe(before);
  await expect(editor.button('Undo')).toBeDisabled();
  await expect(editor.button('Redo: move head')).toBeEnabled();
});

test('an invalid pose is rejected and poses no handle', async ({ page }) => {
  await Editor.open(page);
  const refusals = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const [before, good] = [JSON.stringify(warp.project), { id: 'head', posed: [500, 250] as const }];
    const tries = [
      () => warp.pose([good, { id: 'nobody' }]),
      () => warp.pose([good, { id: 'left-hand', posed: [Number.NaN, 1] }]),
      () => warp.pose([good, { id: 'left-hand', rest: [130, 520] }]),
      () => warp.pose([good, { id: 'left-hand', kind: 'bar' } as never]),
      () => warp.pose({ head: good } as never),
    ];
    const messages = tries.map((attempt) => {
      try {
        attempt();
        return 'taken';
      } catch (error) {
        return String(error);
      }
    });
    return [...messages, JSON.stringify(warp.project) === before];
  });
  expect(refusals).toEqual([
    'RangeError: there is no handle "nobody"',
    'RangeError: handle "left-hand", posed: expected a point [x, y]',
    'RangeError: handle "left-hand", rest: cannot be changed',
    expect.stringContaining('RangeError: handle "left-hand", rest: expected'),
    'TypeError: pose: expected a list of handles',
    true,
  ]);
});

test('a drag works and can be undone while the page poses all handles', async ({ page }) => {
  const editor = await Editor.open(page);
  const head = await editor.position('head');
  const frames = async (from: number) => {
    for (let frame = from; frame < from + 5; frame++) {
      await page.locator('c2-warp').evaluate((element, frame) => {
        (element as C2Warp).pose([
          { id: 'head', posed: [512, 260] },
          { id: 'right-hand', posed: [900, 500 - 10 * frame] },
        ]);
      }, frame);
      await editor.waitFrames();
    }
  };
  await page.mouse.move(head.x, head.y);
  await page.mouse.down();
  await frames(0);
  await page.mouse.move(head.x + 10, head.y - 10);
  await frames(5);
  await page.mouse.move(head.x + 20, head.y - 20);
  const held = await editor.settled(() => editor.shownPose('head'));
  expect(held.x).toBeGreaterThan(515);
  expect(held.y).toBeLessThan(257);
  expect(await editor.shownPose('right hand')).toMatchObject({ x: 900, y: 410 });
  await page.mouse.up();
  await expect.poll(() => editor.shownPose('head')).toEqual(held);
  expect(await editor.shownPose('right hand')).toMatchObject({ x: 900, y: 410 });
  await editor.button('Undo: move head').click();
  await expect.poll(() => editor.shownPose('head')).toMatchObject({ x: 512, y: 260 });
  expect(await editor.shownPose('right hand')).toMatchObject({ x: 900, y: 410 });
  await expect(editor.button('Undo')).toBeDisabled();
});

test('window and picture coordinates convert both ways in a scaled editor', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const transform of ['none', 'scale(0.5)']) {
    await page.locator('c2-warp').evaluate((element, transform) => {
      Object.assign(element.style, { transform, transformOrigin: '20px 30px' });
    }, transform);
    const hand = await editor.settled(() => editor.position('right hand'));
    const { image, client } = await page.locator('c2-warp').evaluate((element, { x, y }) => {
      const warp = element as C2Warp;
      return { image: warp.clientToImage([x, y]), client: warp.imageToClient([900, 516]) };
    }, hand);
    expect(Math.hypot((image?.[0] ?? 0) - 900, (image?.[1] ?? 0) - 516)).toBeLessThan(1);
    expect(Math.hypot((client?.[0] ?? 0) - hand.x, (client?.[1] ?? 0) - hand.y)).toBeLessThan(0.5);
  }
  const none = await page.evaluate(() => {
    const warp = document.createElement('c2-warp');
    document.body.append(warp);
    const places = [warp.clientToImage([0, 0]), warp.imageToClient([0, 0])];
    warp.remove();
    return places;
  });
  expect(none).toEqual([null, null]);
});

test('an export has the pose at the time of the call', async ({ page }) => {
  await Editor.open(page);
  const apart = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const frames = [516, 400, 516].map((y) => {
      warp.pose([{ id: 'left-hand', posed: [124, y] }]);
      return warp.toBlob({ scale: 0.1 });
    });
    const [first, second, third] = await Promise.all(
      frames.map(async (frame) => String(new Uint8Array(await (await frame).arrayBuffer()))),
    );
    return { second: first === second, third: first === third };
  });
  expect(apart).toEqual({ second: false, third: true });
});

test('an editor out of view draws its pose when it is back in view', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  const before = await editor.screenshot(hand);
  const shown = (top: string) =>
    page.locator('c2-warp').evaluate((element, top) => Object.assign(element.style, { top }), top);
  const drawn = (frames: number) =>
    page.locator('c2-warp').evaluate(async (element, frames) => {
      const canvas = element.shadowRoot?.querySelector('canvas');
      const gl = canvas?.getContext('webgl2');
      if (!gl) return -1;
      let count = 0;
      const draw = gl.drawElements;
      gl.drawElements = (...args) => {
        count += 1;
        draw.apply(gl, args);
      };
      for (let frame = 1; frame <= frames; frame++) {
        (element as C2Warp).pose([{ id: 'right-hand', posed: [900, 516 - 10 * frame] }]);
        await new Promise(requestAnimationFrame);
        await new Promise(requestAnimationFrame);
      }
      gl.drawElements = draw;
      return count;
    }, frames);
  await page.locator('c2-warp').evaluate((element) => Object.assign(element.style, { position: 'relative' }));
  await shown('3000px');
  await editor.waitFrames();
  expect(await drawn(10)).toBe(0);
  await shown('0px');
  await expect.poll(async () => (await editor.screenshot(hand)).equals(before)).toBe(false);
  expect(await drawn(2)).toBeGreaterThan(0);
});
