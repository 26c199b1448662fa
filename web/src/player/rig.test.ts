import { readFileSync } from 'node:fs';
import { crc32, deflateRawSync, inflateRawSync } from 'node:zlib';
import { beforeAll, describe, expect, it } from 'vitest';
import { cycleOf, frameAt, motionsAt, orderAt, type RigClip, STRIDE, writeMotions } from './clip';
import init, { SectionPoser } from './generated/pose';
import { type HandlePose, posedClip, posedHandles } from './posed';
import { numbersOf, ownPoser, posesOf, sitesOf } from './poser';
import { type Rig, readRig } from './rig';

/** Made by `c2warp bake` from a picture of 24 × 18 px with two handles, of which one moves. */
const FILE = fixture('wave.c2rig');
/** The same picture in the harmonic mode, with two points and a bar. */
const POSABLE = fixture('posable.c2rig');
/**
 * A picture of 40 × 30 px in the rigid mode, with a point with automatic rotation, a bar and a polygon. Its section for
 * the solver has format 1.
 */
const SOLVED = fixture('solved.c2rig');
/** The same handles on a picture with transparent corners. Its section for the solver has format 2. */
const SOLVED_2 = fixture('solved_2.c2rig');
const HEADER = 24;
const ROW = 12;

function fixture(name: string): Uint8Array<ArrayBuffer> {
  return new Uint8Array(readFileSync(new URL(`./fixtures/${name}`, import.meta.url)));
}

/** A file with other unpacked sections, and a right checksum. */
function packed(change: (sections: Uint8Array[]) => void, of = FILE): Uint8Array<ArrayBuffer> {
  const file = Buffer.from(of);
  const rows = Array.from({ length: file.readUInt32LE(20) }, (_, row) => HEADER + ROW * row);
  let at = HEADER + ROW * rows.length;
  const sections = rows.map((row) => {
    const [stored, length] = [file.readUInt32LE(row + 4), file.readUInt32LE(row + 8)];
    const bytes = file.subarray(at, at + stored);
    at += stored;
    return new Uint8Array(stored === length ? bytes : inflateRawSync(bytes));
  });
  change(sections);
  const parts = sections.map((bytes) => {
    const deflated = deflateRawSync(bytes);
    return deflated.length < bytes.length ? deflated : bytes;
  });
  const head = Buffer.from(file.subarray(0, HEADER + ROW * rows.length));
  rows.forEach((row, k) => {
    head.writeUInt32LE(parts[k]?.length ?? 0, row + 4);
    head.writeUInt32LE(sections[k]?.length ?? 0, row + 8);
  });
  const all = Buffer.concat([head, ...parts]);
  all.writeUInt32LE(all.length, 12);
  all.writeUInt32LE(crc32(all.subarray(20)), 16);
  return new Uint8Array(all);
}

/** A rig that needs no solver, posed. */
function posedBy(rig: Rig, poses: readonly HandlePose[]): RigClip {
  const sites = ownPoser(rig)?.(posedHandles(rig.shares?.handles ?? [], poses, false));
  if (!sites) throw new Error('the rig needs the solver');
  return posedClip(rig, sites);
}

/** Whether a file is read. Any failure but a sentence for people fails the test. */
const isRead = (file: Uint8Array<ArrayBuffer>) =>
  readRig(file).then(
    (rig) => {
      const clips = rig.shares ? [...rig.clips, posedBy(rig, [])] : rig.clips;
      for (const clip of clips)
        writeMotions(clip, rig.rest, clip.lastFrame / 3, new Float32Array(rig.rest.length * STRIDE));
      return true;
    },
    (error: Error) => {
      expect(error.message).toMatch(/rig/);
      return false;
    },
  );

/** The posed vertices, by the linear blend. */
function posedVertices({ positions, rows, entries, rest }: Rig, clip: RigClip): number[][] {
  const motions = new Float32Array((rest.length / 2) * STRIDE);
  writeMotions(clip, rest, 0, motions);
  return Array.from({ length: rows.length / 2 }, (_, vertex) => {
    const [px = 0, py = 0] = positions.subarray(2 * vertex);
    const [first = 0, count = 0] = rows.subarray(2 * vertex);
    const posed = [0, 0];
    for (let entry = first; entry < first + count; entry++) {
      const [site = 0, weight = 0] = entries.subarray(2 * entry);
      const [a = 0, b = 0, c = 0, d = 0, rx = 0, ry = 0, x = 0, y = 0] = motions.subarray(STRIDE * site);
      posed[0] = (posed[0] ?? 0) + weight * (x + a * (px - rx) + c * (py - ry));
      posed[1] = (posed[1] ?? 0) + weight * (y + b * (px - rx) + d * (py - ry));
    }
    return posed;
  });
}

