/** `<c2-warp>` on other pages: attributes, methods, events, and the release of resources. */
import type { Locator, Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { C2Warp, ProjectFile } from '../../web/src/element';
import { bytes, Editor, meanDifference, type Position } from './editor';
import { expect, test } from './fixtures';
import { denyPictureWorker } from './picture_worker';
import { WorkerReplies } from './worker_replies';

/** Returns the mean of red minus blue in a part of the drawing, in 255ths. */
function warmth(png: Buffer): number {
  const { data, width, height, channels } = decode(png);
  let sum = 0;
  for (let at = 0; at < data.length; at += channels) sum += (data[at] ?? 0) - (data[at + 2] ?? 0);
  return sum / (width * height);
}

test('events: input during a drag, change on commit, selection, history', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    const heard: string[] = [];
    Object.assign(globalThis, { heard });
    for (const type of ['input', 'change', 'selectionchange', 'historychange']) {
      element.addEventListener(type, () => heard.push(type));
    }
  });
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const heard = async () => {
    const all = await page.evaluate(() => Reflect.get(globalThis, 'heard') as string[]);
    return all.filter((type, k) => type !== all[k - 1]);
  };
  await expect.poll(heard).toEqual(['selectionchange', 'input', 'historychange', 'input', 'change']);
});

test('only input and change bubble, as with form controls', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const heard: string[] = [];
    Object.assign(globalThis, { heard });
    for (const type of ['ready', 'load', 'input', 'change', 'selectionchange', 'historychange', 'error'])
      document.body.addEventListener(type, ({ target }) =>
        heard.push(`${type} ${(target as Element).localName}`),
      );
  });
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const heard = () => page.evaluate(() => [...new Set(Reflect.get(globalThis, 'heard') as string[])]);
  await expect.poll(heard).toEqual(['input c2-warp', 'change c2-warp']);
});

test('methods have the same effects as tools', async ({ page }) => {
  const editor = await Editor.open(page);
  const results = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const id = warp.addHandle({ kind: 'point', rest: [512, 700], posed: [512, 700] });
    warp.updateHandle('head', { rotation: 20 });
    const handles = warp.project.handles.map((handle) => handle.id);
    warp.undo();
    warp.removeHandle(id);
    warp.selection = ['head'];
    const png = await warp.toBlob({ scale: 0.25 });
    const { width, height } = await createImageBitmap(png);
    warp.updateHandle('right-hand', { posed: [1200, 516] });
    const canvas = await warp.toCanvas({ scale: 0.25 });
    const alpha = canvas.getContext('2d')?.getImageData(128, 65, 1, 1).data[3];
    const grown = await createImageBitmap(await warp.toBlob({ scale: 0.25, grow: true }));
    warp.undo();
    return {
      id,
      handles,
      selection: warp.selection,
      size: [width, height],
      canvas: [canvas.width, canvas.height, alpha],
      grown: [grown.width > 256 + 40, grown.height],
      left: warp.project.handles.length,
    };
  });
  expect(results).toEqual({
    id: 'handle-1',
    handles: ['head', 'left-hand', 'right-hand', 'left-foot', 'right-foot', 'handle-1'],
    selection: ['head'],
    size: [256, 320],
    canvas: [256, 320, 255],
    grown: [true, 320],
    left: 5,
  });
  await expect.poll(async () => (await editor.shownPose('head')).rotation).toBe(0);
});

