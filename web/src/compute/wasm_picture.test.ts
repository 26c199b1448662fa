import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { newProject, openDocument } from '../document/document';
import { addHandle, moveHandles } from '../document/edits';
import { rotationOf } from '../document/handle';
import type { Clip, Handle, Project } from '../document/project';
import { initSync, Session } from './generated/c2warp';
import type { PosedPicture } from './posed_picture';
import { copiedOut } from './solver_service';
import { createPosedPicture } from './wasm_picture';

const SIZE = 64;

const point = (id: string, x: number, y: number): Handle => ({
  id,
  kind: 'point',
  rest: [x, y],
  posed: [x, y],
});

const document = [point('left', 16, 32), point('right', 48, 32), point('top', 32, 8)].reduce(addHandle, {
  ...openDocument(newProject({ src: '', width: SIZE, height: SIZE }, null)),
});
const solved: Project = { ...document.project, samples: 500 };
const moved = (id: string, x: number, y: number): Project =>
  moveHandles({ ...document, project: solved }, [id], [x, y]).project;

function pictureOf(project: Project): PosedPicture {
  const session = new Session();
  session.set_picture(SIZE, SIZE, new Uint8Array(4 * SIZE * SIZE).fill(255));
  session.begin(JSON.stringify(project));
  while (session.advance() !== undefined);
  const picture = createPosedPicture(copiedOut(session.solution()), project);
  session.free();
  return picture;
}

