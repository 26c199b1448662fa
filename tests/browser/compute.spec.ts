/** The engine: solves in the worker, superseded requests, and workers that die. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { decode, encode } from 'fast-png';
import type { Project } from '../../web/src/document/project';
import { builtCommand } from './command';
import { waved } from './displacements';
import { expect, test } from './fixtures';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));
const SAMPLE = path('../../web/public/samples/gingerbread.c2warp.json');
const PICTURE = path('../../web/public/samples/gingerbread.png');

const project: Project = {
  format: 'c2warp/1',
  image: { src: 'drawn.png', width: 256, height: 256 },
  samples: 3000,
  handles: [
    { id: 'left', kind: 'point', rest: [40, 128], posed: [30, 128] },
    { id: 'island', kind: 'point', rest: [208, 128], posed: [216, 140] },
  ],
};
const outside: Project = {
  ...project,
  handles: [{ id: 'stray', kind: 'point', rest: [250, 10], posed: [250, 10] }],
};

test.beforeEach(async ({ page }) => {
  await page.goto('/harness/');
});

test('a solve reports its stages and returns consistent arrays', async ({ page }) => {
  const result = await page.evaluate(async (project) => {
    const engine = await harness.startedEngine();
    const stages: string[] = [];
    const solution = await engine.solve(project, (stage) => stages.push(stage));
    const { motions } = engine.posedPicture(solution, project).pose(project);
    const vertices = solution.positions.length / 2;
    const rowSums = Array.from({ length: vertices }, (_, v) =>
      solution.weights.subarray(solution.offsets[v], solution.offsets[v + 1]).reduce((sum, w) => sum + w, 0),
    );
    return {
      stages,
      vertices,
      rows: solution.offsets.length - 1,
      entries: [solution.sites.length, solution.weights.length, solution.offsets.at(-1)],
      motions: motions.length / 12,
      sites: [solution.siteRest.length / 2, solution.siteHandle.length],
      furthestSum: Math.max(...rowSums.filter((sum) => sum > 0).map((sum) => Math.abs(sum - 1))),
      largestVertex: solution.triangles.reduce((most, v) => Math.max(most, v), 0),
      report: solution.report,
    };
  }, project);
  expect(result.stages).toEqual(['domain', 'sampling', 'regions', 'weights']);
  expect(result.rows).toBe(result.vertices);
  expect(new Set(result.entries).size).toBe(1);
  expect(result.sites).toEqual([result.motions, result.motions]);
  expect(result.furthestSum).toBeLessThan(1e-5);
  expect(result.largestVertex).toBeLessThan(result.vertices);
  expect(result.report).toMatchObject({ islands: 2, holes: 2, point_handles: 2, real_sites: 2 });
});

test('a newer solve supersedes an older one, queued or running', async ({ page }) => {
  const outcomes = await page.evaluate(async (project) => {
    const engine = await harness.startedEngine();
    const named = (promise: Promise<unknown>) =>
      promise.then(
        () => 'solved',
        (error: Error) => error.name,
      );
    const queued = named(engine.solve(project));
    let newest: Promise<string> | undefined;
    const running = new Promise<string>((resolve) => {
      const solve: Promise<string> = named(
        engine.solve(project, () => {
          newest ??= named(engine.solve(project));
        }),
      );
      void solve.then(resolve);
    });
    return [await queued, await running, await newest];
  }, project);
  expect(outcomes).toEqual(['AbortError', 'AbortError', 'solved']);
});

test('a rejected project states the reason, and the next solve works', async ({ page }) => {
  const [refused, code, handles, next] = await page.evaluate(
    async ([outside, project]) => {
      const engine = await harness.startedEngine();
      const error = await engine
        .solve(outside)
        .catch((reason: Error & { code?: string; handles?: string[] }) => reason);
      const solution = await engine.solve(project);
      return error instanceof Error
        ? [error.message, error.code, error.handles, solution.positions.length > 0]
        : ['solved', '', [], false];
    },
    [outside, project] as const,
  );
  expect(code).toBe('handle-outside');
  expect(refused).toContain('stray');
  expect(handles).toEqual(['stray']);
  expect(next).toBe(true);
});

test('a project file is parsed strictly, and errors name the key', async ({ page }) => {
  const [good, bad] = await page.evaluate(async (project) => {
    const engine = await harness.startedEngine();
    const checked = engine.checkProject(JSON.stringify(project));
    try {
      engine.checkProject(
        JSON.stringify({ ...project, handles: [{ ...project.handles[0], rest: ['x', 1] }] }),
      );
    } catch (error) {
      return [checked, { message: String(error), code: (error as { code?: string }).code }] as const;
    }
    return [checked, undefined] as const;
  }, project);
  expect(good.handles).toHaveLength(2);
  expect(bad?.message).toContain('handles[0].rest[0]');
  expect(bad?.code).toBe('project');
});

test('a worker that dies is replaced, and its requests are repeated', async ({ page }) => {
  const result = await page.evaluate(async (project) => {
    const workers: Worker[] = [];
    const OriginalWorker = globalThis.Worker;
    globalThis.Worker = class extends OriginalWorker {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        workers.push(this);
      }

      override postMessage(message: { readonly name?: string }, options?: object): void {
        super.postMessage(message, options);
        if (message.name === 'draw') asked();
      }
    };
    let asked = () => {};
    const isAsked = new Promise<void>((resolve) => {
      asked = resolve;
    });
    const death = { kind: 'died', started: true, message: 'unreachable' };
    const dies = () => workers.at(-1)?.dispatchEvent(new MessageEvent('message', { data: death }));
    const engine = await harness.startedEngine();
    await engine.solve(project);
    // Dies during the request, since finished requests are not repeated.
    let died = false;
    const again = engine.solve(project, () => {
      if (!died) dies();
      died = true;
    });
    const vertices = (await again).positions.length;
    const twice = harness.drawnPixels(engine, project).catch((error: { code?: string }) => error.code);
    await isAsked;
    dies();
    dies();
    const code = await twice;
    const afterwards = (await engine.solve(project)).positions.length;
    return { vertices, code, afterwards, workers: workers.length };
  }, project);
  expect(result.vertices).toBeGreaterThan(0);
  expect(result.afterwards).toBe(result.vertices);
  expect(result.code).toBe('too-much');
  expect(result.workers).toBe(4);
});

test('exports have any scale and straight alpha', async ({ page }) => {
  const sizes = await page.evaluate(async (project) => {
    const engine = await harness.startedEngine();
    const [whole, half] = [
      await harness.drawnPixels(engine, project),
      await harness.drawnPixels(engine, project, 0.5),
    ];
    return [whole, half].map(({ width, height, rgba }) => [width, height, rgba.length]);
  }, project);
  expect(sizes).toEqual([
    [256, 256, 256 * 256 * 4],
    [128, 128, 128 * 128 * 4],
  ]);
});

test('a new picture supersedes an export that has not begun', async ({ page }) => {
  const [older, newer] = await page.evaluate(async (project) => {
    const engine = await harness.startedEngine();
    const first = harness.drawnPixels(engine, project).then(
      () => 'warped',
      (error: Error) => error.name,
    );
    engine.setPicture(harness.pixelSource(256, 256, new Uint8Array(256 * 256 * 4).fill(255)));
    const { rgba } = await harness.drawnPixels(engine, { ...project, handles: [] });
    return [await first, rgba[0]];
  }, project);
  expect([older, newer]).toEqual(['AbortError', 255]);
});

/** Returns the output of the command. */
function native(args: readonly string[]): string {
  const options = { cwd: path('../..'), encoding: 'utf8', maxBuffer: 1 << 28 } as const;
  const { stdout, stderr } = spawnSync(builtCommand(), args, options);
  expect(stderr).toBe('');
  return stdout;
}

