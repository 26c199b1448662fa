/** A page in control of `<c2-warp>`: questions, features, the tool in hand, sources, and points by thousands. */
import type { C2Warp } from '../../web/src/element';
import type { C2WarpPlayer } from '../../web/src/player';
import { Editor } from './editor';
import { expect, test } from './fixtures';

const SAMPLE = '/samples/gingerbread.png';

/** Notes events of the element with their details, and prevents the default of some. */
const listen = ({ page }: Editor, types: readonly string[], refused: readonly string[] = []) =>
  page.locator('c2-warp').evaluate(
    (element, [types, refused]) => {
      const heard: unknown[] = [];
      Object.assign(globalThis, { heard });
      for (const type of types)
        element.addEventListener(type, (event) => {
          heard.push([type, JSON.parse(JSON.stringify((event as CustomEvent).detail))]);
          if (refused.includes(type)) event.preventDefault();
        });
    },
    [types, refused] as const,
  );

const heard = ({ page }: Editor) => page.evaluate(() => Reflect.get(globalThis, 'heard') as unknown[]);

const tool = ({ page }: Editor) => page.locator('c2-warp').evaluate((element) => (element as C2Warp).tool);

test('the tool property follows the hand, and nonsense is refused', async ({ page }) => {
  const editor = await Editor.open(page);
  await listen(editor, ['toolchange', 'error']);
  await page.keyboard.press('b');
  expect(await tool(editor)).toBe('bar');
  await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    warp.tool = 'hand';
  });
  await expect.poll(() => tool(editor)).toBe('hand');
  await page.keyboard.press('v');
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).tool = 'hand';
  });
  await expect.poll(() => tool(editor)).toBe('hand');
  await page.locator('c2-warp').evaluate(async (element) => {
    (element as C2Warp).addEventListener('error', ({ detail }) =>
      Object.assign(globalThis, { code: Reflect.get(detail, 'code') }),
    );
    element.setAttribute('tool', 'hammer');
    element.setAttribute('theme', 'blue');
    element.setAttribute('features', 'tools shop');
  });
  await expect.poll(() => page.evaluate(() => Reflect.get(globalThis, 'code'))).toBe('attribute');
  expect(await tool(editor)).toBe('hand');
  const changes = (await heard(editor)).filter((event) => (event as string[])[0] === 'toolchange');
  expect(changes).toEqual(['bar', 'hand', 'select', 'hand'].map((tool) => ['toolchange', { tool }]));
});

test('a page may refuse to open, save, export, add and remove', async ({ page }) => {
  const editor = await Editor.open(page);
  const types = ['beforeopen', 'beforesave', 'beforeexport', 'beforeadd', 'beforeremove'];
  await listen(editor, [...types, 'change', 'load'], types);
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('p');
  const { x, y } = at(512, 700);
  await page.mouse.click(x, y);
  await page.keyboard.press('v');
  await editor.handle('head').click();
  await page.keyboard.press('Delete');
  await editor.button('Save').click();
  await page.keyboard.press('Control+e');
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['x'], 'other.png', { type: 'image/png' }));
    const target = document.querySelector('c2-warp') as Element;
    target.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await expect.poll(async () => (await heard(editor)).length).toBe(5);
  expect(await heard(editor)).toEqual([
    ['beforeadd', { handles: [expect.objectContaining({ kind: 'point' })] }],
    ['beforeremove', { handles: [expect.objectContaining({ id: 'head' })] }],
    ['beforesave', expect.objectContaining({ name: 'gingerbread.c2warp.json', picture: null })],
    ['beforeexport', { name: 'gingerbread-warped.png', kind: 'picture' }],
    ['beforeopen', { files: [{}], address: null }],
  ]);
  await expect(editor.handles).toHaveCount(5);
  await expect(editor.button('Undo')).toBeDisabled();
});

test('methods of the page and undo ask nothing', async ({ page }) => {
  const editor = await Editor.open(page);
  await listen(editor, ['beforeadd', 'beforeremove', 'beforeopen', 'load']);
  await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    warp.addHandle({ id: 'heart', kind: 'point', rest: [512, 600] });
    warp.undo();
    warp.redo();
    warp.removeHandle('heart');
    await warp.load('/samples/gingerbread.png', '/samples/gingerbread.c2warp.json');
  });
  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('p');
  const { x, y } = at(512, 700);
  await page.mouse.click(x, y);
  await expect(editor.handles).toHaveCount(6);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+Shift+z');
  await expect(editor.handles).toHaveCount(6);
  expect(await heard(editor)).toEqual([
    ['load', { origin: 'page' }],
    ['beforeadd', { handles: [expect.objectContaining({ rest: expect.any(Array) })] }],
  ]);
});

