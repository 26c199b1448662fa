/** `<c2-warp-player>`: rigs of the command `c2warp bake`, played as a video is. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import AxeBuilder from '@axe-core/playwright';
import type { Page, TestInfo } from '@playwright/test';
import type { Handle, Project } from '../../web/src/document/project';
import type { C2WarpPlayer, HandlePose } from '../../web/src/player';
import { builtCommand } from './command';
import { waved } from './displacements';
import { expect, test } from './fixtures';
import { difference, movedFarther } from './images';

const SAMPLES = fileURLToPath(new URL('../../web/public/samples/', import.meta.url));

/** The left hand waves, and then crosses the body. Both arms bend. */
const KEYS = {
  'left-hand': [
    [0, [124, 516]],
    [0.4, [160, 420]],
    [0.8, [620, 640]],
  ],
  'right-hand': [
    [0, [900, 516]],
    [0.4, [860, 640]],
    [0.8, [900, 430]],
  ],
} as const;

let folder = '';
let project: Project;
let clips: NonNullable<Project['clips']>;
let rig: Buffer;

test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'c2warp-player-'));
  project = JSON.parse(readFileSync(join(SAMPLES, 'gingerbread.c2warp.json'), 'utf8'));
  const tracks = Object.entries(KEYS).map(([handle, keys]) => ({
    handle,
    keys: keys.map(([time, posed]) => ({ time, posed })),
  }));
  clips = [
    { name: 'wave', duration: 1.2, loop: 'repeat', tracks },
    { name: 'there and back', duration: 0.5, loop: 'alternate', tracks: [] },
  ];
  writeFileSync(join(folder, 'wave.c2warp.json'), JSON.stringify({ ...project, clips }));
  const args = ['bake', 'wave.c2warp.json', '--image', join(SAMPLES, 'gingerbread.png'), '-o', 'wave.c2rig'];
  const { status, stderr } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
  expect(stderr).toBe('');
  expect(status).toBe(0);
  rig = readFileSync(join(folder, 'wave.c2rig'));
});
test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** Opens a page with the player's script, and rigs by their addresses. */
async function open(page: Page, rigs: Record<string, Buffer> = { 'wave.c2rig': rig }): Promise<void> {
  for (const [name, body] of Object.entries(rigs))
    await page.route(`**/${name}`, (route) => route.fulfill({ body }));
  await page.goto('/harness/');
  await page.addScriptTag({ type: 'module', url: '/player/c2warp-player.js' });
  await page.evaluate(() => customElements.whenDefined('c2-warp-player'));
}

/** Adds a player of 256 × 320 px, and waits for its events. */
const added = (page: Page, attributes: Record<string, string>, until: string) =>
  page.evaluate(
    ([attributes, until]) => {
      const player = document.createElement('c2-warp-player');
      const heard: string[] = [];
      for (const type of ['loadeddata', 'play', 'pause', 'timeupdate', 'ended', 'error'])
        player.addEventListener(type, () => heard.push(type));
      Object.assign(globalThis, { player, heard });
      for (const [name, value] of Object.entries(attributes)) player.setAttribute(name, value);
      player.style.width = '256px';
      player.append('A gingerbread man');
      document.body.append(player);
      return new Promise<string>((resolve) => {
        player.addEventListener(until, (event) => resolve(String(Reflect.get(event, 'message'))), {
          once: true,
        });
      });
    },
    [attributes, until] as const,
  );

const heard = (page: Page) => page.evaluate(() => Reflect.get(globalThis, 'heard') as string[]);
const player = (page: Page) => page.locator('c2-warp-player').last();
const state = (page: Page) =>
  player(page).evaluate((element) => {
    const { currentTime, paused, ended } = element as C2WarpPlayer;
    return { currentTime, paused, ended };
  });

/** The frame at a time, a PNG in base64. */
async function frame(page: Page, time: number, width: number): Promise<string> {
  await player(page).evaluate((element, time) => {
    (element as C2WarpPlayer).currentTime = time;
  }, time);
  return drawn(page, width);
}

/** The shown frame, a PNG in base64. */
const drawn = (page: Page, width: number) =>
  player(page).evaluate(async (element, width) => {
    const player = element as C2WarpPlayer;
    player.style.width = `${width}px`;
    const canvas = player.shadowRoot?.querySelector('canvas');
    while (canvas?.width !== width) await new Promise(requestAnimationFrame);
    // The frame after the next one follows its drawing.
    for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
    return canvas.toDataURL().replace(/^.*,/, '');
  }, width);

