import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { decode, encode } from 'fast-png';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { initSync, PosedPicture as ModulePicture, Session } from '../compute/generated/c2warp';
import { copiedOut } from '../compute/solver_service';
import { createPosedPicture } from '../compute/wasm_picture';
import { createWarper, encodePng, type Warper } from '../core_node';
import { type Handle, type Project, posedHandle } from '../document/project';
import type { C2WarpError } from '../error';
import { pngChunk } from '../io/png_chunk';

const file = (name: string) => readFileSync(new URL(`../../public/samples/${name}`, import.meta.url));

const SIZE = 64;
const pixels = () => ({ width: SIZE, height: SIZE, data: new Uint8ClampedArray(4 * SIZE * SIZE).fill(255) });
const HANDLES = [
  { id: 'left', kind: 'point', rest: [16, 32] },
  { id: 'right', kind: 'point', rest: [48, 32], posed: [48, 24] },
] as const;
const PROJECT = { handles: HANDLES, samples: 500 };

/** The hand is raised by 100 pixels in a second. */
const WAVE = {
  name: 'wave',
  duration: 1,
  loop: 'none',
  tracks: [
    {
      handle: 'left-hand',
      keys: [
        { time: 0, posed: [124, 516], ease: 'linear' },
        { time: 1, posed: [124, 416], ease: 'linear' },
      ],
    },
  ],
} as const;
const GINGERBREAD_HAND = [124, 516] as const;
const GINGERBREAD = { ...JSON.parse(file('gingerbread.c2warp.json').toString('utf8')), clips: [WAVE] };
const FRAMES = 20;

/** The hand's position at a frame of a drag across the figure. */
const placeOf = (frame: number): readonly [number, number] => {
  const [x, y] = GINGERBREAD_HAND;
  return [x + ((900 - x) * frame) / FRAMES, y + ((600 - y) * frame) / FRAMES];
};
const dragged = (frame: number) => ({ 'left-hand': { posed: placeOf(frame) } });

/** The longest way of a vertex, in pixels. */
const mostMoved = (from: Float32Array, to: Float32Array) =>
  Array.from({ length: from.length / 2 }, (_, k) => {
    const [x, y] = [2 * k, 2 * k + 1].map((at) => (to[at] ?? 0) - (from[at] ?? 0));
    return Math.hypot(x ?? 0, y ?? 0);
  }).reduce((most, way) => Math.max(most, way), 0);

const open: Warper[] = [];

async function warper(picture: Parameters<typeof createWarper>[0] = pixels()): Promise<Warper> {
  const created = await createWarper(picture);
  open.push(created);
  return created;
}

afterEach(() => {
  for (const warper of open.splice(0)) warper[Symbol.dispose]();
  vi.restoreAllMocks();
});

/** The picture of a solution as a page has it. */
async function pagePicture(project: Project) {
  const { width, height, data } = decode(file('gingerbread.png'));
  const session = new Session();
  session.set_picture(width, height, new Uint8Array(data));
  session.begin(JSON.stringify(project));
  while (session.advance() !== undefined);
  const picture = createPosedPicture(copiedOut(session.solution()), project);
  session.free();
  return picture;
}

const codeOf = async (work: Promise<unknown>) =>
  work.then(
    () => 'done',
    (error: C2WarpError) => error.code,
  );