test('invalid handles throw at once and add no step', async ({ page }) => {
  await Editor.open(page);
  const refusals = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const tries = [
      () => warp.updateHandle('nobody', { scale: 2 }),
      () => warp.removeHandle('nobody'),
      () => warp.updateHandle('head', { scale: -1 }),
      () => warp.updateHandle('head', { depth: 1e300 }),
      () => warp.updateHandle('head', { id: 'left-hand' } as object),
      () => warp.updateHandle('head', { posed: [Number.NaN, 1] }),
      () => warp.addHandle({ id: 'head', kind: 'point', rest: [512, 700] }),
      () => warp.addHandle({ id: 'bar', kind: 'bar', rest: [[512, 700]] }),
      () => warp.addHandle({ id: 5, kind: 'point', rest: [512, 700] } as never),
      () => {
        warp.project = { ...warp.project, pose: { mode: 'bogus' as 'rigid' } };
      },
      () => {
        warp.project = { ...warp.project, handles: [{ id: 'a', kind: 'circle' } as never] };
      },
    ];
    return tries.map((attempt) => {
      try {
        attempt();
        return 'taken';
      } catch (error) {
        return error instanceof RangeError ? error.message : String(error);
      }
    });
  });
  expect(refusals).toEqual([
    'there is no handle "nobody"',
    'there is no handle "nobody"',
    'handle "head", scale: expected a number above 0 and below 1000000000000',
    'handle "head", depth: expected a number above -1000000000000 and below 1000000000000',
    'handle "head", id: cannot be changed',
    'handle "head", posed: expected a point [x, y]',
    'a handle "head" exists already',
    'handle "bar", rest: expected 2 points or more [x, y]',
    'handle "5", id: expected a name',
    'C2WarpError: pose.mode: expected "harmonic" or "rigid", found "bogus"',
    expect.stringContaining('C2WarpError: handles[0].kind: expected'),
  ]);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('mapPoint returns the posed position of a point', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.handle('right hand').click();
  await editor.field('y').fill('400');
  await editor.field('y').press('Enter');
  const mapped = (x: number, y: number) =>
    page
      .locator('c2-warp')
      .evaluate((element, point) => (element as C2Warp).mapPoint(point), [x, y] as const);
  await expect.poll(async () => (await mapped(900, 516))?.[0]).toBeCloseTo(900, 0);
  await expect.poll(async () => (await mapped(900, 516))?.[1]).toBeCloseTo(400, 0);
  expect(await mapped(5, 5)).toBeNull();
});

test('rejected input reaches the page as an error with a code', async ({ page }) => {
  const editor = await Editor.open(page);
  const code = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    return warp.load(new Blob([])).then(
      () => 'none',
      (error) => error.code,
    );
  });
  expect(code).toBe('picture');
  await expect(editor.handles).toHaveCount(5);
});

test('removal releases the context; reinsertion restores the document', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  const told = await editor.settled(() => editor.shownPose('right hand'));
  const lost = await page.locator('c2-warp').evaluate(async (element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    const context = canvas?.getContext('webgl2');
    element.remove();
    await new Promise((done) => setTimeout(done, 50));
    document.body.append(element);
    return context?.isContextLost();
  });
  expect(lost).toBe(true);
  await expect(editor.handles).toHaveCount(5);
  await expect.poll(() => editor.shownPose('right hand')).toEqual(told);
  await editor.button('Undo: move right hand').click();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('elements that are created and removed leave no resources', async ({ page }) => {
  await Editor.open(page);
  // One solver, and for the whole page one reader of pictures and one PNG writer.
  await expect.poll(() => page.workers().length).toBe(3);
  await page.evaluate(async () => {
    const gone: WeakRef<Element>[] = [];
    for (let k = 0; k < 5; k++) {
      const warp = Object.assign(document.createElement('c2-warp'), { src: '/samples/gingerbread.png' });
      document.body.append(warp);
      await new Promise((ready) => warp.addEventListener('ready', ready));
      warp.remove();
      gone.push(new WeakRef(warp));
    }
    Object.assign(globalThis, { gone });
  });
  const left = async () => {
    await page.requestGC();
    return page.evaluate(
      () => (Reflect.get(globalThis, 'gone') as WeakRef<Element>[]).filter((ref) => ref.deref()).length,
    );
  };
  await expect.poll(left).toBe(0);
  await expect.poll(() => page.workers().length).toBe(3);
});

test('removal while a picture opens closes both pictures', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  // Otherwise a worker makes the bitmaps, out of reach of the test.
  await denyPictureWorker(page);
  await page.addInitScript(() => {
    const opened: ImageBitmap[] = [];
    const create = globalThis.createImageBitmap.bind(globalThis) as (blob: Blob) => Promise<ImageBitmap>;
    Object.assign(globalThis, {
      opened,
      createImageBitmap: async (...given: Parameters<typeof create>) => {
        const bitmap = await create(...given);
        opened.push(bitmap);
        return bitmap;
      },
    });
  });
  const editor = await Editor.open(page);
  await replies.hold();
  const open = () =>
    page.evaluate(
      () => (Reflect.get(globalThis, 'opened') as ImageBitmap[]).filter(({ width }) => width > 0).length,
    );
  await page.locator('c2-warp').evaluate((element) => {
    void (element as C2Warp).load('/samples/gingerbread.png').catch(() => {});
  });
  await expect(editor.handles).toHaveCount(0);
  expect(await open()).toBe(2);
  await page.locator('c2-warp').evaluate((element) => element.remove());
  await expect.poll(open).toBe(0);
});