test('frames equal those of the editor, also where arms cross', async ({ page }, info) => {
  await open(page);
  await added(page, { src: '/wave.c2rig' }, 'loadeddata');
  for (const [key, time] of [0, 0.4, 0.8].entries()) {
    const handles = project.handles.map((handle) => {
      const posed = KEYS[handle.id as 'left-hand']?.[key]?.[1];
      return posed ? { ...handle, posed } : handle;
    });
    const editor = await page.evaluate(
      async ([project, time]) =>
        harness.drawnTwice(project, await (await fetch('/samples/gingerbread.png')).blob(), 0.5, time),
      [{ ...project, clips, handles } as Project, time] as const,
    );
    const { mean, close, opaque } = await difference(await frame(page, time, 512), editor.webgl, info);
    expect(opaque).toBeGreaterThan(10_000);
    expect(mean, `at ${time} s`).toBeLessThanOrEqual(1);
    expect(close).toBeGreaterThan(0.99);
  }
});

test('frames of a displaced picture equal those of the editor', async ({ page }, info) => {
  const displaced = waved(project, 30);
  await open(page, { 'displaced.c2rig': baked({ ...displaced, clips }), 'wave.c2rig': rig });
  await added(page, { src: '/displaced.c2rig' }, 'loadeddata');
  const resting = await frame(page, 0, 512);
  const picture = async (project: Project, time: number) =>
    page.evaluate(
      async ([project, time]) =>
        harness.drawnTwice(project, await (await fetch('/samples/gingerbread.png')).blob(), 0.5, time),
      [project, time] as const,
    );
  for (const [key, time] of [0, 0.4].entries()) {
    const handles = displaced.handles.map((handle) => {
      const posed = KEYS[handle.id as 'left-hand']?.[key]?.[1];
      return posed ? { ...handle, posed } : handle;
    });
    const editor = await picture({ ...displaced, clips, handles } as Project, time);
    const { mean, close, opaque } = await difference(await frame(page, time, 512), editor.webgl, info);
    expect(opaque).toBeGreaterThan(10_000);
    expect(mean, `at ${time} s`).toBeLessThanOrEqual(1);
    expect(close).toBeGreaterThan(0.99);
  }
  const { webgl } = await picture({ ...project, clips } as Project, 0);
  expect((await difference(resting, webgl, info)).mean).toBeGreaterThan(3);
});

/** The sample in the harmonic mode, without automatic rotations. */
const posable = (): Project => ({
  ...project,
  pose: { mode: 'harmonic', blend: 'linear', density: 100 },
  handles: project.handles.map((handle) => ({ ...handle, rotation: 0, scale: 1, depth: 0 })),
});

/** The rig of a project. */
function baked(project: Project, ...options: readonly string[]): Buffer {
  writeFileSync(join(folder, 'other.c2warp.json'), JSON.stringify(project));
  const args = [
    'bake',
    'other.c2warp.json',
    '--image',
    join(SAMPLES, 'gingerbread.png'),
    '-o',
    'other.c2rig',
    ...options,
  ];
  const { stderr } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
  expect(stderr).toBe('');
  return readFileSync(join(folder, 'other.c2rig'));
}

/** Poses handles of a project in the player. Returns all of them, as the player must have them. */
async function poseBy(
  page: Page,
  { handles }: Project,
  changes: readonly HandlePose[],
): Promise<Project['handles']> {
  const posed = await player(page).evaluate((element, changes) => {
    const player = element as C2WarpPlayer;
    player.pose(changes);
    return player.handles;
  }, changes);
  const expected = handles.map((handle) => {
    const change = changes.find(({ id }) => id === handle.id);
    return change ? ({ ...handle, ...change } as Handle) : handle;
  });
  expect(posed).toEqual(expected);
  return expected;
}

/** The player must draw a project of the gingerbread figure as the editor does. */
async function expectEditors(page: Page, project: Project, info: TestInfo): Promise<void> {
  const editor = await page.evaluate(
    async (project) =>
      harness.drawnTwice(project, await (await fetch('/samples/gingerbread.png')).blob(), 0.5),
    project,
  );
  const { mean, close, opaque } = await difference(await drawn(page, 512), editor.webgl, info);
  expect(opaque).toBeGreaterThan(10_000);
  expect(mean).toBeLessThanOrEqual(1);
  expect(close).toBeGreaterThan(0.99);
}

