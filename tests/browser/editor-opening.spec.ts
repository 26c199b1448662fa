/** `<c2-warp>` on other pages: concurrent requests to open, and elements that are moved or removed. */

import type { Page, Route } from '@playwright/test';
import { encode } from 'fast-png';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { WorkerReplies } from './worker_replies';

const SIDES = { '/slow.png': 40, '/fast.png': 48 } as const;

/** A picture whose response a test delays. Once released, it is served at once. */
class SlowPicture {
  readonly #page: Page;
  readonly #answered: Promise<void>[] = [];
  #time = Promise.resolve();
  #come = () => {};

  constructor(page: Page) {
    this.#page = page;
    this.stays();
  }

  /** Delays all later requests. */
  stays(): void {
    this.#time = new Promise((come) => {
      this.#come = come;
    });
  }

  asked(route: Route): void {
    // The request may have been aborted meanwhile.
    const answered = this.#time.then(() => route.fulfill(file(SIDES['/slow.png']))).catch(() => {});
    this.#answered.push(answered);
  }

  /** WorkerReplies all requests, and waits longer than it takes to open the picture. */
  async comes(): Promise<void> {
    this.#come();
    await Promise.all(this.#answered);
    await this.#page.evaluate(async () => {
      for (let turn = 0; turn < 4; turn++) {
        await createImageBitmap(await (await fetch('/fast.png')).blob());
        await new Promise((done) => requestAnimationFrame(done));
      }
    });
  }
}

const square = (side: number) =>
  Buffer.from(
    encode({ width: side, height: side, data: new Uint8Array(side * side * 4).fill(255), channels: 4 }),
  );

const file = (side: number) => ({ body: square(side), contentType: 'image/png' });

const PROJECT = {
  format: 'c2warp/1',
  image: { src: 'fast.png', width: 48, height: 48 },
  handles: [{ id: 'middle', kind: 'point', rest: [24, 24], posed: [30, 24] }],
} as const;

/** Opens the editor's page with another body. `heard` lists the element's events; one picture is slow. */
async function open(page: Page, body: string): Promise<SlowPicture> {
  const slow = new SlowPicture(page);
  await page.route('**/fast.png', (route) => route.fulfill(file(SIDES['/fast.png'])));
  await page.route('**/slow.png', (route) => slow.asked(route));
  await page.route('**/project.json', (route) => route.fulfill({ json: PROJECT }));
  const built = await (await page.request.get('/')).text();
  const html = built.replace(/<c2-warp[\s\S]*<\/c2-warp>/, () => body);
  await page.route('**/page.html', (route) => route.fulfill({ body: html, contentType: 'text/html' }));
  await page.addInitScript(() => {
    const heard: string[] = [];
    const hear = (event: Event) => {
      if ((event.target as Element | null)?.localName === 'c2-warp') heard.push(event.type);
    };
    for (const type of ['ready', 'load', 'error']) document.addEventListener(type, hear, { capture: true });
    Object.assign(globalThis, { heard });
  });
  await page.goto('/page.html');
  await page.waitForFunction(() => customElements.get('c2-warp') !== undefined);
  return slow;
}

const warp = (page: Page) => page.locator('c2-warp');
const picture = (page: Page) => warp(page).evaluate((element) => (element as C2Warp).project.image.src);
const handles = (page: Page) =>
  warp(page)
    .first()
    .evaluate((element) => (element as C2Warp).project.handles.map(({ id }) => id).join());
const heard = (page: Page) => page.evaluate(() => Reflect.get(globalThis, 'heard') as string[]);