describe('createWarper in Node', () => {
  it('solves, poses, maps both ways and draws', async () => {
    const own = await warper();
    expect([own.width, own.height]).toEqual([SIZE, SIZE]);
    const stages: string[] = [];
    const solution = await own.solve(PROJECT, { onProgress: (stage) => stages.push(stage) });
    expect(stages).toEqual(['domain', 'sampling', 'regions', 'weights']);
    expect(solution.report.point_handles).toBe(2);
    expect(Array.from(solution.sites.rest.subarray(0, 4))).toEqual([16, 32, 48, 32]);

    const places = Float64Array.of(48, 32, 20, 40, 99, 5);
    const posed = solution.pose();
    const mapped = await posed.map(places);
    expect(Array.from(mapped.posed.subarray(0, 2))).toEqual([48, 24]);
    expect(mapped.det[0]).toBeGreaterThan(0);
    expect(Array.from(mapped.posed.subarray(4))).toEqual([Number.NaN, Number.NaN]);
    const { rest } = await posed.inverse(mapped.posed.subarray(0, 4));
    for (const [k, value] of rest.entries()) expect(value).toBeCloseTo(places[k] ?? 0, 1);

    const weights = await solution.weights(places);
    expect(weights.offsets[3]).toBe(weights.offsets[2]);
    const sum = weights.weights.subarray(weights.offsets[1], weights.offsets[2]).reduce((a, b) => a + b, 0);
    expect(sum).toBeCloseTo(1, 12);

    const mesh = await posed.mesh();
    expect(mesh.positions).toHaveLength(solution.mesh.positions.length);
    expect(mesh.folds).toHaveLength(0);
    const folded = { id: 'right', kind: 'point', rest: [48, 32], posed: [4, 30] } as const;
    const { folds } = await solution.pose({ right: { posed: folded.posed } }).mesh();
    const counted = (await (await warper()).solve({ ...PROJECT, handles: [HANDLES[0], folded] })).report;
    expect(counted.folded_triangles).toBeGreaterThan(0);
    expect(folds).toHaveLength(3 * counted.folded_triangles);
    const parts: number[] = [];
    const { image, origin } = await posed.warp({ scale: 2, onProgress: (part) => parts.push(part) });
    expect([image.width, image.height, image.data.length, ...origin]).toEqual([
      128,
      128,
      128 * 128 * 4,
      0,
      0,
    ]);
    expect(parts.at(-1)).toBe(1);
    const grown = await solution.pose({ right: { posed: [60, 10] } }).warp({ area: 'grown' });
    expect(grown.image.height).toBeGreaterThan(SIZE);
    expect(grown.origin[1]).toBeGreaterThan(0);
  });

  it('answers questions about many points in batches', async () => {
    const solution = await (await warper()).solve(PROJECT);
    const one = Float64Array.of(20, 40);
    const many = new Float64Array(2 * 70_000);
    for (let at = 0; at < many.length; at += 2) many.set(one, at);
    const [single, all] = [await solution.weights(one), await solution.weights(many)];
    const entries = single.sites.length;
    expect(all.offsets.every((offset, point) => offset === point * entries)).toBe(true);
    expect(all.sites.every((site, k) => site === single.sites[k % entries])).toBe(true);
    expect(all.weights.every((weight, k) => weight === single.weights[k % entries])).toBe(true);
  });

  it('measures distances inside the domain, along the paths that it returns', async () => {
    // An angle, and an island beside it.
    const rings = [
      [
        [0, 0],
        [64, 0],
        [64, 64],
        [32, 64],
        [32, 32],
        [0, 32],
      ],
      [
        [4, 40],
        [24, 40],
        [24, 60],
        [4, 60],
      ],
    ] as const;
    const solution = await (await warper()).solve({ samples: 500, domain: { kind: 'polygon', rings } });
    const from = [8, 28] as const;
    const points = Float64Array.of(8, 8, 36, 60, 10, 50, 4, 36, 8, 28);
    const around = Math.hypot(24, 4) + Math.hypot(4, 28);
    const distances = await solution.distances(from, points);
    expect(distances[0]).toBe(20);
    expect(distances[1]).toBeCloseTo(around, 9);
    expect(Array.from(distances.subarray(2))).toEqual([Number.POSITIVE_INFINITY, Number.NaN, 0]);
    expect(Array.from(await solution.path(from, [36, 60]))).toEqual([8, 28, 32, 32, 36, 60]);
    expect(await solution.path(from, [10, 50])).toHaveLength(0);
    expect(await codeOf(solution.distances([4, 36], points))).toBe('point-outside');
    expect(await codeOf(solution.path([4, 36], from))).toBe('point-outside');
    expect(await codeOf(solution.distances(from, new Float64Array(3)))).toBe('points');
  });

  it('explains a solve', async () => {
    const solution = await (await warper()).solve({
      samples: 500,
      handles: [HANDLES[0], { ...HANDLES[1], rest: [22, 32] }],
    });
    const study = await solution.study();
    expect(study.outline).toHaveLength(1);
    expect(study.sites.flatMap(({ rest }) => rest)).toEqual(Array.from(solution.sites.rest));
    expect(study.sites.map(({ handle }) => handle)).toEqual(Array.from(solution.sites.handle));
    expect([study.falloff[0], study.falloff.at(-1)]).toEqual([1, 0]);
    expect(study.rounds.map(({ score }) => score)).toEqual(solution.report.scores);
    expect(study.rounds.length).toBeGreaterThan(1);
    expect(study.rounds.at(-1)?.score).toBeLessThanOrEqual(study.allowed_score);
    const [cell] = study.sites;
    const path = await solution.path([16, 32], cell?.to_farthest.at(-1) ?? [0, 0]);
    expect(Array.from(path)).toEqual(cell?.to_farthest.flat());
  });

  it('poses by clips', async () => {
    const clips = [
      {
        name: 'up',
        duration: 1,
        loop: 'none',
        tracks: [
          {
            handle: 'right',
            keys: [
              { time: 0, posed: [48, 32] },
              { time: 1, posed: [48, 20] },
            ],
          },
        ],
      },
    ] as const;
    const solution = await (await warper()).solve({ ...PROJECT, clips });
    const { posed } = await solution.clip('up', 1).map(Float64Array.of(48, 32));
    expect(Array.from(posed)).toEqual([48, 20]);
    expect(() => solution.clip('down', 0)).toThrow('There is no clip "down".');
    expect(() => solution.clip('up', Number.NaN)).toThrow('seconds');
  });

  it('follows a drag without jumps, comes to rest, and is exactly at rest at home', async () => {
    const solution = await (await warper(file('gingerbread.png'))).solve(GINGERBREAD);
    const home = GINGERBREAD_HAND;
    const step = Math.hypot(900 - home[0], 600 - home[1]) / FRAMES;
    let posed = solution.pose();
    const rest = (await posed.mesh()).positions;
    let [followed, alone] = [rest, rest];
    let [farthest, farthestAlone] = [0, 0];
    for (let frame = 1; frame <= FRAMES; frame++) {
      posed = await posed.follow(dragged(frame));
      const next = (await posed.mesh()).positions;
      farthest = Math.max(farthest, mostMoved(followed, next));
      const jumping = (await solution.pose(dragged(frame)).mesh()).positions;
      farthestAlone = Math.max(farthestAlone, mostMoved(alone, jumping));
      [followed, alone] = [next, jumping];
    }
    expect(farthest).toBeLessThan(3 * step);
    expect(farthest).toBeGreaterThan(0.9 * step);
    // Without the frame before, this drag jumps.
    expect(farthestAlone).toBeGreaterThan(3 * step);

    const settled = await posed.settled();
    const place = Float64Array.from(home);
    expect(Array.from((await settled.map(place)).posed)).toEqual([900, 600]);
    const { positions } = await settled.mesh();
    expect(mostMoved(positions, followed)).toBeGreaterThan(0.1);
    const again = await settled.settled();
    expect(mostMoved((await again.mesh()).positions, positions)).toBeLessThan(0.01);

    for (let frame = FRAMES - 1; frame >= 0; frame--) posed = await posed.follow(dragged(frame));
    expect((await (await posed.settled()).mesh()).positions).toEqual(rest);
  }, 30_000);

  it('follows poses with the bits of the page', async () => {
    const shapes = { core: [] as Float64Array[], page: [] as Float64Array[] };
    const [next, shape] = [Session.prototype.next_pose, ModulePicture.prototype.motion_numbers];
    vi.spyOn(Session.prototype, 'next_pose').mockImplementation(function (this: Session, ...given) {
      shapes.core.push(next.apply(this, given).slice());
      return shapes.core.at(-1)?.slice() ?? new Float64Array();
    });
    vi.spyOn(ModulePicture.prototype, 'motion_numbers').mockImplementation(function (this: ModulePicture) {
      const found = shape.call(this);
      if (found) shapes.page.push(found.slice());
      return found;
    });
    const own = await warper(file('gingerbread.png'));
    const solution = await own.solve(GINGERBREAD);
    let posed = await solution.clip('wave', 0.4).follow({ head: { depth: 1 } });
    for (let frame = 1; frame <= 5; frame++) posed = await posed.follow(dragged(frame));
    await posed.settled();

    const { clips, ...rest } = solution.project;
    const project: Project = { ...rest, handles: solution.project.handles.map(posedHandle) };
    initSync({ module: readFileSync(new URL('../compute/generated/c2warp_bg.wasm', import.meta.url)) });
    const picture = await pagePicture(project);
    const [clip] = clips ?? [];
    if (!clip) throw new Error('the project has a clip');
    const playback = picture.playback(clip, project);
    const [x, y] = GINGERBREAD_HAND;
    const at = (place: readonly [number, number], depth?: number): Project => {
      const placed = (handle: Handle): Handle => {
        if (handle.id === 'left-hand') return { ...handle, posed: place } as Handle;
        return handle.id === 'head' && depth !== undefined ? { ...handle, depth } : handle;
      };
      return { ...project, handles: project.handles.map(placed) };
    };
    const moment = at([x, y - 40]);
    let pose = picture.pose(at([x, y - 40], 1), playback.pose(moment, 0.4));
    for (let frame = 1; frame <= 5; frame++) pose = picture.pose(at(placeOf(frame), 1), pose);
    picture.settled(pose);
    // The page also asked for the shape at the moment of the clip.
    expect(shapes.core).toEqual(shapes.page.slice(1));
    expect(shapes.core).toHaveLength(7);
    picture.free();
  });

  it('follows in the Elastic mode as it poses, and rejects unknown handles', async () => {
    const solution = await (await warper()).solve({ ...PROJECT, pose: { mode: 'harmonic' } });
    const at = { left: { posed: [20, 30], rotation: 15, scale: 1.5 } } as const;
    const start = solution.pose({ left: { posed: [10, 50] } });
    const next = await start.follow(at);
    const expected = await solution.pose(at).mesh();
    expect(await next.mesh()).toEqual(expected);
    expect(await (await next.settled()).mesh()).toEqual(expected);
    // The handle that is left out stays.
    const right = await next.follow({ right: { posed: [50, 50] } });
    const { posed } = await right.map(Float64Array.of(16, 32, 48, 32));
    expect(Array.from(posed)).toEqual([20, 30, 50, 50]);

    await expect(next.follow({ nobody: {} })).rejects.toThrow('There is no handle "nobody".');
    expect(await codeOf(next.follow({ nobody: {} }))).toBe('pose');
    expect(await codeOf(next.follow({ left: { scale: -1 } }))).toBe('project');
    const reason = new Error('enough');
    const signal = AbortSignal.abort(reason);
    expect(await next.follow({}, { signal }).catch((error) => error)).toBe(reason);
    expect(await next.settled({ signal }).catch((error) => error)).toBe(reason);
  });

  it('rejects bad input with a code and continues', async () => {
    const bytes = file('gingerbread.png');
    expect(await codeOf(createWarper(new Uint8Array(0)))).toBe('picture');
    expect(await codeOf(createWarper(bytes.subarray(0, 5000)))).toBe('picture');
    expect(await codeOf(createWarper({ ...pixels(), width: 63 }))).toBe('picture');
    expect(await codeOf(createWarper({ width: 1, height: 1, data: new Uint8Array(4) }))).toBe('picture');
    await expect(createWarper(Uint8Array.of(0xff, 0xd8, 0xff, 0xe0))).rejects.toThrow(
      'This is a JPEG picture, but in Node only PNG is supported.',
    );
    const damaged = Uint8Array.from(bytes);
    damaged[2000] = 1 - (damaged[2000] ?? 0);
    expect(await codeOf(createWarper(damaged))).toBe('picture');

    const own = await warper();
    expect(await codeOf(own.solve('{'))).toBe('project');
    expect(await codeOf(own.solve('null'))).toBe('project');
    await expect(own.solve({ handles: [{ ...HANDLES[0], rest: [Number.NaN, 1] }] })).rejects.toThrow(
      'handles[0].rest[0]',
    );
    const stray = { id: 'stray', kind: 'point', rest: [99, 1] } as const;
    expect(await codeOf(own.solve({ handles: [stray] }))).toBe('handle-outside');
    const solution = await own.solve(PROJECT);
    expect(() => solution.pose({ nobody: {} })).toThrow('There is no handle "nobody".');
    expect(await codeOf(solution.pose({ left: { scale: -1 } }).warp())).toBe('project');
    expect(await codeOf(solution.pose().warp({ scale: 0 }))).toBe('scale');
    expect(await codeOf(solution.pose().map(new Float64Array(3)))).toBe('points');
    own.dispose();
    expect(await codeOf(solution.pose().warp())).toBe('engine');
  });

  it('stops at a signal, and solves one project after another', async () => {
    const own = await warper();
    const reason = new Error('enough');
    expect(await own.solve(PROJECT, { signal: AbortSignal.abort(reason) }).catch((e) => e)).toBe(reason);
    const stopping = new AbortController();
    const stopped = own.solve(PROJECT, {
      signal: stopping.signal,
      onProgress: () => stopping.abort(reason),
    });
    const [, first, second] = await Promise.all([
      stopped.catch((error) => expect(error).toBe(reason)),
      own.solve({ ...PROJECT, handles: HANDLES.slice(0, 1) }),
      own.solve(PROJECT),
    ]);
    expect([first, second].map(({ report }) => report.point_handles)).toEqual([1, 2]);
    const drawing = new AbortController();
    const drawn = second.pose().warp({
      scale: 16,
      signal: drawing.signal,
      onProgress: () => drawing.abort(reason),
    });
    expect(await drawn.catch((error) => error)).toBe(reason);
    expect((await first.pose().warp()).image.width).toBe(SIZE);
  });

  it('continues with a new instance after a panic', async () => {
    const [own, other] = [await warper(), await warper()];
    const solution = await other.solve(PROJECT);
    const before = await solution.pose().warp();
    vi.spyOn(Session.prototype, 'advance').mockImplementationOnce(() => {
      throw new WebAssembly.RuntimeError('unreachable');
    });
    expect((await own.solve(PROJECT)).report.point_handles).toBe(2);
    expect((await solution.pose().warp()).image.data).toEqual(before.image.data);
    vi.spyOn(Session.prototype, 'weights').mockImplementation(() => {
      throw new WebAssembly.RuntimeError('unreachable');
    });
    expect(await codeOf(solution.weights(Float64Array.of(1, 1)))).toBe('too-much');
    expect((await own.solve(PROJECT)).report.point_handles).toBe(2);
  });
});