test('handles are posed without a solver, as in the editor, until the clip plays', async ({ page }, info) => {
  const posed = posable();
  await open(page, { 'posable.c2rig': baked({ ...posed, clips }), 'wave.c2rig': rig });
  await added(page, { src: '/posable.c2rig' }, 'loadeddata');
  const changes = [
    { id: 'left-hand', posed: [170, 400] as [number, number], rotation: 40 },
    { id: 'head', posed: [560, 220] as [number, number], rotation: -20, scale: 1.2, depth: 1 },
  ];
  const expected = await poseBy(page, posed, changes);
  expect((await state(page)).paused).toBe(true);
  await expectEditors(page, { ...posed, handles: expected }, info);

  // A wrong pose moves nothing.
  const refused = await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    const tried = [
      [{ id: 'tail', posed: [1, 2] }],
      [{ id: 'left-hand', posed: [1] }],
      [{ id: 'left-hand', posed: [Number.NaN, 2] }],
      [{ id: 'left-hand', rotation: 'auto' }],
      [{ id: 'left-hand', scale: 0 }],
    ].map((pose) => {
      try {
        player.pose(pose as never);
        return '';
      } catch (error) {
        return (error as Error).message;
      }
    });
    return { tried, handles: player.handles };
  });
  expect(refused.handles).toEqual(expected);
  expect(refused.tried).toEqual([
    'there is no handle "tail"',
    'left-hand: posed: expected two numbers',
    'left-hand: posed: expected two numbers',
    'left-hand: rotation: expected degrees, because automatic rotation needs the solver',
    'left-hand: scale: expected a number above 0',
  ]);

  const after = await player(page).evaluate(async (element) => {
    const player = element as C2WarpPlayer;
    await player.play();
    player.pause();
    return player.handles;
  });
  expect(after.map(({ id }) => id)).toEqual(posed.handles.map(({ id }) => id));
  expect(after.find(({ id }) => id === 'head')?.posed).toEqual([512, 260]);
});

test('a rig that was baked without poses says that it cannot be posed', async ({ page }) => {
  await open(page);
  await added(page, { src: '/wave.c2rig', posable: '' }, 'loadeddata');
  const said = await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    try {
      player.pose([{ id: 'left-hand', posed: [1, 2] }]);
    } catch (error) {
      return [player.handles.length, (error as Error).message];
    }
    return [];
  });
  expect(said).toEqual([0, 'this rig cannot be posed: it was baked without the poses of its handles']);
});

/** Addresses that the page loads to pose with the solver. */
function solverRequests(page: Page): string[] {
  const asked: string[] = [];
  page.on('request', (request) => {
    const { pathname } = new URL(request.url());
    if (/module_poser|\.wasm$/.test(pathname)) asked.push(pathname);
  });
  return asked;
}

/** The sample in the rigid mode, with an automatic rotation of the head. */
const solved = (): Project => ({
  ...project,
  pose: { mode: 'rigid', blend: 'rigid', density: 100 },
  handles: project.handles.map((handle) => ({
    ...handle,
    rotation: handle.id === 'head' ? ('auto' as const) : 0,
    scale: 1,
    depth: 0,
  })),
});

test('handles of the rigid mode are posed as in the editor', async ({ page }, info) => {
  const posed = solved();
  const asked = solverRequests(page);
  await open(page, { 'solved.c2rig': baked({ ...posed, clips }, '--posable') });
  await added(page, { src: '/solved.c2rig' }, 'loadeddata');
  // Nothing more is loaded before it is needed.
  expect(asked).toEqual([]);
  const changes = [
    { id: 'left-hand', posed: [170, 400] as [number, number], rotation: 40 },
    { id: 'head', posed: [560, 220] as [number, number], depth: 1 },
  ];
  const expected = await poseBy(page, posed, changes);
  // Grips show that the solver is loaded.
  await player(page).evaluate((element) => {
    (element as C2WarpPlayer).posable = true;
  });
  await expect(player(page).locator('[part=handle]')).toHaveCount(posed.handles.length);
  expect(asked).toEqual(['/player/module_poser.js', '/player/pose_bg.wasm']);
  await expectEditors(page, { ...posed, handles: expected }, info);
});