test('an empty stage asks for a picture, except while one is loading', async ({ page }) => {
  const slow = await open(page, '<c2-warp></c2-warp>');
  const [asks, waits] = [page.getByText('Drop a picture here'), page.getByText('Opening…')];
  await expect(asks).toBeVisible();
  await expect(waits).toBeHidden();
  await warp(page).evaluate((element) => element.setAttribute('src', '/slow.png'));
  await expect(waits).toBeVisible();
  await expect(asks).toBeHidden();
  // A rejected file supersedes the load, so the stage asks again.
  const refused = warp(page).evaluate((element) =>
    (element as C2Warp).load(new Blob(['no picture'])).catch((error: Error) => error.message),
  );
  expect(await refused).toContain('as a picture');
  await slow.comes();
  await expect(asks).toBeVisible();
  await expect(waits).toBeHidden();
});

/** Delays files until the returned function is called. */
async function late(page: Page, files: string): Promise<() => void> {
  let comes = () => {};
  const come = new Promise<void>((done) => {
    comes = done;
  });
  await page.route(files, async (route) => {
    await come;
    await route.continue();
  });
  return comes;
}

test('the page shows a message while the script loads', async ({ page }) => {
  const comes = await late(page, '**/index-*.js');
  await page.goto('/', { waitUntil: 'commit' });
  const waits = page.getByText('The editor is loading');
  await expect(waits).toBeVisible();
  comes();
  await new Editor(page).ready();
  await expect(waits).toBeHidden();
});

test('the stage shows that it is opening while the solver loads', async ({ page }) => {
  const comes = await late(page, '**/*.wasm');
  await page.goto('/');
  await expect(page.getByText('Opening…')).toBeVisible();
  await expect(page.getByText('Drop a picture here')).toBeHidden();
  comes();
  await new Editor(page).ready();
  await expect(page.getByText('Opening…')).toBeHidden();
});

/** WorkerReplies requests for files with an HTML page, like a captive portal, until the returned function is called. */
async function captive(page: Page, files: string): Promise<() => Promise<void>> {
  await page.route(files, (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }));
  return () => page.unroute(files);
}

for (const [what, files] of [
  ['the solver', '**/*.wasm'],
  ['the worker', '**/worker-*.js'],
] as const) {
  test(`after ${what} fails to load, a retry opens the sample`, async ({ page }) => {
    const free = await captive(page, files);
    await page.goto('/');
    const editor = new Editor(page);
    await editor.button('Try again').click();
    // The network works again.
    await expect(editor.button('Try again')).toBeVisible();
    await free();
    await editor.button('Try again').click();
    await editor.ready();
    await expect(editor.notice).toBeHidden();
  });

  test(`while ${what} fails to load, stored work shows and edits stay`, async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.dragHandle('left hand', { x: 0, y: -40 });
    await expect.poll(async () => (await editor.storedWork()).step).toBe('Move left hand');
    const first = await editor.shownPose('left hand');
    const free = await captive(page, files);
    await page.reload();
    await expect(editor.notice).toContainText('The solver');
    // The end of the drag requests the solver again, without success.
    const failed = warp(page).evaluate(
      (element) =>
        new Promise<void>((done) => element.addEventListener('error', () => done(), { once: true })),
    );
    await editor.dragHandle('right hand', { x: 0, y: -40 });
    await failed;
    const second = await editor.shownPose('right hand');
    await free();
    await editor.button('Try again').click();
    await editor.ready();
    await expect(editor.notice).toBeHidden();
    expect([(await editor.shownPose('left hand')).y, (await editor.shownPose('right hand')).y]).toEqual([
      first.y,
      second.y,
    ]);
    await expect.poll(async () => (await editor.storedWork()).step).toBe('Move right hand');
    await page.reload();
    await editor.ready();
    expect((await editor.shownPose('right hand')).y).toBe(second.y);
  });
}

test('the next edit retries a failed solver', async ({ page }) => {
  const free = await captive(page, '**/worker-*.js');
  await page.goto('/');
  const editor = new Editor(page);
  await expect(editor.notice).toContainText('The solver failed');
  await free();
  await editor.dragHandle('left hand', { x: 0, y: -40 });
  await editor.ready();
  await expect(editor.notice).toBeHidden();
});

