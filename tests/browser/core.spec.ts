/** The built `c2warp/core`, in Node and in Chromium: its results are the command's, and the manual's examples run. */
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { APIRequestContext } from '@playwright/test';
import { decode } from 'fast-png';
import type * as Core from '../../web/src/core';
import type { WarperOptions } from '../../web/src/core';
import { builtCommand } from './command';
import { expect, test } from './fixtures';

const url = (path: string) => new URL(`../../${path}`, import.meta.url);
const MANUAL = readFileSync(url('web/docs/core.md'), 'utf8');
const [NODE_EXAMPLE = '', WORKER_EXAMPLE = '', WEIGHTS_EXAMPLE = '', DRAG_EXAMPLE = ''] = [
  ...MANUAL.matchAll(/^```js\n(.*?)^```$/gms),
].map(([, example = '']) => example);
const [, PAGE_EXAMPLE = ''] = /^```html\n(.*?)^```$/ms.exec(MANUAL) ?? [];

const PICTURE = readFileSync(url('web/public/samples/gingerbread.png'));
/** With a handle posed. */
const PROJECT = readFileSync(url('web/public/samples/gingerbread.c2warp.json'), 'utf8')
  .replace('"posed": [124, 516]', '"posed": [160, 420]')
  .replace('"src": "gingerbread.png"', '"src": "picture.png"');
const POINTS = [330, 560, 512, 700, 312, 1126, 20, 20, 160, 420, 140.25, 470.5];

let folder: string;
/** What the command says of the picture, the project and the points. */
let expected: {
  readonly pixels: string;
  readonly hash: string;
  readonly map: readonly (readonly number[])[];
  readonly inverse: readonly (readonly number[])[];
  /** From the first point. */
  readonly distances: readonly (readonly number[])[];
  readonly weights: readonly (readonly number[])[];
};

// In one worker, so that the command runs once.
test.describe.configure({ mode: 'default' });

test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'c2warp-core-'));
  writeFileSync(join(folder, 'picture.png'), PICTURE);
  writeFileSync(join(folder, 'gingerbread.png'), PICTURE);
  writeFileSync(join(folder, 'p.c2warp.json'), PROJECT);
  const pairs = Array.from({ length: POINTS.length / 2 }, (_, k) => `${POINTS[2 * k]},${POINTS[2 * k + 1]}`);
  writeFileSync(join(folder, 'points.csv'), ['x,y', ...pairs, ''].join('\n'));
  const command = builtCommand();
  const run = (...args: string[]) => {
    const { status, stdout, stderr } = spawnSync(command, args, { cwd: folder, encoding: 'utf8' });
    expect(`${stderr}${status}`).toBe('0');
    return stdout;
  };
  const numbers = (text: string, columns?: readonly number[]) => {
    const rows = text.trim().split('\n').slice(1);
    const cells = rows.map((row) => row.split(',').map((cell) => (cell === '' ? Number.NaN : Number(cell))));
    return columns ? cells.map((row) => columns.map((column) => row[column] ?? Number.NaN)) : cells;
  };
  run('warp', 'p.c2warp.json', '-o', 'warped.png');
  expected = {
    pixels: createHash('sha256')
      .update(decode(readFileSync(join(folder, 'warped.png'))).data)
      .digest('hex'),
    hash: JSON.parse(run('inspect', 'p.c2warp.json', '--json')).weights_hash,
    map: numbers(run('map', 'p.c2warp.json', '--at', 'points.csv', '-o', '-')),
    inverse: numbers(run('map', 'p.c2warp.json', '--at', 'points.csv', '--inverse', '-o', '-')),
    distances: numbers(
      run('distance', 'p.c2warp.json', '--from', '330,560', '--at', 'points.csv', '-o', '-'),
    ),
    // Without the columns about the site.
    weights: numbers(run('weights', 'p.c2warp.json', '--at', 'points.csv', '-o', '-'), [0, 1, 6]),
  };
});

test.afterAll(() => rmSync(folder, { recursive: true }));