test('readers pose handles of the rigid mode on a strict page, also by keys', async ({ page }) => {
  const policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; require-trusted-types-for 'script'; trusted-types 'none'";
  const body = `<!doctype html><title>Strict</title><script type="module" src="/player/c2warp-player.js"></script>
<c2-warp-player src="/solved.c2rig" posable alt="A gingerbread man" width="1024" height="1280"></c2-warp-player>`;
  const rig = baked({ ...solved(), clips }, '--posable');
  await page.route('**/solved.c2rig', (route) => route.fulfill({ body: rig }));
  await page.route('**/strict.html', (route) =>
    route.fulfill({ body, contentType: 'text/html', headers: { 'content-security-policy': policy } }),
  );
  const problems: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.message));
  await page.goto('/strict.html');
  const hand = player(page).getByRole('button', { name: 'left hand' });
  await expect(hand).toBeVisible();
  const posed = () =>
    player(page).evaluate(
      (element) => (element as C2WarpPlayer).handles.find(({ id }) => id === 'left-hand')?.posed,
    );
  const before = (await posed()) as [number, number];
  const scale = await player(page).evaluate((element) => element.getBoundingClientRect().width / 1024);
  const box = await hand.boundingBox();
  const [x, y] = [(box?.x ?? 0) + 22, (box?.y ?? 0) + 22];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y - 20, { steps: 4 });
  await page.mouse.up();
  const [px, py] = (await posed()) as [number, number];
  expect(Math.abs(px - (before[0] + 10 / scale))).toBeLessThan(1);
  expect(Math.abs(py - (before[1] - 20 / scale))).toBeLessThan(1);
  await hand.focus();
  await page.keyboard.press('Shift+ArrowRight');
  const [kx, ky] = (await posed()) as [number, number];
  expect([kx - px, ky - py].map((by) => by.toFixed(3))).toEqual(['10.000', '0.000']);
  expect(problems).toEqual([]);
});

test('clips play on without the solver, and one sentence says why nothing can be posed', async ({ page }) => {
  await open(page, { 'solved.c2rig': baked({ ...solved(), clips }, '--posable') });
  await page.evaluate(() => {
    const { fetch } = globalThis;
    globalThis.fetch = (input, init) =>
      String(input).endsWith('pose_bg.wasm')
        ? Promise.resolve(new Response('', { status: 404 }))
        : fetch(input, init);
  });
  const said = await added(page, { src: '/solved.c2rig', posable: '' }, 'error');
  expect(said).toMatch(/^The handles cannot be posed: the server answered 404 for \S+pose_bg\.wasm\.$/);
  await expect(player(page).locator('[part=handle]')).toHaveCount(0);
  await player(page).evaluate((element) => (element as C2WarpPlayer).play());
  await expect.poll(async () => (await state(page)).currentTime).toBeGreaterThan(0);
  expect((await heard(page)).filter((type) => type === 'error')).toEqual(['error']);
});

test('readers take handles by pointer and by keyboard, also from a clip', async ({ page }) => {
  await open(page, { 'posable.c2rig': baked({ ...posable(), clips }), 'wave.c2rig': rig });
  await added(page, { src: '/posable.c2rig', posable: '', autoplay: '', loop: '' }, 'loadeddata');
  await page.evaluate(() => {
    const heard = Reflect.get(globalThis, 'heard') as string[];
    for (const type of ['input', 'change']) document.addEventListener(type, () => heard.push(type));
  });
  const posed = (id: string) =>
    player(page).evaluate(
      (element, id) => (element as C2WarpPlayer).handles.find((handle) => handle.id === id)?.posed,
      id,
    );
  // Grips follow the clip. The one that is taken ends it, from its present pose.
  await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    player.pause();
    player.currentTime = 0.4;
  });
  const hand = player(page).locator('[part=handle]').nth(1);
  const at = async () => {
    const box = await hand.boundingBox();
    return [(box?.x ?? 0) + 22, (box?.y ?? 0) + 22] as const;
  };
  const onPage = await player(page).evaluate((element) => {
    const { left, top, width } = element.getBoundingClientRect();
    return { left, top, scale: width / 1024 };
  });
  const expected = [onPage.left + onPage.scale * 160, onPage.top + onPage.scale * 420] as const;
  await expect
    .poll(async () => Math.hypot((await at())[0] - expected[0], (await at())[1] - expected[1]))
    .toBeLessThan(1);
  const [x, y] = await at();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y - 20, { steps: 4 });
  await page.mouse.up();
  const [px, py] = (await posed('left-hand')) as [number, number];
  expect(Math.abs(px - (160 + 10 / onPage.scale))).toBeLessThan(1);
  expect(Math.abs(py - (420 - 20 / onPage.scale))).toBeLessThan(1);
  expect((await state(page)).paused).toBe(true);
  expect(await heard(page)).toEqual(expect.arrayContaining(['input', 'change']));

  await hand.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('ArrowUp');
  const [kx, ky] = (await posed('left-hand')) as [number, number];
  expect([kx - px, ky - py].map((by) => by.toFixed(3))).toEqual(['10.000', '-1.000']);
  await page.keyboard.press('Home');
  expect(await posed('left-hand')).toEqual([124, 516]);
  const grips = await new AxeBuilder({ page }).include('c2-warp-player').analyze();
  expect(grips.violations).toEqual([]);
  // Rigs that were baked without poses have no grips.
  await player(page).evaluate((element) => {
    (element as C2WarpPlayer).src = '/wave.c2rig';
    return new Promise((resolve) => element.addEventListener('loadeddata', resolve, { once: true }));
  });
  await expect(player(page).locator('[part=handle]')).toHaveCount(0);
});