test('a project that the page set waits for the solver', async ({ page }) => {
  const free = await captive(page, '**/*.wasm');
  await open(page, '<c2-warp></c2-warp>');
  await warp(page).evaluate((element, project) => {
    (element as C2Warp).project = project;
    element.setAttribute('src', '/fast.png');
  }, PROJECT);
  await expect(page.getByRole('alert')).toContainText('Could not load the solver');
  await free();
  await page.getByRole('button', { name: 'Try again' }).click();
  await expect(page.getByRole('button', { name: 'Handle middle, ' })).toBeVisible();
  await expect
    .poll(async () => (await heard(page)).filter((type) => type !== 'error'))
    .toEqual(['ready', 'load']);
});

test('a picture without handles shows a hint; own pictures get the point tool', async ({ page }) => {
  await open(page, `<c2-warp src="/fast.png"></c2-warp>`);
  const editor = new Editor(page);
  const pressed = (tool: string) => expect(editor.button(tool)).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByText('choose the point tool, then click the picture')).toBeVisible();
  await pressed('Select and move');
  const bring = async () =>
    editor.chooseFile({ name: 'mine.png', mimeType: 'image/png', buffer: square(40) });
  await bring();
  await expect(page.getByText('Click the picture where you want a handle')).toBeVisible();
  await pressed('Add a point handle');
  const middle = await editor.centre(page.locator('c2-warp canvas'));
  await page.mouse.click(middle.x - 80, middle.y);
  await expect(editor.handles).toHaveCount(1);
  await page.keyboard.press('Escape');
  await expect(page.getByText('Click the picture where')).toBeHidden();

  await warp(page).evaluate((element) => element.setAttribute('tool', 'select'));
  await bring();
  await expect(page.getByText('choose the point tool, then click')).toBeVisible();
  await pressed('Select and move');
});