test('a page is told of pictures that people open, and stores work itself', async ({ page }) => {
  const editor = await Editor.open(page);
  await listen(editor, ['load', 'beforesave', 'titlechange'], ['beforesave']);
  const buffer = Buffer.from(await (await page.request.get(SAMPLE)).body());
  await editor.chooseFile({ name: 'mine.png', mimeType: 'image/png', buffer });
  await expect
    .poll(async () => (await heard(editor)).some((event) => (event as unknown[])[0] === 'load'))
    .toBe(true);
  expect(await heard(editor)).toContainEqual(['load', { origin: 'person' }]);
  await expect(editor.solved).toContainText('1024 × 1280');
  await page.locator('c2-warp').evaluate((element) => {
    (element as C2Warp).addHandle({ id: 'heart', kind: 'point', rest: [512, 600] });
  });
  await expect.poll(() => heard(editor)).toContainEqual(['titlechange', { name: 'mine.png', unsaved: true }]);
  await page.keyboard.press('Control+s');
  await expect
    .poll(async () => (await heard(editor)).some((event) => (event as unknown[])[0] === 'beforesave'))
    .toBe(true);
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).markSaved());
  await expect
    .poll(async () => (await heard(editor)).at(-1))
    .toEqual(['titlechange', { name: 'mine.png', unsaved: false }]);
});

test('features that a page leaves out are not there, nor are their keys', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => element.setAttribute('features', 'save'));
  await expect(editor.button('Save')).toBeVisible();
  await expect(page.getByRole('group', { name: 'Tools' })).toBeHidden();
  for (const name of ['Open a picture or project', 'Export', 'Animate'])
    await expect(page.getByRole('button', { name, exact: true })).toBeHidden();
  await page.keyboard.press('p');
  expect(await tool(editor)).toBe('select');
  // Handles are posed as before.
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await expect(editor.button('Undo: move right hand')).toBeEnabled();
  await page.locator('c2-warp').evaluate((element) => element.removeAttribute('features'));
  await expect(page.getByRole('group', { name: 'Tools' })).toBeVisible();
});

test('pictures come from images, canvases, bitmaps and pixels', async ({ page }) => {
  await Editor.open(page);
  const sizes = await page.locator('c2-warp').evaluate(async (element, sample) => {
    const warp = element as C2Warp;
    const image = new Image();
    image.src = sample;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [60, 40];
    const pen = canvas.getContext('2d') as CanvasRenderingContext2D;
    pen.fillRect(0, 0, 60, 40);
    const sources = [image, canvas, await createImageBitmap(canvas), pen.getImageData(0, 0, 30, 20)];
    const sizes: unknown[] = [];
    for (const source of sources) {
      await warp.load(source);
      await warp.loaded;
      sizes.push([warp.naturalWidth, warp.naturalHeight, warp.project.image.src]);
    }
    sizes.push(await warp.load(document.createElement('p') as never).catch((error) => error.message));
    sizes.push(await warp.load(document.createElement('canvas')).catch(() => 'refused'));
    const empty = document.createElement('canvas');
    empty.width = 0;
    sizes.push(await warp.load(empty).catch((error) => [error.code, error.message]));
    sizes.push(await warp.load(new Image()).catch((error) => error.code));
    // The newest call wins, also if an older one has to write a file first.
    const older = warp.load(canvas).catch((error) => error.name);
    await warp.load(sample);
    sizes.push(await older, warp.naturalWidth);
    return sizes;
  }, SAMPLE);
  expect(sizes).toEqual([
    [1024, 1280, 'gingerbread.png'],
    [60, 40, 'picture.png'],
    [60, 40, 'picture.png'],
    [30, 20, 'picture.png'],
    expect.stringContaining('expected an address'),
    expect.anything(),
    ['picture', 'load: the picture has 0 × 150 pixels'],
    'picture',
    'AbortError',
    1024,
  ]);
});