test('every element in view is drawn and posed, of many on a page', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.evaluate(() => {
    const project = (document.querySelector('c2-warp') as C2Warp).project;
    document.body.replaceChildren(
      ...Array.from({ length: 20 }, () => {
        const warp = document.createElement('c2-warp') as C2Warp;
        Object.assign(warp.style, { position: 'relative', display: 'block', height: '600px' });
        Object.assign(warp, { readonly: true, src: '/samples/gingerbread.png', project });
        return warp;
      }),
    );
    Object.assign(document.documentElement.style, { height: 'auto', overflow: 'auto' });
    Object.assign(document.body.style, { height: 'auto', overflow: 'visible', display: 'block' });
  });
  const all = page.locator('c2-warp');
  for (const at of [19, 0, 10, 19]) {
    const warp = all.nth(at);
    await warp.scrollIntoViewIfNeeded();
    await expect(warp.locator('.solved')).toContainText('mesh point', { timeout: 60_000 });
    const middle = await editor.centre(warp);
    // The gingerbread is brown; without a context the area is grey.
    await expect.poll(async () => warmth(await editor.screenshot(middle, 4))).toBeGreaterThan(40);
  }
  // All are in view at once, and one of the last is posed.
  await page.evaluate(() => {
    for (const warp of document.querySelectorAll<C2Warp>('c2-warp')) {
      Object.assign(warp, { readonly: false, posable: true });
      Object.assign(warp.style, { float: 'left', width: '150px', height: '150px' });
    }
  });
  const hand = all.nth(17).getByRole('button', { name: 'Handle right hand' });
  const before = await editor.centre(hand);
  await page.mouse.move(before.x, before.y);
  await page.mouse.down();
  await page.mouse.move(before.x, before.y - 40, { steps: 4 });
  await page.mouse.up();
  for (const warp of await all.all()) {
    const middle = await editor.centre(warp);
    await expect.poll(async () => warmth(await editor.screenshot(middle, 4))).toBeGreaterThan(40);
  }
  const raised = { x: before.x, y: before.y - 40 };
  await expect.poll(async () => warmth(await editor.screenshot(raised, 3))).toBeGreaterThan(40);
});

test('a change listener can remove the element', async ({ page }) => {
  await Editor.open(page);
  const left = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.addEventListener('change', () => warp.remove());
    warp.updateHandle('head', { rotation: 10 });
    return document.querySelectorAll('c2-warp').length;
  });
  expect(left).toBe(0);
});

test('the tool attribute applies after a move and when readonly ends', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  const pressed = page.locator('.tools [aria-pressed=true]');
  await warp.evaluate((element) => Object.assign(element, { readonly: true, tool: 'point' }));
  await expect(pressed).not.toHaveAccessibleName(/point/);
  await warp.evaluate((element) => Object.assign(element, { readonly: false }));
  await expect(pressed).toHaveAccessibleName(/point/);
  await warp.evaluate((element) => document.body.append(element));
  await editor.ready();
  await expect(pressed).toHaveAccessibleName(/point/);
});

test('a readonly editor pans and zooms, and changes nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('readonly', ''));
  const hand = await editor.position('right hand');
  await editor.dragHandle('right hand', { x: 20, y: -40 });
  expect(await editor.settled(() => editor.shownPose('right hand'))).toMatchObject({ x: 900, y: 516 });
  await expect.poll(async () => (await editor.position('right hand')).y).toBeCloseTo(hand.y - 40, 0);
  await page.keyboard.press('Delete');
  await expect(editor.handles).toHaveCount(5);
});

test('a rejected handle is named, and removed from document and history', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ kind: 'point', rest: [512, 260.001], posed: [30, 30] });
  });
  await expect(editor.notice).toContainText('handle 1');
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Redo')).toBeDisabled();
  await editor.button('Undo: move right hand').click();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
});