/** The shown frame at this moment, a PNG in base64. */
const shown = (page: Page) =>
  player(page).evaluate(async (element) => {
    for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
    return element.shadowRoot?.querySelector('canvas')?.toDataURL().replace(/^.*,/, '') ?? '';
  });

/** The centre of a grip on the page. */
async function gripAt(page: Page, name: string): Promise<readonly [number, number]> {
  const box = await player(page).getByRole('button', { name }).boundingBox();
  return [(box?.x ?? 0) + 22, (box?.y ?? 0) + 22];
}

/** Drags the left hand of a player of 256 px by CSS pixels in 20 steps, and holds it there. Returns all frames. */
async function draggedHand(page: Page, [dx, dy]: readonly [number, number]): Promise<string[]> {
  const [x, y] = await gripAt(page, 'left hand');
  await page.mouse.move(x, y);
  await page.mouse.down();
  const frames = [await shown(page)];
  for (let step = 1; step <= 20; step++) {
    await page.mouse.move(x + (dx * step) / 20, y + (dy * step) / 20);
    frames.push(await shown(page));
  }
  return frames;
}

/** Releases the pointer. Returns all different frames until the picture has rested for half a second. */
async function released(page: Page): Promise<string[]> {
  const frames = player(page).evaluate(async (element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    const frames = [canvas?.toDataURL() ?? ''];
    let hasEnded = false;
    element.addEventListener('change', () => {
      hasEnded = true;
    });
    Reflect.set(globalThis, 'recording', true);
    for (let changed = performance.now(); !hasEnded || performance.now() - changed < 500; ) {
      await new Promise(requestAnimationFrame);
      const frame = canvas?.toDataURL() ?? '';
      if (hasEnded && frame === frames.at(-1)) continue;
      changed = performance.now();
      if (frame !== frames.at(-1)) frames.push(frame);
    }
    return frames.map((frame) => frame.replace(/^.*,/, ''));
  });
  await page.waitForFunction(() => Reflect.get(globalThis, 'recording') === true);
  await page.mouse.up();
  return frames;
}

/** The largest fraction of pixels that move more than a distance between consecutive frames. */
const farthest = (frames: readonly string[], distance: number) =>
  Math.max(...frames.slice(1).map((frame, k) => movedFarther(frames[k] ?? '', frame, distance)));

/** A player of the sample in the rigid mode, whose readers pose it. */
async function addedPosable(page: Page): Promise<void> {
  await open(page, { 'solved.c2rig': baked({ ...project, clips }, '--posable') });
  await added(page, { src: '/solved.c2rig', posable: '' }, 'loadeddata');
  await expect(player(page).locator('[part=handle]')).toHaveCount(project.handles.length);
}

/** The sample in the present poses of the player. */
const posedProject = async (page: Page): Promise<Project> => ({
  ...project,
  handles: (await player(page).evaluate((element) => (element as C2WarpPlayer).handles)) as Handle[],
});

test('the picture follows a drag without jumps', async ({ page }) => {
  await addedPosable(page);
  // Poses from rest jump on this way, at a step by 7 px.
  const frames = await draggedHand(page, [120, 60]);
  expect(new Set(frames).size).toBe(21);
  expect(farthest(frames, 10)).toBeLessThan(0.004);
});

for (const reducedMotion of ['no-preference', 'reduce'] as const)
  test(`a drag from a clip rests as in the editor, motion: ${reducedMotion}`, async ({ page }, info) => {
    await page.emulateMedia({ reducedMotion });
    // Frames are 16 ms apart, however long they take.
    await page.addInitScript(() => {
      const { requestAnimationFrame } = globalThis;
      let now = 0;
      globalThis.requestAnimationFrame = (draw) =>
        requestAnimationFrame(() => {
          now += 16;
          draw(now);
        });
    });
    await addedPosable(page);
    await frame(page, 0.4, 256);
    const drag = await draggedHand(page, [40, -50]);
    expect(farthest(drag, 6)).toBeLessThan(0.004);
    const glide = await released(page);
    expect(farthest(glide, 2)).toBeLessThan(0.004);
    if (reducedMotion === 'reduce') expect(glide.length).toBeLessThanOrEqual(2);
    else expect(glide.length).toBeGreaterThan(4);
    await expectEditors(page, await posedProject(page), info);
  });