test('thousands of points map in one call, and back', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('right hand', { x: 10, y: -40 });
  await editor.settled(() => editor.mapped(900, 516));
  const found = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const points = Float64Array.from({ length: 2000 }, (_, at) =>
      at % 2 === 0 ? 300 + (at % 400) : 500 + (at % 37),
    );
    const mapped = warp.mapPoints(points);
    const back = warp.unmapPoints(mapped);
    const single = warp.mapPoint([points[10] ?? 0, points[11] ?? 0]);
    const refusals = [new Float64Array(3), [1, 2]].map((wrong) => {
      try {
        return warp.mapPoints(wrong as Float64Array).length;
      } catch (error) {
        return (error as Error).message;
      }
    });
    return {
      single: [mapped[10], mapped[11], ...(single ?? [])],
      apart: Math.max(...back.map((value, at) => Math.abs(value - (points[at] ?? 0)))),
      outside: [...warp.mapPoints(Float64Array.of(5, 5))],
      refusals,
    };
  });
  expect(found.single.slice(0, 2)).toEqual(found.single.slice(2));
  expect(found.apart).toBeLessThan(1e-3);
  expect(found.outside).toEqual([Number.NaN, Number.NaN]);
  expect(found.refusals).toEqual(Array(2).fill(expect.stringContaining('a Float64Array of pairs')));
});

test('exports take one object of options, and refuse the rest by name', async ({ page }) => {
  await Editor.open(page);
  const refusals = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const tries = ['image/jpeg', () => {}, 2, { size: 2 }, { scale: Number.NaN }, { type: 'image/gif' }];
    return Promise.all(tries.map((options) => warp.toBlob(options as never).catch((error) => error.message)));
  });
  expect(refusals).toEqual([
    'toBlob: expected an object of options such as { scale: 2 }, found a string',
    'toBlob: expected an object of options such as { scale: 2 }, found a function',
    'toBlob: expected an object of options such as { scale: 2 }, found a number',
    expect.stringContaining('toBlob: unknown option "size"'),
    'scale: expected a number above 0',
    'type: expected one of image/png, image/jpeg, image/webp',
  ]);
});

test('history, zoom, and a point outside are told before a change', async ({ page }) => {
  await Editor.open(page);
  const told = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const changes: string[] = [];
    warp.addEventListener('change', () => changes.push('change'));
    const refusal = await Promise.resolve()
      .then(() => warp.addHandle({ kind: 'point', rest: [5, 5] }))
      .catch((error) => [error.code, error.handles]);
    const before = [warp.canUndo, warp.canRedo];
    warp.updateHandle('head', { rotation: 20 });
    const stepped = [warp.canUndo, warp.canRedo];
    warp.undo();
    const undone = [warp.canUndo, warp.canRedo];
    warp.zoom = 2;
    const zoomed = warp.zoom;
    warp.zoom = 1e9;
    return { refusal, before, stepped, undone, zoomed, most: warp.zoom, changes: changes.length };
  });
  expect(told).toEqual({
    refusal: ['handle-outside', ['handle-1']],
    before: [false, false],
    stepped: [true, false],
    undone: [false, true],
    zoomed: 2,
    most: 64,
    changes: 2,
  });
});

test('without a height of the page the editor shows the picture', async ({ page }) => {
  await Editor.open(page);
  const heights = await page.evaluate(async () => {
    const heights: number[] = [];
    for (const style of ['', 'height: 300px', 'height: 100%']) {
      const box = document.createElement('div');
      box.style.height = '350px';
      const warp = document.createElement('c2-warp');
      // The page of the editor fills the window with it.
      warp.style.cssText = `position: relative; inset: auto; ${style}`;
      box.append(warp);
      document.body.append(box);
      await (warp as C2Warp).updateComplete;
      heights.push(warp.getBoundingClientRect().height);
    }
    return heights;
  });
  expect(heights).toEqual([480, 300, 350]);
});

test('`loaded` rejects with the reason if the first picture cannot be opened', async ({ page }) => {
  await Editor.open(page);
  const told = await page.evaluate(() => {
    const warp = document.createElement('c2-warp') as C2Warp;
    warp.src = 'data:text/plain,no picture';
    const { loaded } = warp;
    document.body.append(warp);
    return loaded.catch((error) => error.code);
  });
  expect(told).toBe('picture');
});