test('of several changes by the page only rejected handles are reverted', async ({ page }) => {
  const editor = await Editor.open(page);
  const told = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const told: string[] = [];
    warp.addEventListener('error', (event) => {
      const { code, handles } = (event as Event as CustomEvent).detail;
      told.push(`${code}: ${handles}`);
    });
    warp.addEventListener('change', (event) => {
      const { handles } = (event as CustomEvent<{ project: C2Warp['project'] }>).detail.project;
      told.push(handles.map(({ id }) => id).join(' '));
    });
    warp.updateHandle('head', { rest: [5, 5] });
    warp.addHandle({ id: 'stray', kind: 'point', rest: [124, 516.001] });
    warp.addHandle({ id: 'heart', kind: 'point', rest: [512, 600] });
    warp.addHandle({ id: 'twin', kind: 'point', rest: [512, 600.001] });
    warp.updateHandle('left-hand', { posed: [150, 420] });
    told.length = 0;
    await new Promise<void>((done) => {
      warp.addEventListener('error', () => told.filter((line) => line.includes(':')).length === 3 && done());
    });
    return told;
  });
  const sample = 'head left-hand right-hand left-foot right-foot';
  expect(told).toEqual([
    `${sample} stray heart twin`,
    'handle-outside: head',
    `${sample} heart twin`,
    'handles-too-close: left-hand,stray',
    `${sample} heart`,
    'handles-too-close: heart,twin',
  ]);
  await expect(editor.handles).toHaveCount(6);
  expect(await editor.projectHandle('head')).toMatchObject({ rest: [512, 260], posed: [512, 260] });
  await expect.poll(async () => (await editor.mapped(512, 600))?.length).toBe(2);
  await editor.button('Undo: change handle').click();
  await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 124, y: 516 });
  await editor.button('Undo: add handle').click();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('reverting a rejected handle does not end the drag of another', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await replies.hold();
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ id: 'stray', kind: 'point', rest: [512, 260.001] });
  });
  const hand = await editor.position('right hand');
  await page.mouse.move(hand.x, hand.y);
  await page.mouse.down();
  await page.mouse.move(hand.x, hand.y - 20);
  await replies.release();
  await expect(editor.notice).toContainText('stray');
  await page.mouse.move(hand.x, hand.y - 40);
  await page.mouse.up();
  await expect(editor.handles).toHaveCount(5);
  await expect.poll(async () => (await editor.position('right hand')).y).toBeCloseTo(hand.y - 40, 0);
  await editor.button('Undo: move right hand').click();
  await expect.poll(() => editor.shownPose('right hand')).toMatchObject({ x: 900, y: 516 });
  await expect(editor.button('Undo')).toBeDisabled();
});

test('objects passed to or returned by the element are copies', async ({ page }) => {
  await Editor.open(page);
  const posed = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const places: unknown[] = [];
    const tell = () => places.push(...warp.project.handles.filter(({ id }) => id === 'head'));
    const got = structuredClone(warp.project) as unknown as { handles: { posed: number[] }[] };
    warp.addEventListener('change', (event) => {
      (event as CustomEvent).detail.project.handles.length = 0;
    });
    warp.project = got as never;
    (warp.project as unknown as typeof got).handles[0]?.posed.fill(1);
    got.handles[0]?.posed.fill(2);
    tell();
    const place: [number, number] = [520, 250];
    warp.updateHandle('head', { posed: place });
    place.fill(3);
    tell();
    warp.undo();
    tell();
    return places.map((handle) => (handle as { posed: number[] }).posed);
  });
  expect(posed).toEqual([
    [512, 260],
    [520, 250],
    [512, 260],
  ]);
});