interface Input {
  /** The addresses of the module and of the picture. */
  readonly module: string;
  readonly picture: string;
  readonly project: string;
  readonly points: readonly number[];
  readonly options: WarperOptions;
}

/** The results of the core. The page evaluates this function as well, so it uses nothing outside of it. */
async function results({ module, picture, project, points, options }: Input) {
  const { createWarper }: typeof Core = await import(module);
  const warper = await createWarper(await (await fetch(picture)).arrayBuffer(), options);
  try {
    const solution = await warper.solve(project);
    const posed = solution.pose();
    const at = Float64Array.from(points);
    const [mapped, rows] = await Promise.all([posed.map(at), solution.weights(at)]);
    const { image } = await posed.warp();
    const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', image.data));
    return {
      hash: solution.report.weights_hash,
      pixels: Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join(''),
      posed: Array.from(mapped.posed),
      det: Array.from(mapped.det),
      rest: Array.from((await posed.inverse(at)).rest),
      distances: Array.from(await solution.distances([at[0] ?? 0, at[1] ?? 0], at)),
      offsets: Array.from(rows.offsets),
      sites: Array.from(rows.sites),
      weights: Array.from(rows.weights),
    };
  } finally {
    warper.dispose();
  }
}

function expectAsCommand(found: Awaited<ReturnType<typeof results>>): void {
  expect([found.hash, found.pixels]).toEqual([expected.hash, expected.pixels]);
  const pair = (values: readonly number[], k: number) => values.slice(2 * k, 2 * k + 2);
  const rows = (columns: (k: number) => readonly (number | undefined)[]) =>
    Array.from({ length: POINTS.length / 2 }, (_, k) => [...pair(POINTS, k), ...columns(k)]);
  expect(rows((k) => [...pair(found.posed, k), found.det[k]])).toEqual(expected.map);
  expect(rows((k) => pair(found.rest, k))).toEqual(expected.inverse);
  expect(rows((k) => [found.distances[k]])).toEqual(expected.distances);
  const weights = found.sites.map((site, entry) => {
    const point = found.offsets.findLastIndex((offset) => offset <= entry);
    return [point, site, found.weights[entry]];
  });
  expect(weights).toEqual(expected.weights);
}

/** Writes the package with its core as npm would install it, from the files of the test server. */
async function installPackage(request: APIRequestContext): Promise<void> {
  const root = join(folder, 'node_modules/c2warp');
  const solver = ['web/dist/element/c2warp_bg.wasm', 'web/dist/element/c2warp_later_bg.wasm'];
  const waiting = ['web/dist/core/node.js', ...solver];
  for (const file of waiting) {
    const body = await (await request.get(file.replace('web/dist', ''))).body();
    mkdirSync(join(root, file, '..'), { recursive: true });
    writeFileSync(join(root, file), body);
    const imports = file.endsWith('.js') ? body.toString().matchAll(/"\.\/([\w-]+\.js)"/g) : [];
    for (const [, name] of imports) {
      if (!waiting.includes(`web/dist/core/${name}`)) waiting.push(`web/dist/core/${name}`);
    }
  }
  writeFileSync(join(root, 'package.json'), readFileSync(url('package.json')));
}

test('in Node its results are those of the command, and the examples run', async ({ request, baseURL }) => {
  await installPackage(request);
  const module = pathToFileURL(join(folder, 'node_modules/c2warp/web/dist/core/node.js')).href;
  const picture = `${baseURL}/samples/gingerbread.png`;
  expectAsCommand(await results({ module, picture, project: PROJECT, points: POINTS, options: {} }));
  writeFileSync(
    join(folder, 'example.mjs'),
    NODE_EXAMPLE.replace('warper.dispose();', WEIGHTS_EXAMPLE + DRAG_EXAMPLE),
  );
  const { status, stdout, stderr } = spawnSync(process.execPath, ['example.mjs'], {
    cwd: folder,
    encoding: 'utf8',
  });
  expect(`${stderr}${status}`).toBe('0');
  expect(stdout.trim().split('\n').length).toBeGreaterThan(1);
  expect(stdout.match(/triangles to draw/g)).toHaveLength(12);
  const { width, height } = decode(PICTURE);
  expect(decode(readFileSync(join(folder, 'bent.png')))).toMatchObject({ width, height, channels: 4 });
});