test('`loaded` belongs to the newest picture that the page has asked for', async ({ page }) => {
  await Editor.open(page);
  const told = await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    const unhandled: string[] = [];
    addEventListener('unhandledrejection', ({ reason }) => unhandled.push(String(reason)));
    const ended = (promise: Promise<void>) =>
      promise.then(
        () => warp.naturalWidth,
        (reason) => (reason instanceof DOMException ? reason.name : reason.code),
      );
    const told: unknown[] = [];
    // The picture of the page is open. Each of these is another one, also if it fails.
    const first = warp.loaded;
    told.push(warp.naturalWidth, first === warp.loaded);
    warp.src = '/samples/cat.png';
    warp.removeAttribute('project');
    told.push(await ended(warp.loaded));
    warp.src = '/samples/robot.png';
    const replaced = [warp.loaded];
    warp.src = '/samples/snake.png';
    replaced.push(warp.loaded);
    const call = warp.load('/samples/gingerbread.png');
    replaced.push(warp.loaded);
    told.push(await Promise.all(replaced.map(ended)));
    await call;
    warp.src = 'data:text/plain,no picture';
    told.push(await ended(warp.loaded), warp.naturalWidth);
    await warp.load('data:text/plain,no file').catch(() => {});
    told.push(await ended(warp.loaded));
    // It is opened again after a move.
    document.body.append(warp);
    told.push(await ended(warp.loaded));
    // A person is faster.
    warp.src = '/samples/robot.png';
    const before = warp.loaded;
    await warp.updateComplete;
    const cat = await (await fetch('/samples/cat.png')).blob();
    const opened = new Promise((resolve) => warp.addEventListener('load', resolve, { once: true }));
    warp.src = '/samples/snake.png';
    const slow = warp.loaded;
    await warp.updateComplete;
    warp.openFiles([new File([cat], 'cat.png', { type: 'image/png' })]);
    told.push(await ended(before), await ended(slow));
    await opened;
    told.push(await ended(warp.loaded));
    // Nobody waits for these.
    warp.src = 'data:text/plain,nothing';
    warp.src = '/samples/cat.png';
    await warp.loaded;
    await new Promise((resolve) => setTimeout(resolve));
    return { told, unhandled };
  });
  expect(told).toEqual({
    told: [
      1024,
      true,
      760,
      ['AbortError', 'AbortError', 1024],
      'picture',
      1024,
      'picture',
      1024,
      'AbortError',
      'AbortError',
      760,
    ],
    unhandled: [],
  });
});

test('attributes and properties read back at once what a page set', async ({ page }) => {
  const editor = await Editor.open(page);
  const read = await page.locator('c2-warp').evaluate((element) => {
    const warp = element as C2Warp;
    const read: unknown[] = [];
    warp.tool = 'point';
    read.push(warp.tool, warp.getAttribute('tool'));
    warp.readOnly = true;
    // People could not choose it now.
    warp.tool = 'bar';
    read.push(warp.readonly, warp.hasAttribute('readonly'), warp.tool, warp.toolSource);
    warp.removeAttribute('readonly');
    read.push(warp.readOnly, warp.tool);
    warp.theme = 'dark';
    read.push(warp.getAttribute('theme'));
    warp.removeAttribute('theme');
    read.push(warp.theme);
    warp.src = 'samples/cat.png';
    read.push(warp.getAttribute('src'), warp.src === new URL('samples/cat.png', document.baseURI).href);
    return read;
  });
  expect(read).toEqual([
    'point',
    'point',
    true,
    true,
    'point',
    'bar',
    false,
    'bar',
    'dark',
    'auto',
    'samples/cat.png',
    true,
  ]);
  await expect(editor.page.locator('.tools [aria-pressed=true]')).toHaveAccessibleName(/[Bb]ar/);
});

test('properties that were set before the element was defined count, and read back', async ({ page }) => {
  await page.goto('/harness/');
  const read = await page.evaluate(async () => {
    const tags = ['c2-warp', 'c2-warp-player'] as const;
    const early = tags.map((tag) => {
      const element = document.createElement(tag);
      element.setAttribute('src', '/samples/none.png');
      Object.assign(element, { src: '/samples/cat.png', autoplay: true });
      if (tag === 'c2-warp') Object.assign(element, { tool: 'hand', readOnly: true });
      document.body.append(element);
      return element;
    });
    for (const url of ['/element/c2warp.js', '/player/c2warp-player.js']) await import(url);
    const [warp, player] = early as [C2Warp, C2WarpPlayer];
    return {
      warp: [warp.getAttribute('src'), warp.autoplay, warp.tool, warp.readonly],
      player: [player.getAttribute('src'), player.autoplay],
    };
  });
  expect(read).toEqual({
    warp: ['/samples/cat.png', true, 'hand', true],
    player: ['/samples/cat.png', true],
  });
});