describe('a posed picture', () => {
  let picture: PosedPicture;
  beforeAll(() => {
    initSync({ module: readFileSync(new URL('./generated/c2warp_bg.wasm', import.meta.url)) });
    picture = pictureOf(solved);
  });

  it('takes the stiffness of a project without a solve, and gives it back', () => {
    const soft = moved('top', 14, 10);
    // The lower half is stiff.
    const stiff: Project = { ...soft, stiffness: { width: 1, height: 2, values: 'AP8=' } };
    const before = picture.pose(soft).motions.slice();
    const after = picture.pose(stiff).motions.slice();
    expect(after).not.toEqual(before);
    const own = pictureOf({ ...solved, stiffness: { width: 1, height: 2, values: 'AP8=' } });
    expect(own.pose(stiff).motions).toEqual(after);
    expect(own.pose(soft).motions).toEqual(before);
    expect(picture.pose(soft).motions).toEqual(before);
    own.free();
  });

  it('knows how stiff each vertex is, by the mask and by polygons', () => {
    const ring = [
      [8, 8],
      [24, 8],
      [24, 24],
    ] as const;
    const shell: Handle = { id: 'shell', kind: 'polygon', rest: ring, posed: ring, stiffness: 0.5 };
    const { positions } = picture.pose(solved);
    const at = (values: Float32Array, x: number, y: number) => {
      let best = 0;
      const away = (k: number) => Math.hypot((positions[2 * k] ?? 0) - x, (positions[2 * k + 1] ?? 0) - y);
      for (let k = 1; 2 * k < positions.length; k++) if (away(k) < away(best)) best = k;
      return values[best];
    };
    const project: Project = { ...solved, handles: [...solved.handles, shell] };
    const values = picture.stiffness(project);
    expect([at(values, 20, 12), at(values, 50, 50)]).toEqual([0.5, 0]);
    expect(picture.stiffness(moved('top', 3, 3))).not.toBe(values);
    const masked = picture.stiffness({ ...project, stiffness: { width: 1, height: 2, values: 'AP8=' } });
    expect([at(masked, 20, 9), at(masked, 50, 60)]).toEqual([0.5, 1]);
  });

  it('has the poses of handles along a clip', () => {
    const clip: Clip = {
      name: 'nod',
      duration: 1,
      loop: 'none',
      tracks: [
        {
          handle: 'right',
          keys: [
            { time: 0, posed: [48, 32], ease: 'linear' },
            { time: 1, posed: [54, 24] },
          ],
        },
        { handle: 'new', keys: [{ time: 0, posed: [1, 1] }] },
      ],
    };
    const playback = picture.playback(clip, solved);
    const plain = picture.pose(moved('right', 3, -4));
    const along = playback.pose(moved('right', 3, -4), 0.5);
    // Frames of a clip follow one another. At rest, they are the pose of the handles.
    expect(picture.settled(along).positions).toEqual(plain.positions);
    const lag = along.positions.map((value, k) => Math.abs(value - (plain.positions[k] ?? 0)));
    expect(Math.max(...lag)).toBeLessThan(5 / 2);
    // Each pose answers for itself, whichever came last.
    expect(playback.pose(moved('right', 6, -8), 2).map([48, 32])?.posed[0]).toBeCloseTo(54, 4);
    expect(along.map([48, 32])?.posed[0]).toBeCloseTo(51, 4);
    playback.free();
  });

  it('takes handles to their posed places, and back', () => {
    const pose = picture.pose(moved('right', 3, -4));
    expect(pose.map([48, 32])?.posed[0]).toBeCloseTo(51, 4);
    expect(pose.map([48, 32])?.posed[1]).toBeCloseTo(28, 4);
    expect(pose.locate([51, 28])?.rest[0]).toBeCloseTo(48, 4);
    expect(pose.map([-1, 0])).toBeNull();
    expect(pose.locate([-5, 0])).toBeNull();
    expect(pose.layerUnder([[-5, 0]])?.[0]?.rest[0]).toBeLessThan(0);
    const still = picture.pose(solved);
    expect(still.placement([-5, 10], 2)).toBeNull();
    expect(still.placement([-1, 10], 2)?.posed[0]).toBeGreaterThan(0);
    expect(still.placement([30, 10], 2)?.posed).toEqual([30, 10]);
    expect(picture.bends([10, 10])).toBe(true);
    expect(picture.bends([-1, 10])).toBe(false);
    expect(pose.positions).toHaveLength(2 * picture.coverage().length);
  });

  it('maps many points as it maps each', () => {
    const pose = picture.pose(moved('right', 3, -4));
    const points = Float64Array.from({ length: 200 }, (_, at) => ((at * 7919) % 640) / 10 - 2);
    const [mapped, located] = [pose.mapPoints(points), pose.locatePoints(points)];
    for (let at = 0; at < points.length; at += 2) {
      const place = [points[at] ?? 0, points[at + 1] ?? 0] as const;
      expect([...mapped.subarray(at, at + 2)]).toEqual(pose.map(place)?.posed ?? [Number.NaN, Number.NaN]);
      expect([...located.subarray(at, at + 2)]).toEqual(pose.locate(place)?.rest ?? [Number.NaN, Number.NaN]);
    }
    expect(mapped.some(Number.isNaN)).toBe(true);
  });

  it('answers for a pose after another one was made', () => {
    const first = picture.pose(moved('right', 5, 0));
    const second = picture.pose(moved('right', -5, 0));
    expect(first.map([48, 32])?.posed[0]).toBeCloseTo(53, 4);
    expect(second.map([48, 32])?.posed[0]).toBeCloseTo(43, 4);
    expect(first.triangles).toBe(second.triangles);
  });

  it('sorts triangles by depth, and keeps the array while depths stay', () => {
    const flat = picture.pose(solved).triangles;
    const handles = solved.handles.map((handle) => ({ ...handle, depth: handle.id === 'left' ? 1 : 0 }));
    const deep = picture.pose({ ...solved, handles }).triangles;
    expect(deep).not.toEqual(flat);
    expect([...deep].sort()).toEqual([...flat].sort());
    expect(picture.pose({ ...solved, handles: [...handles] }).triangles).toBe(deep);
  });

  it('keeps the handles that a project lacks, and ignores those that are not solved', () => {
    const fewer = { ...solved, handles: [...solved.handles.slice(0, 2), point('new', 60, 60)] };
    expect(picture.pose(fewer).map([32, 8])?.posed).toEqual(picture.pose(solved).map([32, 8])?.posed);
  });

  it('refuses a pose that cannot be made, with a code', () => {
    const handles = solved.handles.map((handle) => ({ ...handle, scale: 0 }));
    expect(() => picture.pose({ ...solved, handles })).toThrow(
      expect.objectContaining({ code: expect.any(String) }),
    );
    expect(picture.foldCount({ ...solved, handles })).toBe(Number.POSITIVE_INFINITY);
  });

  it('counts folds, and stops before the first one', () => {
    const far = moved('right', -60, 0);
    expect(picture.foldCount(solved)).toBe(0);
    expect(picture.foldCount(far)).toBeGreaterThan(1);
    const pose = picture.pose(far);
    expect(pose.creases.length).toBeGreaterThan(0);
    expect(pose.creasedTriangles()).toHaveLength(3 * picture.foldCount(far));
    const start = picture.pose(solved);
    const limit = picture.foldLimit(start, far, 0);
    expect(limit.fraction).toBeGreaterThan(0.1);
    expect(limit.fraction).toBeLessThan(1);
    expect(picture.pose(limit.project, start).creases).toHaveLength(0);
    const [, held] = limit.project.handles;
    expect(held?.kind === 'point' && held.posed[0]).toBeCloseTo(48 - 60 * limit.fraction, 1);
    expect(limit.project.handles[0]).toBe(far.handles[0]);
    const near = moved('right', 1, 0);
    expect(picture.foldLimit(start, near, 0)).toEqual({ project: near, fraction: 1 });
    expect(picture.foldLimit(start, near, 0).project).toBe(near);
  });

  it('stops handles that turn together at the same fraction', () => {
    const selection = ['left', 'right'];
    // The rigid mode turns them without a fold.
    const pose = { ...solved.pose, mode: 'harmonic' as const };
    const elastic = pictureOf({ ...solved, pose });
    const limit = elastic.groupFoldLimit(
      elastic.pose({ ...solved, pose }),
      {
        origin: { ...solved, pose },
        selection,
        to: { ...moved('left', 32, 0), pose },
        start: { turn: 0, scale: 1 },
        end: { turn: 180, scale: 1 },
      },
      0,
    );
    // The end was given as a pose that folds; the way to it is a turn.
    expect(limit.fraction).toBeGreaterThan(0);
    expect(limit.fraction).toBeLessThan(1);
    const turned = limit.project.handles.filter(({ id }) => selection.includes(id)).map((h) => rotationOf(h));
    expect(turned[0]).toBeCloseTo(180 * limit.fraction, 2);
    expect(turned[1]).toBe(turned[0]);
    elastic.free();
  });

  it('returns the reach of a selection, 1 at the handle and 0 at the others', () => {
    const pose = picture.pose(solved);
    const reach = picture.reach(pose, ['left']);
    expect(Math.max(...(reach ?? []))).toBeCloseTo(1, 1);
    expect(Math.min(...(reach ?? []))).toBeCloseTo(0, 2);
    expect(picture.reach(pose, ['nobody'])).toBeNull();
  });

  it('bounds the picture at rest and posed', () => {
    expect(picture.restBounds()).toEqual({ min: [0, 0], max: [SIZE, SIZE] });
    expect(picture.pose(moved('right', 40, 0)).bounds()?.max[0]).toBeGreaterThan(SIZE);
    expect(picture.bytes).toBeGreaterThan(10_000);
  });
});