test('a poster is shown until the rig is loaded or fails, with a stable layout', async ({ page }) => {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await open(page, { 'page.c2rig': Buffer.from('<!doctype html>') });
  await page.route('**/slow.c2rig', async (route) => {
    await held;
    await route.fulfill({ body: rig });
  });
  await page.evaluate(() => {
    document.body.innerHTML = `
      <c2-warp-player src="/slow.c2rig" poster="/samples/gingerbread.png" alt="A wave"></c2-warp-player>
      <p id="below">below</p>
      <c2-warp-player src="/page.c2rig" poster="/samples/gingerbread.png" width="64" height="80">lost</c2-warp-player>`;
  });
  const [first, second] = [0, 1].map((at) => page.locator('c2-warp-player').nth(at));
  if (!first || !second) throw new Error('two players');
  await expect(first.locator('img')).toBeVisible();
  const tree = await (await page.context().newCDPSession(page)).send('Accessibility.getFullAXTree');
  const names = tree.nodes.filter(({ role }) => role?.value === 'image').map(({ name }) => name?.value);
  expect(names).toContain('A wave');
  const places = async () => [await first.boundingBox(), await page.locator('#below').boundingBox()];
  const before = await places();
  expect(before[0]?.width).toBeGreaterThan(100);
  release();
  await expect(first.locator('canvas')).toBeVisible();
  await expect(first.locator('img')).toBeHidden();
  expect(await places()).toEqual(before);
  await expect
    .poll(() => second.evaluate((element) => (element as C2WarpPlayer).error?.message))
    .toBe('This is not a rig.');
  await expect(second.locator('img')).toBeVisible();
  expect(await second.boundingBox()).toMatchObject({ width: 64, height: 80 });
});

test('it plays, updates and ends as a video does', async ({ page }) => {
  await open(page);
  await added(page, { src: '/wave.c2rig', autoplay: '' }, 'ended');
  expect([...new Set(await heard(page))]).toEqual(['loadeddata', 'play', 'timeupdate', 'pause', 'ended']);
  expect(await state(page)).toEqual({ currentTime: 1.2, paused: true, ended: true });
  // It begins again, and repeats.
  await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    player.loop = true;
    player.playbackRate = 4;
    return player.play();
  });
  expect((await state(page)).ended).toBe(false);
  const passes = page.evaluate(async () => {
    const player = Reflect.get(globalThis, 'player') as C2WarpPlayer;
    let [wraps, before] = [0, 0];
    while (wraps < 2) {
      await new Promise(requestAnimationFrame);
      if (player.currentTime < before) wraps++;
      before = player.currentTime;
    }
  });
  await passes;
  await player(page).evaluate((element) => (element as C2WarpPlayer).pause());
  expect((await state(page)).paused).toBe(true);
});