test('a project comes back as the page wrote it, and handles as a person adds them', async ({ page }) => {
  const editor = await Editor.open(page);
  const { pairs, added } = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const pairs: (readonly [string, string])[] = [];
    const set = (project: ProjectFile) => {
      warp.project = project;
      pairs.push([JSON.stringify(warp.project), JSON.stringify(project)]);
    };
    const { handles, image, format } = warp.project;
    set({
      image,
      handles: handles.map(({ id, kind, posed, rest }) => ({ posed, rest, kind, id }) as never),
      format,
    });
    const written = warp.project.handles[0];
    // Values that a handle has already, though its file leaves them out.
    warp.updateHandle('head', { rotation: 0, scale: 1, depth: 0 });
    warp.pose([{ id: 'head', depth: 0 }]);
    pairs.push([JSON.stringify(warp.project.handles[0]), JSON.stringify(written)]);
    warp.updateHandle('head', { depth: 2 });
    pairs.push([JSON.stringify(warp.project.handles[0]), JSON.stringify({ ...written, depth: 2 })]);
    const added: unknown[] = [];
    for (const mode of ['rigid', 'harmonic'] as const) {
      set({ ...warp.project, pose: { mode } });
      const rest = [512, 700] as const;
      const ids = [
        warp.addHandle({ kind: 'point', rest }),
        warp.addHandle({
          kind: 'bar',
          rest: [
            [400, 600],
            [600, 600],
          ],
        }),
        warp.addHandle({ kind: 'point', rest: [512, 800], rotation: 0 }),
      ];
      added.push(
        ids.map((id) => warp.project.handles.find((handle) => handle.id === id)?.rotation ?? 'none'),
      );
      for (const id of ids) warp.removeHandle(id);
    }
    return { pairs, added };
  });
  for (const [got, given] of pairs) expect(got).toBe(given);
  expect(added).toEqual([
    ['auto', 'auto', 0],
    ['none', 'auto', 0],
  ]);
  const project = () =>
    page.locator('c2-warp').evaluate((element) => JSON.stringify((element as C2Warp).project));
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ kind: 'point', rest: [512, 700] });
  });
  const before = await project();
  const saved = (await bytes(await editor.download('Save the project file'))).toString();
  await page.locator('c2-warp').evaluate(async (element, saved) => {
    await (element as C2Warp).load('/samples/gingerbread.png', JSON.parse(saved));
  }, saved);
  expect(await project()).toBe(before);
});

test('a drag is reverted when the editor becomes readonly or disabled', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  await warp.evaluate((element) => {
    Object.assign(globalThis, { changes: 0 });
    element.addEventListener('change', () => Object.assign(globalThis, { changes: 1 }));
  });
  for (const attribute of ['readonly', 'disabled']) {
    const { x, y } = await editor.position('right hand');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y - 40, { steps: 3 });
    await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(500);
    await warp.evaluate((element, name) => element.setAttribute(name, ''), attribute);
    await page.mouse.move(x, y - 80, { steps: 3 });
    await page.mouse.up();
    expect(await editor.settled(() => editor.shownPose('right hand'))).toMatchObject({ x: 900, y: 516 });
    await warp.evaluate((element, name) => element.removeAttribute(name), attribute);
  }
  expect(await page.evaluate(() => Reflect.get(globalThis, 'changes'))).toBe(0);
});

test('readonly discards a draft and a number being typed', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  const flip = (on: boolean) => warp.evaluate((element, on) => Object.assign(element, { readonly: on }), on);
  await editor.handle('head').click();
  await editor.field('x').fill('700');
  await flip(true);
  await page.keyboard.press('Enter');
  await flip(false);
  await expect(editor.field('x')).toHaveValue('512');
  expect(await editor.shownPose('head')).toMatchObject({ x: 512 });

  await page.keyboard.press('g');
  const at = await editor.fromImage('right hand', [900, 516]);
  for (const corner of [at(450, 600), at(570, 600), at(510, 720)]) {
    await page.mouse.click(corner.x, corner.y);
  }
  await expect(editor.button('Finish')).toBeEnabled();
  await flip(true);
  await page.keyboard.press('Enter');
  await expect(editor.button('Finish')).toBeHidden();
  await expect(editor.handles).toHaveCount(5);
});

test('hiding the element reverts a drag and keeps the view', async ({ page }) => {
  const editor = await Editor.open(page);
  const show = (display: string) =>
    page.locator('c2-warp').evaluate((element, display) => {
      (element as HTMLElement).style.display = display;
      return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }, display);
  const { x, y } = await editor.position('right hand');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 40, { steps: 3 });
  await show('none');
  await page.mouse.move(x, y - 80, { steps: 3 });
  await page.mouse.up();
  await show('');
  expect(await editor.settled(() => editor.shownPose('right hand'))).toMatchObject({ x: 900, y: 516 });
  await expect.poll(() => editor.position('right hand')).toEqual({ x, y });
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

/** Requests so many samples that the solve takes long. */
const ponder = (page: Page) =>
  page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.project = { ...warp.project, samples: 1_000_000 };
  });