describe('pictures in Node', () => {
  it('are decoded from PNG files of all kinds, and written again', async () => {
    const rgba = Uint8Array.from({ length: 4 * 4 * 4 }, (_, k) => (k * 37) % 256);
    const png = encode({ width: 4, height: 4, data: rgba, channels: 4 });
    const { image } = await (await (await warper(png)).solve({})).pose().warp();
    expect(Array.from(image.data)).toEqual(Array.from(rgba));
    const again = await (await (await warper(await encodePng(image))).solve({})).pose().warp();
    expect(again.image.data).toEqual(image.data);
    const deep = Uint16Array.from({ length: 4 * 4 }, (_, k) => k * 4369);
    const grey = encode({ width: 4, height: 4, data: deep, channels: 1, depth: 16 });
    const drawn = await (await (await warper(grey)).solve({})).pose().warp();
    expect(Array.from(drawn.image.data.subarray(4, 12))).toEqual([17, 17, 17, 255, 34, 34, 34, 255]);
  });

  it('are unfolded to the size of their pixels, and without their profile', async () => {
    const plain = encode({ width: 4, height: 4, data: new Uint8Array(64).fill(255), channels: 4 });
    const many = (bytes: number) => deflateSync(Buffer.alloc(bytes));
    const file = (pixels: Uint8Array, profile: Uint8Array) =>
      Buffer.concat([
        plain.subarray(0, 33),
        pngChunk('iCCP', [Buffer.from('x\0\0'), profile]),
        pngChunk('IDAT', [pixels]),
        pngChunk('IEND', []),
      ]);
    const rows = many(4 * 17);
    // A decoder of the profile would find it damaged.
    const { width } = await warper(new Uint8Array(file(rows, many(9).subarray(0, 7))));
    expect(width).toBe(4);
    await expect(createWarper(new Uint8Array(file(many(1 << 24), rows)))).rejects.toThrow(
      'The picture is damaged: its pixels unfold to more than its size.',
    );
  });

  it('are decoded by a function of the program', async () => {
    const own = await createWarper(Uint8Array.of(1, 2, 3), { decode: (bytes) => ({ ...pixels(), bytes }) });
    open.push(own);
    expect([own.width, own.height]).toEqual([SIZE, SIZE]);
  });
});