/** Returns the rows of a CSV table, without its header. */
const rows = (csv: string) =>
  csv
    .trim()
    .split('\n')
    .slice(1)
    .map((line) => line.split(','));

test.describe('compared with the command line', () => {
  test.describe.configure({ timeout: 1_200_000 });

  const solvedInPage = (page: Page, text: string) =>
    page.evaluate(async (text) => {
      const file = await (await fetch('/samples/gingerbread.png')).blob();
      const picture = await harness.decodePicture(file);
      const engine = await harness.Engine.start();
      engine.setPicture(picture);
      const project = engine.checkProject(text);
      const solution = await engine.solve(project);
      const { motions } = engine.posedPicture(solution, project).pose(project);
      return { report: solution.report, motions: [...motions] };
    }, text);

  test('native code and WebAssembly give the same weights, bit for bit', async ({ page }) => {
    const told = native(['inspect', SAMPLE, '--json']);
    const { report } = await solvedInPage(page, readFileSync(SAMPLE, 'utf8'));
    expect(report.weights_hash).toMatch(/^[0-9a-f]{8,}$/);
    expect(report.weights_hash).toBe(JSON.parse(told).weights_hash);
  });

  test('native code and WebAssembly warp a displaced picture equally, bit for bit', async ({ page }) => {
    const [width, height] = [160, 120];
    const data = Uint8Array.from({ length: width * height * 3 }, (_, at) => (at * at * 7 + at * 31) % 256);
    const file = encode({ width, height, data, channels: 3 });
    const text = JSON.stringify(
      waved(
        {
          format: 'c2warp/1',
          image: { src: 'noise.png', width, height },
          domain: { kind: 'image' },
          samples: 2000,
          handles: [
            { id: 'left', kind: 'point', rest: [30, 60], posed: [36, 50], rotation: 15 },
            { id: 'right', kind: 'point', rest: [130, 60], posed: [120, 70] },
          ],
        },
        4,
      ),
    );
    const dir = mkdtempSync(join(tmpdir(), 'c2warp-'));
    writeFileSync(join(dir, 'noise.png'), file);
    writeFileSync(join(dir, 'a.c2warp.json'), text);
    const expected = (project: string, name: string) => {
      writeFileSync(join(dir, name), project);
      native(['warp', join(dir, name), '-o', join(dir, 'out.png')]);
      return Buffer.from(decode(readFileSync(join(dir, 'out.png'))).data as Uint8Array);
    };
    const byCommand = expected(text, 'a.c2warp.json');
    const { displacement: _, ...resting } = JSON.parse(text) as Project;
    expect(byCommand.equals(expected(JSON.stringify(resting), 'b.c2warp.json'))).toBe(false);
    rmSync(dir, { recursive: true });
    const inPage = await page.evaluate(
      async ([text, file]) => {
        const engine = await harness.Engine.start();
        engine.setPicture(await harness.decodePicture(new Blob([Uint8Array.from(file)])));
        return [...(await harness.drawnPixels(engine, engine.checkProject(text))).rgba];
      },
      [text, [...file]] as const,
    );
    expect(Buffer.from(inPage).equals(byCommand)).toBe(true);
  });

  test('native code and WebAssembly pose a picture equally, in 32 bits', async ({ page }) => {
    const project = JSON.parse(readFileSync(SAMPLE, 'utf8')) as Project;
    const handles = project.handles.map((handle) =>
      handle.id === 'left-hand' ? { ...handle, posed: [220, 360] } : handle,
    );
    const text = JSON.stringify({ ...project, handles });
    const { motions } = await solvedInPage(page, text);
    const dir = mkdtempSync(join(tmpdir(), 'c2warp-'));
    const [file = '', points = ''] = ['posed.c2warp.json', 'points.csv'].map((name) => join(dir, name));
    writeFileSync(file, text);
    const steps = Array.from({ length: 60 }, (_, step) => 10 + 20 * step);
    const grid = steps.flatMap((y) => steps.map((x) => [x, y] as const));
    writeFileSync(points, `x,y\n${grid.map((point) => point.join(',')).join('\n')}\n`);
    const table = (command: string) =>
      rows(native([command, file, '--image', PICTURE, '--at', points, '-o', '-']));
    // Eq. 1, with the motions of the page and the weights of the command line.
    const expected = grid.map(() => ({ x: 0, y: 0, moved: false }));
    for (const [point, site, , , , , weight] of table('weights')) {
      const at = Number(point);
      const sum = expected[at];
      const [x = 0, y = 0] = grid[at] ?? [];
      const [a = 0, b = 0, c = 0, d = 0, restX = 0, restY = 0, posedX = 0, posedY = 0] = motions.slice(
        12 * Number(site),
      );
      if (!sum) throw new Error(`no point ${at}`);
      sum.x += Number(weight) * (posedX + a * (x - restX) + c * (y - restY));
      sum.y += Number(weight) * (posedY + b * (x - restX) + d * (y - restY));
      sum.moved = true;
    }
    const off = table('map').map(([, , x, y], at) => {
      const { x: inX = 0, y: inY = 0, moved } = expected[at] ?? {};
      return moved ? Math.hypot(Number(x) - inX, Number(y) - inY) : 0;
    });
    expect(expected.filter(({ moved }) => moved).length).toBeGreaterThan(1000);
    // 32-bit numbers near 1000 are 6e-5 apart, and some of them are summed.
    expect(Math.max(...off)).toBeLessThan(5e-4);
    rmSync(dir, { recursive: true });
  });
});