test('each rate and each end of each loop is that of a video', async ({ page }) => {
  const kinds = ['none', 'repeat', 'alternate'] as const;
  const short = kinds.map((loop) => ({ name: loop, duration: 0.2, loop, tracks: [] }));
  await open(page, { 'short.c2rig': baked({ ...project, clips: short }) });
  const rates = [1, -1, 2, -0.5, 0];
  const played = await page.evaluate(
    ([kinds, rates]) => {
      const frames = async (count: number) => {
        for (let k = 0; k < count; k++) await new Promise(requestAnimationFrame);
      };
      const playedBy = async (clip: string, rate: number, share: number, loop: boolean) => {
        const player = document.createElement('c2-warp-player');
        Object.assign(player, { src: '/short.c2rig', clip, loop });
        player.style.width = '20px';
        const loaded = new Promise((resolve) => player.addEventListener('loadeddata', resolve));
        document.body.append(player);
        await loaded;
        const { duration } = player;
        const events: string[] = [];
        for (const type of ['play', 'pause', 'timeupdate', 'ended'])
          player.addEventListener(type, () => events.push(type));
        player.playbackRate = rate;
        player.currentTime = share * duration;
        const sought = `${player.ended} ${events.splice(0)}`;
        await player.play();
        const begun = player.currentTime / duration;
        const isThere = () => (rate > 0 ? player.ended : rate < 0 && player.currentTime === 0);
        await frames(5);
        if (!loop && rate !== 0) while (!isThere()) await frames(1);
        await frames(2);
        const there = player.currentTime / duration;
        const { paused, ended } = player;
        const told = events.splice(0);
        // Whatever it did, it can be played forwards from here.
        player.playbackRate = 1;
        await player.play();
        await frames(3);
        const goesOn = loop || player.currentTime > 0 || player.ended;
        player.remove();
        return { sought, begun, there: loop ? null : there, paused, ended, events: told, goesOn };
      };
      const rows = [false, true].flatMap((loop) =>
        kinds.flatMap((kind) =>
          rates.flatMap((rate) => [0, 0.5, 1].map((share) => ({ kind, rate, share, loop }))),
        ),
      );
      return Promise.all(
        rows.map(async (row) => ({
          ...row,
          ...(await playedBy(row.kind, row.rate, row.share, row.loop)),
        })),
      );
    },
    [kinds, rates] as const,
  );
  expect(played).toHaveLength(90);
  for (const { kind, rate, share, loop, events, ...result } of played) {
    const isAtEnd = share === 1 && rate >= 0 && !loop;
    const row = `${kind}, rate ${rate}, from ${share}${loop ? ', loop' : ''}`;
    expect(result, row).toEqual({
      sought: isAtEnd ? 'true timeupdate,ended' : 'false timeupdate',
      begun: isAtEnd ? 0 : share,
      there: loop ? null : rate > 0 ? 1 : rate < 0 || isAtEnd ? 0 : share,
      paused: rate > 0 && !loop,
      ended: rate > 0 && !loop,
      goesOn: true,
    });
    const others = events.filter((type) => type !== 'timeupdate');
    expect(others, row).toEqual(rate > 0 && !loop ? ['play', 'pause', 'ended'] : ['play']);
    if (!loop) expect(events.includes('timeupdate'), row).toBe(isAtEnd || rate > 0 || rate * share < 0);
  }
});

test('clips are chosen by name, and unknown ones are named', async ({ page }) => {
  await open(page);
  await added(page, { src: '/wave.c2rig', clip: 'there and back' }, 'loadeddata');
  const durations = await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    const there = player.duration;
    player.clip = 'wave';
    return [there, player.duration, player.clips];
  });
  expect(durations).toEqual([1, 1.2, ['wave', 'there and back']]);
  const message = await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    player.clip = 'jump';
    return player.error?.message;
  });
  expect(message).toBe('There is no clip “jump”. The rig has “wave”, “there and back”.');
});

test('nothing plays automatically with reduced motion', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  await added(page, { src: '/wave.c2rig', autoplay: '', loop: '' }, 'loadeddata');
  expect(await state(page)).toEqual({ currentTime: 0, paused: true, ended: false });
  await player(page).evaluate((element) => (element as C2WarpPlayer).play());
  await expect.poll(async () => (await state(page)).currentTime).toBeGreaterThan(0);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  expect((await state(page)).paused).toBe(false);
});

test('time stands still out of sight', async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    const space = document.createElement('div');
    space.style.height = '3000px';
    document.body.append(space);
  });
  await added(page, { src: '/wave.c2rig', autoplay: '', loop: '' }, 'play');
  for (let k = 0; k < 10; k++) await page.evaluate(() => new Promise(requestAnimationFrame));
  expect(await state(page)).toEqual({ currentTime: 0, paused: false, ended: false });
  await player(page).scrollIntoViewIfNeeded();
  await expect.poll(async () => (await state(page)).currentTime).toBeGreaterThan(0);
});

test('a damaged rig is reported, its content remains, and the page continues', async ({ page }) => {
  const altered = Buffer.from(rig);
  altered[200] = (altered[200] ?? 0) ^ 1;
  await open(page, {
    'cut.c2rig': rig.subarray(0, rig.length - 100),
    'altered.c2rig': altered,
    'page.c2rig': Buffer.from('<!doctype html>'),
    'wave.c2rig': rig,
  });
  const messages = ['cut', 'altered', 'page'].map((name) => added(page, { src: `/${name}.c2rig` }, 'error'));
  expect(await Promise.all(messages)).toEqual([
    `This rig is damaged: it has ${rig.length - 100} bytes instead of ${rig.length}.`,
    'This rig is damaged: its checksum does not match.',
    'This is not a rig.',
  ]);
  const codes = await page
    .locator('c2-warp-player')
    .evaluateAll((players) => players.map((player) => (player as C2WarpPlayer).error?.code));
  expect(codes).toEqual(['rig', 'rig', 'rig']);
  await expect(page.getByText('A gingerbread man')).toHaveCount(3);
  await expect(page.getByText('A gingerbread man').last()).toBeVisible();
  await added(page, { src: '/wave.c2rig' }, 'loadeddata');
  await expect(player(page).locator('canvas')).toBeVisible();
});