test('in a page its results are those of the command, with a worker and without', async ({
  page,
  baseURL,
}) => {
  // A page with the strictest policy.
  await page.goto('/strict/');
  const input = {
    module: `${baseURL}/core/core.js`,
    picture: `${baseURL}/samples/gingerbread.png`,
    project: PROJECT,
    points: POINTS,
  };
  for (const options of [{}, { worker: false }]) {
    expectAsCommand(await page.evaluate(results, { ...input, options }));
  }
});

/** The meshes of a followed drag and of its end. The page evaluates this function as well. */
async function dragged({ module, picture, project, options }: Input) {
  const { createWarper }: typeof Core = await import(module);
  const warper = await createWarper(await (await fetch(picture)).arrayBuffer(), options);
  try {
    let posed = (await warper.solve(project)).pose();
    const meshes: number[][] = [];
    const show = async () => meshes.push(Array.from((await posed.mesh()).positions));
    await show();
    for (let frame = 1; frame <= 20; frame++) {
      const hand = [160 + 37 * frame, 420 + 9 * frame] as const;
      posed = await posed.follow({ 'left-hand': { posed: hand } });
      await show();
    }
    posed = await posed.settled();
    await show();
    return meshes;
  } finally {
    warper.dispose();
  }
}

test('a drag has the same bits in Node and in a page, and no frame jumps', async ({
  page,
  request,
  baseURL,
}) => {
  await installPackage(request);
  const picture = `${baseURL}/samples/gingerbread.png`;
  const input = { picture, project: PROJECT, points: [] };
  const node = pathToFileURL(join(folder, 'node_modules/c2warp/web/dist/core/node.js')).href;
  const meshes = await dragged({ ...input, module: node, options: {} });
  const step = Math.hypot(37, 9);
  for (const [frame, mesh] of meshes.slice(1, -1).entries()) {
    const before = meshes[frame] ?? [];
    const moved = (at: number) => (mesh[at] ?? 0) - (before[at] ?? 0);
    const ways = Array.from({ length: mesh.length / 2 }, (_, k) =>
      Math.hypot(moved(2 * k), moved(2 * k + 1)),
    );
    const most = ways.reduce((a, b) => Math.max(a, b));
    expect(most, `frame ${frame}`).toBeGreaterThan(0.9 * step);
    expect(most, `frame ${frame}`).toBeLessThan(3 * step);
  }
  await page.goto('/strict/');
  for (const options of [{}, { worker: false }]) {
    const module = `${baseURL}/core/core.js`;
    expect(await page.evaluate(dragged, { ...input, module, options })).toEqual(meshes);
  }
});

test('the examples of pages and of workers run', async ({ page, baseURL }) => {
  await page.route('**/example.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<link rel="icon" href="favicon.svg" />${PAGE_EXAMPLE}`,
    }),
  );
  await page.route('**/worker_example.js', (route) =>
    route.fulfill({ contentType: 'text/javascript', body: WORKER_EXAMPLE }),
  );
  await page.route(/\/gingerbread\.(?:png|c2warp\.json)$/, async (route) => {
    const file = new URL(route.request().url()).pathname.replace(/^.*\//, '/samples/');
    await route.fulfill({ response: await route.fetch({ url: `${baseURL}${file}` }) });
  });
  await page.goto('/example.html');
  const { width, height } = decode(PICTURE);
  await expect(page.locator('canvas')).toHaveJSProperty('width', width);
  const size = await page.evaluate(async (project) => {
    const worker = new Worker('worker_example.js', { type: 'module' });
    const picture = await createImageBitmap(await (await fetch('gingerbread.png')).blob());
    return new Promise<readonly number[]>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<ImageData>) => resolve([data.width, data.height]);
      worker.onerror = ({ message }) => reject(new Error(message));
      worker.postMessage({ picture, project }, [picture]);
    });
  }, PROJECT);
  expect(size).toEqual([width, height]);
});