/** The places are those of a file, for the vertices of the rig. */
function expectPlaces(found: readonly number[][], file: string): void {
  const [, ...lines] = Buffer.from(fixture(file)).toString().trim().split('\n');
  const expected = lines.map((line) => line.split(',').map(Number));
  expect(found.length).toBe(expected.length);
  for (const [vertex, [x = 0, y = 0]] of found.entries()) {
    const [ex = 0, ey = 0] = expected[vertex] ?? [];
    expect(Math.hypot(x - ex, y - ey), `vertex ${vertex}`).toBeLessThan(0.1);
  }
}

describe('posed handles', () => {
  it('take every vertex to its place', async () => {
    const rig = await readRig(POSABLE);
    const clip = posedBy(rig, [
      { id: 'left', posed: [5, 12], rotation: -30, scale: 1.5 },
      {
        id: 'top',
        posed: [
          [8, 4],
          [14, 2],
          [17, 6],
        ],
        scale: 0.8,
      },
    ]);
    expectPlaces(posedVertices(rig, clip), 'posed.csv');
  });

  it('are drawn by their depths', async () => {
    const rig = await readRig(POSABLE);
    const orderOf = (depth: number) => posedBy(rig, [{ id: 'left', depth }]).orders[0]?.triangles;
    expect(orderOf(0)).toBeNull();
    const [front, behind] = [orderOf(1), orderOf(-1)];
    expect([...(front ?? [])].sort((a, b) => a - b)).toEqual([...(front ?? [])].map((_, at) => at));
    const places = rig.positions;
    const x = (triangle = 0) => places[2 * (rig.triangles[3 * triangle] ?? 0)] ?? 0;
    expect(x(front?.at(-1))).toBeLessThan(12);
    expect(x(behind?.[0])).toBeLessThan(12);
  });
});