test('a form submits the project, and needs a picture where it is required', async ({ page }) => {
  await Editor.open(page);
  const told = await page.evaluate(async (sample) => {
    const form = document.createElement('form');
    const warp = document.createElement('c2-warp') as C2Warp;
    Object.assign(warp, { name: 'avatar', required: true });
    form.append(warp);
    document.body.append(form);
    await warp.updateComplete;
    const empty = [form.checkValidity(), warp.validity.valueMissing, new FormData(form).has('avatar')];
    await warp.load(sample);
    warp.addHandle({ id: 'heart', kind: 'point', rest: [512, 600], posed: [540, 600] });
    await warp.updateComplete;
    const sent = JSON.parse(String(new FormData(form).get('avatar')));
    const full = [form.checkValidity(), warp.form === form, sent.handles[0].posed];
    form.reset();
    const reset = warp.project.handles[0]?.posed;
    warp.disabled = true;
    await warp.updateComplete;
    return { empty, full, reset, disabled: new FormData(form).has('avatar') };
  }, SAMPLE);
  expect(told).toEqual({
    empty: [false, true, false],
    full: [true, true, [540, 600]],
    reset: [512, 600],
    disabled: false,
  });
});

test('a signal gives a picture up, while it is read and while it is solved', async ({ page }) => {
  const editor = await Editor.open(page);
  let asked = 0;
  await page.route('**/never.png', () => {
    asked++;
  });
  await listen(editor, ['load', 'error', 'change']);
  const told = page.locator('c2-warp').evaluate(async (element, sample) => {
    const warp = element as C2Warp;
    const reasons: unknown[] = [];
    const note = (reason: unknown) => reasons.push(reason);
    await warp.load(sample, null, { signal: AbortSignal.abort('early') }).catch(note);
    const reading = new AbortController();
    const read = warp.load('never.png', null, { signal: reading.signal }).catch(note);
    Object.assign(globalThis, { giveUp: () => reading.abort('read') });
    await read;
    const solving = new AbortController();
    const file = await (await fetch(sample)).blob();
    const solved = warp.load(file, null, { signal: solving.signal }).catch(note);
    const onStage = () => warp.naturalWidth > 0 && warp.project.handles.length === 0;
    while (!onStage()) await new Promise((resolve) => requestAnimationFrame(resolve));
    solving.abort('solved');
    await solved;
    return { reasons, handles: warp.project.handles.length };
  }, SAMPLE);
  await expect.poll(() => asked).toBe(1);
  await page.evaluate(() => (Reflect.get(globalThis, 'giveUp') as () => void)());
  expect(await told).toEqual({ reasons: ['early', 'read', 'solved'], handles: 5 });
  await expect(editor.solved).toContainText('mesh point');
  expect(await heard(editor)).toEqual([]);
});

test('pictures of other origins are requested with cookies if the page allows it', async ({ page }) => {
  const editor = await Editor.open(page);
  const cookies: string[] = [];
  const allowed = { 'Access-Control-Allow-Credentials': 'true' };
  const origin = new URL(page.url()).origin;
  await page
    .context()
    .addCookies([
      { name: 'who', value: 'me', domain: 'pictures.example', path: '/', sameSite: 'None', secure: true },
    ]);
  await page.route('https://pictures.example/**', async (route) => {
    cookies.push((await route.request().allHeaders()).cookie ?? '');
    await route.fulfill({
      path: 'web/public/samples/cat.png',
      headers: { ...allowed, 'Access-Control-Allow-Origin': origin, 'Content-Type': 'image/png' },
    });
  });
  await listen(editor, ['error']);
  await page.locator('c2-warp').evaluate(async (element) => {
    const warp = element as C2Warp;
    await warp.load('https://pictures.example/cat.png');
    element.setAttribute('crossorigin', 'use-credentials');
    await warp.updateComplete;
    await warp.load('https://pictures.example/cat.png');
    element.setAttribute('crossorigin', 'cookies');
    await warp.updateComplete;
  });
  expect(cookies).toEqual(['', 'who=me']);
  expect(await heard(editor)).toHaveLength(1);
});