test('a drag does not wait for a solve', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  const goal = { x: hand.x, y: hand.y - 70 };
  const before = await editor.screenshot(goal);
  await replies.hold();
  await ponder(page);
  await expect(page.getByRole('progressbar')).toBeVisible();
  await editor.dragHandle('right hand', { x: 0, y: -70 });
  await expect.poll(async () => meanDifference(before, await editor.screenshot(goal))).toBeGreaterThan(10);
  await expect(page.getByRole('progressbar')).toBeVisible();
});

test('a long solve shows progress, and editors can cancel it', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await replies.hold();
  await ponder(page);
  await expect(page.getByRole('progressbar')).toBeVisible();
  const readonly = (on: boolean) =>
    page.locator('c2-warp').evaluate((element, on) => Object.assign(element, { readonly: on }), on);
  await readonly(true);
  await expect(editor.button('Cancel')).toBeHidden();
  await readonly(false);
  await editor.button('Cancel').click();
  await expect(page.getByRole('progressbar')).toBeHidden();
  const samples = () => page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.samples);
  await expect.poll(samples).toBe(10_000);
});

test('cancelling the solve of an undo reverts it and keeps the history', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await editor.waitForSolve(async () => {
    await page.locator('c2-warp').evaluate((element) => {
      (element as C2Warp).addHandle({ kind: 'point', rest: [512, 700] });
    });
  });
  await expect.poll(async () => (await editor.storedWork()).handles?.length).toBe(6);
  // Only the present is solved then, so an undo needs another solve.
  await page.reload();
  await editor.ready();
  await expect(editor.handles).toHaveCount(6);
  const undo = editor.button('Undo: add handle');
  await replies.hold();
  await undo.click();
  await expect(editor.handles).toHaveCount(5);
  await editor.button('Cancel').click();
  await expect(editor.handles).toHaveCount(6);
  await replies.release();
  await undo.click();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.solved).toContainText('mesh point');
  const redo = editor.button('Redo: add handle');
  await expect(redo).toBeEnabled();
  await redo.click();
  await expect(editor.handles).toHaveCount(6);
});

test('export progress shows until the end, also during solves', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  await replies.hold();
  const download = page.waitForEvent('download');
  await editor.pressExport();
  await expect(editor.solved).toContainText('Exporting 0 %');
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ kind: 'point', rest: [512, 700] });
  });
  await expect(editor.solved).not.toContainText('Exporting');
  await editor.button('Cancel').click();
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.solved).toContainText('Exporting 0 %');
  await replies.release();
  await download;
  await expect(editor.solved).toContainText('mesh point');
});

test('progress ends when the change is undone during its solve', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    for (let k = 0; k < 6; k++)
      warp.addHandle({ kind: 'point', rest: [420 + 30 * k, 700], posed: [420 + 30 * k, 700] });
    for (let k = 0; k < 6; k++) {
      warp.undo();
      await new Promise((done) => setTimeout(done, 8));
    }
  });
  await expect(editor.handles).toHaveCount(5);
  await expect(page.getByRole('progressbar')).toBeHidden();
  await expect(page.locator('c2-warp .solved')).toContainText('mesh point');
});

test('the chosen theme persists', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.button('Dark colours').click();
  await page.reload();
  await expect(editor.button('Light colours')).toBeVisible();
});

test('the theme switch follows the system', async ({ page }) => {
  const editor = await Editor.open(page);
  await expect(editor.button('Dark colours')).toBeVisible();
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await editor.button('Light colours').click();
  await expect(editor.button('Dark colours')).toBeVisible();
});

test('every change of the selection fires an event', async ({ page }) => {
  await Editor.open(page);
  const heard = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const heard: string[] = [];
    warp.addEventListener('selectionchange', (event) =>
      heard.push((event as CustomEvent<{ selection: string[] }>).detail.selection.join(' ')),
    );
    warp.selection = ['head'];
    warp.addHandle({ kind: 'point', rest: [512, 500], id: 'belly' });
    warp.undo();
    warp.redo();
    warp.removeHandle('belly');
    return heard;
  });
  expect(heard).toEqual(['head', 'belly', 'head', 'belly', '']);
});