test('a new picture is fitted during its solve, whatever the last size', async ({ page }) => {
  const replies = await WorkerReplies.intercept(page);
  await open(page, `<c2-warp src="/samples/gingerbread.png"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  const editor = new Editor(page);
  expect(await editor.zoom()).toBeLessThan(1);
  await replies.hold();
  await warp(page).evaluate((element) => element.setAttribute('src', '/fast.png'));
  await expect.poll(() => picture(page)).toBe('fast.png');
  await editor.waitFrames();
  const zoom = await editor.zoom();
  expect(zoom).toBeGreaterThan(8);
  await replies.release();
  await expect(editor.solved).toContainText('48 × 48 px');
  expect(await editor.zoom()).toBe(zoom);
});

test('the newest load wins, and the earlier one rejects', async ({ page }) => {
  const slow = await open(page, `<c2-warp></c2-warp>`);
  const ends = await warp(page).evaluate(async (element) => {
    const load = (source: string) =>
      (element as C2Warp).load(source).then(
        () => source,
        (error) => error.name,
      );
    return Promise.all([load('/slow.png'), load('/fast.png')]);
  });
  expect(ends).toEqual(['AbortError', '/fast.png']);
  await slow.comes();
  expect(await picture(page)).toBe('fast.png');
});

test('the newest src wins, and a load wins over the initial src', async ({ page }) => {
  const slow = await open(page, `<c2-warp src="/slow.png"></c2-warp>`);
  await warp(page).evaluate((element) => element.setAttribute('src', '/fast.png'));
  await expect.poll(() => heard(page)).toEqual(expect.arrayContaining(['ready', 'load']));
  await slow.comes();
  expect(await picture(page)).toBe('fast.png');
  expect((await heard(page)).filter((type) => type === 'load')).toHaveLength(1);

  slow.stays();
  await warp(page).evaluate(async (element) => {
    element.remove();
    const other = document.createElement('c2-warp');
    other.src = '/slow.png';
    document.body.append(other);
    await other.load('/fast.png');
  });
  await slow.comes();
  expect(await picture(page)).toBe('fast.png');
});

test('removal of the element aborts a load, even if it is reinserted', async ({ page }) => {
  await open(page, `<c2-warp></c2-warp>`);
  const ends = await warp(page).evaluate(async (element) => {
    const ends: string[] = [];
    for (const back of [true, false]) {
      const loading = (element as C2Warp).load('/slow.png');
      await new Promise((done) => setTimeout(done, 100));
      element.remove();
      if (back) document.body.append(element);
      ends.push(
        await loading.then(
          () => 'open',
          (error) => error.name,
        ),
      );
    }
    return ends;
  });
  expect(ends).toEqual(['AbortError', 'AbortError']);
});

test('a new src opens although the element was moved or detached', async ({ page }) => {
  const slow = await open(page, `<c2-warp src="/fast.png"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  await warp(page).evaluate(async (element) => {
    element.setAttribute('src', '/slow.png');
    await new Promise((done) => setTimeout(done, 200));
    document.body.append(element);
  });
  await slow.comes();
  await expect.poll(() => picture(page)).toBe('slow.png');
  await warp(page).evaluate(async (element) => {
    element.remove();
    element.setAttribute('src', '/fast.png');
    await new Promise((done) => setTimeout(done, 50));
    document.body.append(element);
  });
  await expect.poll(() => picture(page)).toBe('fast.png');
});

test('a moved element without a new src keeps its work', async ({ page }) => {
  const slow = await open(page, `<c2-warp src="/slow.png"></c2-warp>`);
  await slow.comes();
  await expect.poll(() => heard(page)).toContain('load');
  await warp(page).evaluate(async (element) => {
    await (element as C2Warp).load('/fast.png', '/project.json');
    document.body.append(element);
  });
  await expect.poll(() => heard(page)).toEqual(['load', 'ready', 'load', 'load', 'ready']);
  expect(await picture(page)).toBe('fast.png');
});

test('without a picture it is ready, fires no load and rejects exports', async ({ page }) => {
  await open(page, `<c2-warp></c2-warp>`);
  await expect.poll(() => heard(page)).toEqual(['ready']);
  const refusals = await warp(page).evaluate(async (element) => {
    const refusal = (warp: C2Warp) =>
      warp.toBlob().then(
        () => 'given',
        (error) => error.message,
      );
    return [await refusal(element as C2Warp), await refusal(document.createElement('c2-warp'))];
  });
  expect(refusals[0]).toContain('Open a picture');
  expect(refusals[1]).toContain('no picture');
});

test('properties set before insertion or upgrade apply to the picture', async ({ page }) => {
  const json = JSON.stringify(PROJECT);
  await open(
    page,
    `<c2-warp></c2-warp><script>
      const early = document.querySelector('c2-warp');
      early.src = '/fast.png'; early.project = ${json}; early.selection = ['middle']; early.tool = 'bar';
    </script>`,
  );
  await expect.poll(() => heard(page)).toContain('load');
  const told = (element: Element) => {
    const { project, selection } = element as C2Warp;
    return [project.handles.map(({ id, posed }) => [id, posed]), selection];
  };
  expect(await warp(page).evaluate(told)).toEqual([[['middle', [30, 24]]], ['middle']]);
  await expect(page.locator('.tools [aria-pressed=true]')).toHaveAccessibleName(/bar/);

  await page.evaluate(() => {
    document.querySelector('c2-warp')?.remove();
    const made = document.createElement('c2-warp');
    Object.assign(made, { src: '/fast.png', project: '/project.json', selection: ['middle'] });
    document.body.append(made);
  });
  await expect.poll(async () => (await heard(page)).filter((type) => type === 'load').length).toBe(2);
  expect(await warp(page).evaluate(told)).toEqual([[['middle', [30, 24]]], ['middle']]);
});

test('a project set without a picture waits for a picture of the user', async ({ page }) => {
  await open(page, '<c2-warp></c2-warp>');
  await expect.poll(() => heard(page)).toContain('ready');
  const editor = new Editor(page);
  const bring = async (name: string, side: number) => {
    const asked = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Open a picture', exact: true }).click();
    await (await asked).setFiles({ name, mimeType: 'image/png', buffer: square(side) });
  };
  const set = () =>
    warp(page).evaluate((element, project) => {
      Object.assign(element, { project, selection: ['middle'] });
    }, PROJECT);
  await set();
  await bring('mine.png', 48);
  await expect(editor.handle('middle')).toHaveAttribute('aria-pressed', 'true');
  expect(await warp(page).evaluate((element) => (element as C2Warp).project.handles[0]?.posed)).toEqual([
    30, 24,
  ]);

  await warp(page).evaluate((element) => element.replaceWith(document.createElement('c2-warp')));
  await set();
  await bring('other.png', 40);
  await expect(editor.notice).toContainText('The project is for a picture of 48 × 48 px, but other.png has');
  await expect(editor.solved).toContainText('40 × 40 px');
  expect(await heard(page)).toContain('error');
  await warp(page).evaluate((element) => (element as C2Warp).load('/fast.png'));
  expect(await picture(page)).toBe('fast.png');
  await expect(editor.handles).toHaveCount(0);
});

test('an invalid project is rejected with the key, and nothing changes', async ({ page }) => {
  const slow = await open(page, `<c2-warp src="/fast.png" project="/project.json"></c2-warp>`);
  await slow.comes();
  await expect.poll(() => heard(page)).toContain('load');
  const refusals = await warp(page).evaluate(async (element) => {
    const warp = element as C2Warp;
    const load = (source: unknown, project?: unknown) =>
      warp.load(source as string, project as string).then(
        () => 'open',
        (error) => `${error.code ?? error.name}: ${error.message}`,
      );
    const { project } = warp;
    return [
      await load('/fast.png', {}),
      await load('/fast.png', { ...project, handles: [{ id: 'a', kind: 'circle' }] }),
      await load('/slow.png', project),
      await load(new Map()),
      warp.project.handles.map(({ id }) => id).join(),
      await load(new URL('/fast.png', location.href), null),
    ];
  });
  expect(refusals).toEqual([
    'project: format: missing',
    expect.stringContaining('project: handles[0].kind: expected'),
    expect.stringContaining('image-size: The project is for a picture of 48 × 48 px'),
    expect.stringContaining('TypeError: load: expected an address'),
    'middle',
    'open',
  ]);
});

test('src and project set one after the other open together', async ({ page }) => {
  await open(page, `<c2-warp src="/fast.png"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  await page.route('**/other.png', (route) => route.fulfill(file(64)));
  await warp(page).evaluate((element) => {
    const warp = element as C2Warp;
    const image = { src: 'other.png', width: 64, height: 64 };
    const handles = [{ id: 'far', kind: 'point', rest: [60, 60], posed: [60, 50] }] as const;
    warp.src = '/other.png';
    warp.project = { format: 'c2warp/1', image, handles };
    warp.selection = ['far'];
  });
  await expect.poll(() => handles(page)).toBe('far');
  expect(await picture(page)).toBe('other.png');
  // Waits for the solution.
  const selection = () => warp(page).evaluate((element) => (element as C2Warp).selection.join());
  await expect.poll(selection).toBe('far');
  // The project came with the picture, so it is no undo step.
  await warp(page).evaluate((element) => (element as C2Warp).undo());
  expect(await handles(page)).toBe('far');
});

test('a waiting project is kept until used or replaced', async ({ page }) => {
  const slow = await open(page, `<c2-warp></c2-warp>`);
  await page.evaluate((project) => {
    const warp = document.querySelector('c2-warp') as C2Warp;
    warp.project = project;
    warp.src = '/slow.png';
  }, PROJECT);
  await warp(page).evaluate((element) => {
    (element as C2Warp).src = '/fast.png';
  });
  await expect.poll(() => handles(page)).toBe('middle');
  await slow.comes();
  expect(await picture(page)).toBe('fast.png');

  const ends = await page.evaluate(async (project) => {
    const end = async (work: Promise<void>, { project }: C2Warp) =>
      `${await work.then(
        () => 'open',
        (error) => error.code,
      )} ${project.handles.map(({ id }) => id)}`;
    const added = () => {
      const warp = document.createElement('c2-warp');
      document.body.append(warp);
      warp.project = project;
      return warp;
    };
    const [late, other] = [added(), added()];
    const refused = await end(late.load(new Blob(['words'])), late);
    await late.load('/fast.png');
    await other.load('/fast.png', { ...project, handles: [{ ...project.handles[0], id: 'other' }] });
    const ids = [late, other].map(({ project }) => project.handles.map(({ id }) => id).join());
    return [refused, ...ids];
  }, PROJECT);
  expect(ends).toEqual(['picture ', 'middle', 'other']);
});

test('a failed load does not stop the work restored after a move', async ({ page }) => {
  await open(page, `<c2-warp src="/fast.png" project="/project.json"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  const end = await warp(page).evaluate(async (element) => {
    const warp = element as C2Warp;
    const frame = document.createElement('div');
    document.body.append(frame);
    frame.append(warp);
    return warp.load(new Blob(['words'])).catch((error) => error.code);
  });
  expect(end).toBe('picture');
  await expect.poll(() => handles(page)).toBe('middle');
  expect(await picture(page)).toBe('fast.png');
});

test('a selection set by the page ends a drag and keeps its result', async ({ page }) => {
  const editor = new Editor(page);
  await open(page, `<c2-warp src="/fast.png" project="/project.json"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  const at = await editor.position('middle');
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y, { steps: 4 });
  const told = await editor.settled(() => editor.shownPose('middle'));
  await warp(page).evaluate((element) => {
    (element as C2Warp).selection = [];
  });
  await page.mouse.move(at.x + 90, at.y);
  await page.mouse.up();
  expect(await editor.shownPose('middle')).toEqual(told);
  expect(await warp(page).evaluate((element) => (element as C2Warp).selection)).toEqual([]);
  await expect(editor.button('Undo: move middle')).toBeEnabled();
});

test('names of Object properties are no tools', async ({ page }) => {
  const editor = new Editor(page);
  await open(page, `<c2-warp src="/fast.png" project="/project.json" tool="constructor"></c2-warp>`);
  await editor.handle('middle').click();
  await expect(editor.button('Select and move')).toHaveAttribute('aria-pressed', 'true');
});

test('a picture in a data URL gets a default name', async ({ page }) => {
  const address = `data:image/png;base64,${square(48).toString('base64')}`;
  await open(page, `<c2-warp src="${address}"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  expect(await picture(page)).toBe('picture.png');
});

test('an autosave key set later stores the open work from then on', async ({ page }) => {
  await open(page, `<c2-warp src="/fast.png" project="/project.json"></c2-warp>`);
  await expect.poll(() => heard(page)).toContain('load');
  await warp(page).evaluate((element) => {
    element.setAttribute('autosave', 'late');
    (element as C2Warp).updateHandle('middle', { posed: [20, 20] });
  });
  const work = { picture: 'fast.png', handles: [expect.objectContaining({ posed: [20, 20] })] };
  await expect.poll(() => new Editor(page).storedWork('late')).toMatchObject(work);
  await page.evaluate(() => {
    document.querySelector('c2-warp')?.remove();
    const other = document.createElement('c2-warp');
    other.setAttribute('autosave', 'late');
    document.body.append(other);
  });
  await expect.poll(async () => (await heard(page)).filter((type) => type === 'load').length).toBe(2);
  const posed = await warp(page).evaluate((element) => (element as C2Warp).project.handles[0]?.posed);
  expect(posed).toEqual([20, 20]);
});