describe('poses by the solver', () => {
  beforeAll(async () => {
    await init({ module_or_path: readFileSync(new URL('./generated/pose_bg.wasm', import.meta.url)) });
  });

  function poserOf({ solved, positions, triangles, rows, entries }: Rig): SectionPoser {
    return new SectionPoser(solved?.section ?? new Uint8Array(), positions, triangles, rows, entries);
  }

  /** The handles on the way from rest, at 0, to the pose of the files of places, at 1. */
  function handlesOnTheWay({ solved }: Rig, at: number): Float64Array {
    const place = (x: number, y: number, dx: number, dy: number) => [x + at * dx, y + at * dy] as const;
    const poses: HandlePose[] = [
      { id: 'left', posed: place(5, 15, 2, -3), rotation: 'auto' },
      { id: 'top', posed: [place(14, 5, 0, -1), place(20, 4, 0, -1), place(27, 6, -1, -2)] },
    ];
    return posesOf(posedHandles(solved?.handles ?? [], poses, true));
  }

  it.each([
    [1, SOLVED, 'solved.csv'],
    [2, SOLVED_2, 'solved_2.csv'],
  ])('of format %i take every vertex to its place', async (format, file, places) => {
    const rig = await readRig(file);
    expect(rig.solved?.section[0]).toBe(format);
    const motions = poserOf(rig).motions(handlesOnTheWay(rig, 1));
    expectPlaces(posedVertices(rig, posedClip(rig, sitesOf(motions, rig.rest.length / 2))), places);
  });

  it('follow the frame before in a drag, and rest in the pose of the handles', async () => {
    const rig = await readRig(SOLVED_2);
    const [poser, sites] = [poserOf(rig), rig.rest.length / 2];
    let before = sitesOf(poser.motions(handlesOnTheWay(rig, 0)), sites).motions;
    let places = posedVertices(rig, posedClip(rig, { motions: before, depths: new Float64Array(sites) }));
    for (let step = 1; step <= 20; step++) {
      const followed = poser.followed(numbersOf(before), handlesOnTheWay(rig, step / 20));
      const clip = posedClip(rig, sitesOf(followed, sites));
      const next = posedVertices(rig, clip);
      // The farthest corner moves by 0.18 px in each step.
      for (const [vertex, [x = 0, y = 0]] of next.entries()) {
        const [bx = 0, by = 0] = places[vertex] ?? [];
        expect(Math.hypot(x - bx, y - by), `vertex ${vertex} in step ${step}`).toBeLessThan(0.5);
      }
      [before, places] = [motionsAt(clip, sites, 0), next];
    }
    const settled = sitesOf(poser.settled(numbersOf(before), handlesOnTheWay(rig, 1)), sites);
    expectPlaces(posedVertices(rig, posedClip(rig, settled)), 'solved_2.csv');
    // The glide begins at the last frame of the drag, and ends at rest.
    const glide = posedClip(rig, settled, before);
    expect(motionsAt(glide, sites, 0)).toEqual(before);
    const apart = motionsAt(glide, sites, 1).map((number, at) => number - (settled.motions[at] ?? 0));
    expect(Math.max(...apart.map(Math.abs))).toBeLessThan(1e-12);
  });

  it('are refused with a sentence after a frame or with a mesh of another rig', async () => {
    const rig = await readRig(SOLVED_2);
    const [poser, poses] = [poserOf(rig), handlesOnTheWay(rig, 1)];
    const motions = poser.motions(poses);
    for (const before of [motions.subarray(7), motions.subarray(1), motions.map(() => Number.NaN)]) {
      expect(() => poser.followed(before, poses)).toThrow(/motions|pose/);
      expect(() => poser.settled(before, poses)).toThrow(/motions|pose/);
    }
    expect(() => poserOf({ ...rig, positions: rig.positions.subarray(2) })).toThrow(/mesh/);
    expect(() => poserOf({ ...rig, triangles: rig.triangles.map(() => 1e6) })).toThrow(/mesh/);
    expect(() => poserOf({ ...rig, entries: rig.entries.subarray(0, 2) })).toThrow(/weights/);
    expect(() => poserOf({ ...rig, entries: rig.entries.map(() => Number.NaN) })).toThrow(/mesh/);
  });

  it('are skipped in a later format', async () => {
    const later = packed((sections) => {
      sections[4] = Uint8Array.of(3, 99);
    }, SOLVED);
    expect((await readRig(later)).solved).toBeNull();
  });
});