test('calls that change nothing add no step and keep the redo', async ({ page }) => {
  await Editor.open(page);
  const labels = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const labels: unknown[] = [];
    warp.addEventListener('historychange', (event) => labels.push((event as CustomEvent).detail));
    warp.updateHandle('head', { depth: 3 });
    warp.undo();
    labels.length = 0;
    warp.updateHandle('head', { depth: 0 });
    warp.reset();
    return labels;
  });
  expect(labels).toEqual([]);
  await expect(page.getByRole('button', { name: 'Redo: change handle' })).toBeEnabled();
});

test('setting a property to undefined resets it, as frameworks do', async ({ page }) => {
  await Editor.open(page);
  const left = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const names = ['src', 'project', 'tool', 'readonly', 'disabled', 'posable', 'theme', 'hint', 'hintFor'];
    warp.selection = ['head'];
    for (const name of [...names, 'autosave', 'selection']) Reflect.set(warp, name, undefined);
    return { selection: warp.selection, handles: warp.project.handles.length };
  });
  expect(left).toEqual({ selection: [], handles: 5 });
});

test('a selection box disappears with its picture', async ({ page }) => {
  const editor = await Editor.open(page);
  const box = page.locator('c2-warp rect.box');
  const stage = (await page.locator('c2-warp .stage').boundingBox()) ?? { x: 0, y: 0 };
  await page.mouse.move(stage.x + 80, stage.y + 90);
  await page.mouse.down();
  await page.mouse.move(stage.x + 200, stage.y + 200);
  await expect(box).toBeAttached();
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).load('/samples/gingerbread.png'));
  await expect(editor.handles).toHaveCount(0);
  await expect(box).not.toBeAttached();
  await page.mouse.up();
  await expect(box).not.toBeAttached();
});

test('a disabled editor ignores keys', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  await editor.handle('head').focus();
  await page.keyboard.press('Escape');
  await warp.evaluate((element) => {
    (element as C2Warp).disabled = true;
    (element as C2Warp).focus();
  });
  const before = await editor.position('head');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.down('o');
  await editor.waitFrames();
  expect(await editor.position('head')).toEqual(before);
  await expect(page.locator('c2-warp .previewing')).not.toBeAttached();
});

test('pointer and keys reach no control of a disabled editor', async ({ page }) => {
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  const colours = editor.button('Dark colours');
  const at = await editor.centre(colours);
  await colours.focus();
  await warp.evaluate((element) => element.setAttribute('disabled', ''));
  await expect(page.locator('c2-warp .shell')).toHaveAttribute('inert');
  await page.keyboard.press('Enter');
  await page.mouse.click(at.x, at.y);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  expect(await warp.evaluate((element) => element.shadowRoot?.activeElement ?? null)).toBeNull();
  await warp.evaluate((element) => element.removeAttribute('disabled'));
  await expect(colours).toBeVisible();
});

test('methods work on a disabled editor', async ({ page }) => {
  const editor = await Editor.open(page);
  const fitted = await editor.zoom();
  await page.keyboard.press('1');
  await expect.poll(() => editor.zoom()).toBe(1);
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).disabled = true;
    (element as C2Warp).fit();
  });
  await expect
    .poll(async () => (await page.locator('c2-warp .percent').textContent()) ?? '')
    .toMatch(`${Math.round(fitted * 100)} %`);
});

test('without a picture handles are rejected, and a selection is kept', async ({ page }) => {
  const editor = await Editor.open(page);
  const refused = await page.evaluate(() => {
    const warp = document.createElement('c2-warp') as C2Warp;
    warp.id = 'empty';
    Object.assign(warp.style, { display: 'block', height: '300px' });
    const sample = document.querySelector('c2-warp') as C2Warp;
    const { project } = sample;
    sample.replaceWith(warp);
    Object.assign(warp, { src: '/samples/gingerbread.png', project, selection: ['head'] });
    try {
      return warp.addHandle({ kind: 'point', rest: [5, 5] });
    } catch (error) {
      return (error as Error).message;
    }
  });
  expect(refused).toContain('open a picture');
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
});