test('controls of a page in the toolbar and the panel keep their keys and focus', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.locator('c2-warp').evaluate((element) => {
    const button = document.createElement('button');
    Object.assign(button, { textContent: 'Publish', slot: 'toolbar' });
    button.addEventListener('click', () => Object.assign(globalThis, { published: true }));
    const field = document.createElement('input');
    Object.assign(field, { slot: 'panel', ariaLabel: 'Caption' });
    element.append(button, field);
  });
  await page.getByRole('button', { name: 'Publish' }).click();
  expect(await page.evaluate(() => Reflect.get(globalThis, 'published'))).toBe(true);
  const field = page.getByRole('textbox', { name: 'Caption' });
  await field.click();
  await page.keyboard.type('bpv 1?');
  await page.keyboard.press('Delete');
  await expect(field).toHaveValue('bpv 1?');
  expect(await tool(editor)).toBe('select');
  await expect(editor.handle('left hand')).toBeVisible();
  const [top, middle, panel] = await Promise.all([
    page.locator('.top').boundingBox(),
    page.getByRole('button', { name: 'Publish' }).boundingBox(),
    page.locator('.panel').boundingBox(),
  ]);
  expect(middle && top && middle.y > top.y && middle.y + middle.height < top.y + top.height).toBe(true);
  const at = await field.boundingBox();
  expect(at && panel && at.x >= panel.x && at.x + at.width <= panel.x + panel.width).toBe(true);
});

test('new projects have the settings of the page, and nonsense is refused', async ({ page }) => {
  const editor = await Editor.open(page);
  await listen(editor, ['error']);
  const told = await page.locator('c2-warp').evaluate(async (element, sample) => {
    const warp = element as C2Warp;
    warp.defaults = { samples: 2000, pose: { density: 20 }, fix_boundary: true };
    await warp.load(sample);
    const { samples, pose, weighting, fix_boundary: held } = warp.project;
    warp.defaults = { pose: { mode: 'harmonic' } };
    await warp.load(sample);
    const harmonic = [warp.project.weighting?.support, warp.project.pose?.density, warp.project.samples];
    let refusal = '';
    try {
      Object.assign(warp, { defaults: { handles: [] } });
    } catch (error) {
      refusal = String(error);
    }
    const kept = warp.defaults;
    warp.defaults = { samples: 3 };
    return { samples, pose, support: weighting?.support, held, harmonic, refusal, kept };
  }, SAMPLE);
  expect(told).toEqual({
    samples: 2000,
    pose: { mode: 'rigid', blend: 'linear', density: 20 },
    support: 'smooth',
    held: true,
    harmonic: ['paper', 0, 10000],
    refusal: expect.stringContaining('found "handles"'),
    kept: { pose: { mode: 'harmonic' } },
  });
  const defaults = () => page.locator('c2-warp').evaluate((element) => (element as C2Warp).defaults);
  await expect.poll(defaults).toEqual({});
  expect(await heard(editor)).toHaveLength(1);
});

test('a form waits until the pictures that it submits are drawn', async ({ page }) => {
  await Editor.open(page);
  const told = await page.evaluate(async (sample) => {
    const form = document.createElement('form');
    const warps = ['avatar', 'badge'].map((name) => {
      const warp = document.createElement('c2-warp') as C2Warp;
      Object.assign(warp, { name, submits: 'picture' });
      form.append(warp);
      return warp;
    });
    const button = document.createElement('button');
    Object.assign(button, { name: 'by', value: 'button' });
    form.append(button);
    document.body.append(form);
    for (const warp of warps) await warp.load(sample);
    const sent = new Promise<FormData>((resolve) =>
      form.addEventListener('submit', (event) => {
        event.preventDefault();
        resolve(new FormData(form, event.submitter));
      }),
    );
    let submissions = 0;
    form.addEventListener('submit', () => submissions++);
    button.click();
    button.click();
    const data = await sent;
    const size = async (name: string) => {
      const file = data.get(name) as File;
      const { width, height } = await createImageBitmap(file);
      return [file.name, file.type, width, height];
    };
    const [first] = warps;
    const { width, height } = await createImageBitmap((await first?.toBlob()) as Blob);
    return {
      sizes: [await size('avatar'), await size('badge')],
      expected: [width, height],
      by: data.get('by'),
      submissions,
      after: new FormData(form).has('avatar'),
    };
  }, SAMPLE);
  const file = ['gingerbread-warped.png', 'image/png', ...told.expected];
  expect(told).toMatchObject({ sizes: [file, file], by: 'button', submissions: 1, after: false });
});