test('a moved player keeps its rig and its time', async ({ page }) => {
  await open(page);
  await added(page, { src: '/wave.c2rig' }, 'loadeddata');
  const time = await player(page).evaluate((element) => {
    const player = element as C2WarpPlayer;
    player.currentTime = 0.4;
    document.body.prepend(player);
    return new Promise(requestAnimationFrame).then(() => [player.currentTime, player.duration]);
  });
  expect(time).toEqual([0.4, 1.2]);
  expect(await heard(page)).toEqual(['loadeddata', 'timeupdate']);
});

test('the newest source wins', async ({ page }) => {
  await open(page);
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route('**/slow.c2rig', async (route) => {
    await held;
    await route.fulfill({ body: rig });
  });
  const loaded = added(page, { src: '/slow.c2rig' }, 'loadeddata');
  await expect(player(page)).toBeVisible();
  await player(page).evaluate((element) => {
    (element as C2WarpPlayer).src = '/wave.c2rig';
  });
  await loaded;
  release();
  await page.waitForResponse('**/slow.c2rig');
  expect(await heard(page)).toEqual(['loadeddata']);
});

test('a hundred players share one context, and recover from its loss', async ({ page }) => {
  await page.addInitScript(() => {
    const contexts: unknown[] = [];
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      type: string,
      options?: unknown,
    ) {
      const context = Reflect.apply(getContext, this, [type, options]);
      if (type.startsWith('webgl') && !contexts.includes(context)) contexts.push(context);
      return context;
    } as typeof getContext;
    Object.assign(globalThis, { contexts });
  });
  await open(page);
  const contexts = () => page.evaluate(() => (Reflect.get(globalThis, 'contexts') as unknown[]).length);
  const before = await contexts();
  let requests = 0;
  page.on('request', (request) => {
    if (request.url().endsWith('wave.c2rig')) requests++;
  });
  await page.evaluate(async () => {
    const players = Array.from({ length: 100 }, () => {
      const player = document.createElement('c2-warp-player');
      player.style.width = '40px';
      player.src = '/wave.c2rig';
      return player;
    });
    document.body.replaceChildren(...players);
    const isLoaded = (player: Element) =>
      new Promise((resolve) => player.addEventListener('loadeddata', resolve, { once: true }));
    await Promise.all(players.map(isLoaded));
    players.forEach((player, k) => {
      player.currentTime = k / 100;
    });
  });
  const drawn = () =>
    page.evaluate(() => {
      const isDrawn = (player: Element) => {
        const canvas = player.shadowRoot?.querySelector('canvas');
        const pixels = canvas
          ?.getContext('2d')
          ?.getImageData(0, 0, canvas.width || 1, canvas.height || 1).data;
        return pixels?.some((value) => value > 0);
      };
      return [...document.querySelectorAll('c2-warp-player')].filter(isDrawn).length;
    });
  await expect.poll(drawn).toBe(100);
  expect(requests).toBe(1);
  expect((await contexts()) - before).toBe(1);

  await page.evaluate(async () => {
    const gl = (Reflect.get(globalThis, 'contexts') as WebGL2RenderingContext[]).at(-1);
    const losing = gl?.getExtension('WEBGL_lose_context');
    const told = (type: string) =>
      new Promise((resolve) => gl?.canvas.addEventListener(type, resolve, { once: true }));
    const lost = told('webglcontextlost');
    losing?.loseContext();
    await lost;
    // It can be restored once the event is over.
    await new Promise(requestAnimationFrame);
    for (const { shadowRoot } of document.querySelectorAll('c2-warp-player')) {
      const canvas = shadowRoot?.querySelector('canvas');
      canvas?.getContext('2d')?.clearRect(0, 0, canvas.width, canvas.height);
    }
    const restored = told('webglcontextrestored');
    losing?.restoreContext();
    await restored;
  });
  await expect.poll(drawn).toBe(100);
});

test('the script of the player has no WebAssembly', async ({ request }) => {
  const script = await (await request.get('/player/c2warp-player.js')).body();
  expect(script.toString()).not.toContain('WebAssembly');
});