test('the open work stays if the solver dies on another picture', async ({ page }) => {
  await page.addInitScript(() => {
    const workers: Worker[] = [];
    globalThis.Worker = class extends Worker {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        if (!/encoder|picture/.test(String(url))) workers.push(this);
      }
    };
    Object.assign(globalThis, { workers });
  });
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  const told = await editor.settled(() => editor.shownPose('left hand'));
  const code = await page.evaluate(async () => {
    const warp = document.querySelector('c2-warp') as C2Warp;
    const workers = Reflect.get(globalThis, 'workers') as Worker[];
    let code: string | undefined;
    const loading = warp.load('/samples/gingerbread.png').catch((error) => {
      code = error.code;
    });
    const died = { data: { kind: 'died', message: 'unreachable' } };
    while (code === undefined) {
      workers.at(-1)?.dispatchEvent(new MessageEvent('message', died));
      await new Promise(requestAnimationFrame);
    }
    await loading;
    return code;
  });
  expect(code).toBe('engine');
  await expect.poll(() => editor.shownPose('left hand')).toEqual(told);
  await editor.button('Undo: move left hand').click();
  await expect.poll(() => editor.shownPose('left hand')).toMatchObject({ x: 124, y: 516 });
});

const TRANSFORMS = {
  'turned by 4°': { transform: 'rotate(-4deg)' },
  'turned by 20°': { transform: 'rotate(20deg)' },
  mirrored: { transform: 'scale(-1, 1)' },
  'seen in perspective': { transform: 'perspective(900px) rotateY(25deg) rotateX(10deg)' },
  'scaled and zoomed': { transform: 'scale(0.8, 0.6)', zoom: '1.25' },
};

/** Returns the exact centre of a handle: its bounding box has another one in perspective. */
const trueCentre = (handle: Locator): Promise<Position> =>
  handle.evaluate((button) => {
    const mark = document.createElement('i');
    Object.assign(mark.style, { position: 'absolute', left: '50%', top: '50%' });
    button.append(mark);
    const { x, y } = mark.getBoundingClientRect();
    mark.remove();
    return { x, y };
  });

for (const [name, style] of Object.entries(TRANSFORMS)) {
  test(`handles are dragged where they are seen in an element that is ${name}`, async ({ page }) => {
    await page.setViewportSize({ width: 1200, height: 900 });
    const editor = await Editor.open(page);
    const warp = page.locator('c2-warp');
    await warp.evaluate((element, style) => {
      const size = {
        position: 'absolute',
        inset: '60px auto auto 60px',
        width: '901.5px',
        height: '640.25px',
      };
      Object.assign((element as C2Warp).style, size, style);
    }, style);
    await editor.settled(() => editor.position('head'));
    for (const handle of ['head', 'left hand', 'right hand', 'left foot', 'right foot']) {
      const at = await trueCentre(editor.handle(handle));
      const { x, y } = await editor.shownPose(handle);
      const { client, back } = await warp.evaluate(
        (element, { at, image }) => {
          const warp = element as C2Warp;
          const client = warp.imageToClient(image);
          const there = warp.clientToImage([at.x, at.y]);
          return { client, back: there && warp.imageToClient(there) };
        },
        { at, image: [x, y] as const },
      );
      for (const [u = 0, v = 0] of [client ?? [], back ?? []])
        expect(Math.hypot(u - at.x, v - at.y)).toBeLessThan(0.5);
      const goal = { x: at.x + 13, y: at.y - 12 };
      await editor.drag(at, { x: 13, y: -12 });
      await expect
        .poll(async () => {
          const now = await trueCentre(editor.handle(handle));
          return Math.hypot(now.x - goal.x, now.y - goal.y);
        })
        .toBeLessThan(0.5);
    }
  });
}

test('a lost graphics context is reported until it is restored, and loses no work', async ({ page }) => {
  const editor = await Editor.open(page);
  const hand = await editor.position('right hand');
  const goal = { x: hand.x, y: hand.y - 70 };
  const lose = await page.locator('c2-warp').evaluateHandle((element) => {
    const canvas = element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
    return canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
  });
  await lose.evaluate((context) => context?.loseContext());
  await expect(editor.notice).toContainText('The browser lost access to the graphics card');
  await editor.dragHandle('right hand', { x: 0, y: -70 });
  await expect.poll(async () => (await editor.position('right hand')).y).toBeLessThan(goal.y + 1);
  const before = await editor.screenshot(goal);
  await lose.evaluate((context) => context?.restoreContext());
  await expect(editor.notice).toBeHidden();
  await expect.poll(async () => meanDifference(before, await editor.screenshot(goal))).toBeGreaterThan(10);
});