describe('a rig', () => {
  it('is read', async () => {
    const rig = await readRig(FILE);
    expect([rig.width, rig.height, rig.handles]).toEqual([24, 18, ['left', 'right']]);
    expect(rig.clips.map(({ name, duration }) => [name, duration])).toEqual([
      ['wave', 0.5],
      ['back', 0.25],
    ]);
    // All weights of a vertex sum to 1.
    for (let row = 0; row < rig.rows.length; row += 2) {
      const [first = 0, count = 0] = rig.rows.subarray(row, row + 2);
      let sum = 0;
      for (let entry = first; entry < first + count; entry++) sum += rig.entries[2 * entry + 1] ?? 0;
      expect(sum).toBe(1);
    }
    const [xs, ys] = [0, 1].map((axis) => rig.positions.filter((_, at) => at % 2 === axis));
    expect([Math.max(...(xs ?? [])), Math.max(...(ys ?? []))]).toEqual([24, 18]);
  });

  it('moves its sites as the project says', async () => {
    const { clips, rest } = await readRig(FILE);
    const [wave, back] = clips as [(typeof clips)[0], (typeof clips)[0]];
    const motions = new Float32Array((rest.length / 2) * STRIDE);
    const placesAt = (time: number) => {
      writeMotions(wave, rest, frameAt(wave, time), motions);
      return [0, 1].map((site) => [...motions.subarray(STRIDE * site + 6, STRIDE * site + 8)]);
    };
    const close = (places: number[][], expected: number[][]) => {
      for (const [k, place] of places.flat().entries())
        expect(Math.abs(place - (expected.flat()[k] ?? 0))).toBeLessThan(0.1);
    };
    close(placesAt(0), [
      [4, 9],
      [20, 9],
    ]);
    close(placesAt(0.25), [
      [4, 9],
      [20, 4],
    ]);
    expect(
      [cycleOf(wave), cycleOf(back), frameAt(back, 0.4), frameAt(back, 0.1)].map((n) => n.toFixed(6)),
    ).toEqual(['0.500000', '0.500000', '6.000000', '6.000000']);
    expect(orderAt(wave, 7)).toMatchObject({ frame: 0, crosses: false });
  });

  it('has its shares read or rejected with any content', { timeout: 60_000 }, async () => {
    const SHARES = 4;
    const read = await Promise.all(
      Array.from({ length: 200 }, (_, k) => {
        const change = (sections: Uint8Array[]) => {
          const bytes = sections[SHARES] as Uint8Array;
          bytes[(k * 7919) % bytes.length] = [0, 0x7f, 0x80, 0xff][k % 4] ?? 0;
        };
        return isRead(packed(change, POSABLE));
      }),
    );
    expect(read).toContain(true);
    expect(read).toContain(false);
    const cut = Array.from({ length: 300 }, (_, less) =>
      isRead(
        packed((sections) => {
          const bytes = sections[SHARES] as Uint8Array;
          sections[SHARES] = less > 0 ? bytes.slice(0, bytes.length - less) : new Uint8Array([...bytes, 0]);
        }, POSABLE),
      ),
    );
    expect(await Promise.all(cut)).not.toContain(true);
  });

  it('is refused if it is cut short or longer', { timeout: 60_000 }, async () => {
    const cut = await Promise.all(Array.from(FILE, (_, end) => isRead(FILE.slice(0, end))));
    expect(cut).not.toContain(true);
    expect(await isRead(new Uint8Array([...FILE, 0]))).toBe(false);
  });

  it('is refused with any altered byte', { timeout: 60_000 }, async () => {
    for (const flip of [0x01, 0x80, 0xff]) {
      const altered = Array.from(FILE, (byte, at) => {
        const file = FILE.slice();
        file[at] = byte ^ flip;
        return isRead(file);
      });
      expect(await Promise.all(altered)).not.toContain(true);
    }
  });

  it('is read or rejected with any content', { timeout: 60_000 }, async () => {
    const files = [0, 2, 3, 4, 5].flatMap((section) =>
      Array.from({ length: 40 }, (_, k) =>
        packed((sections) => {
          const bytes = sections[section] as Uint8Array;
          bytes[(k * 7919) % bytes.length] = [0, 0x7f, 0x80, 0xff][k % 4] ?? 0;
        }),
      ),
    );
    expect((await Promise.all(files.map(isRead))).filter(Boolean).length).toBeGreaterThan(10);
  });

  it('is rejected if a section is truncated or too long', { timeout: 60_000 }, async () => {
    for (const section of [0, 2, 3, 4, 5]) {
      const lengths = Array.from({ length: 40 }, (_, k) => k);
      for (const less of lengths.map((k) => k - 1).filter((k) => k !== 0)) {
        const file = packed((sections) => {
          const bytes = sections[section] as Uint8Array;
          sections[section] =
            less < 0 ? new Uint8Array([...bytes, 0]) : bytes.slice(0, Math.max(0, bytes.length - less));
        });
        expect(await isRead(file), `${less} bytes less of section ${section}`).toBe(false);
      }
    }
  });

  it('is refused if it says that it unpacks to far more', async () => {
    const file = packed(() => {});
    const view = Buffer.from(file.buffer);
    view.writeUInt32LE(0xffff_ffff, HEADER + 2 * ROW + 8);
    view.writeUInt32LE(crc32(view.subarray(20)), 16);
    expect(await isRead(file)).toBe(false);
  });

  it('is refused by its table if it unpacks to more than any rig', async () => {
    const stored = Buffer.alloc(600_000);
    const head = Buffer.from(FILE.subarray(0, HEADER + ROW));
    head.writeUInt32LE(1, 20);
    head.writeUInt32LE(stored.length, HEADER + 4);
    head.writeUInt32LE(513 * 2 ** 20, HEADER + 8);
    const file = Buffer.concat([head, stored]);
    file.writeUInt32LE(file.length, 12);
    file.writeUInt32LE(crc32(file.subarray(20)), 16);
    await expect(readRig(new Uint8Array(file))).rejects.toThrow(/longer than 512 MiB/);
  });
});
