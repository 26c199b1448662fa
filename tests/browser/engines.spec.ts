/**
 * Rigs for engines by readers of others, with the vertices of `c2warp map`: the validator of Khronos, three.js, and the
 * runtime of DragonBones.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { encode } from 'fast-png';
import { validateBytes } from 'gltf-validator';
import * as three from 'three';
import { builtCommand } from './command';
import { dragonBonesRig } from './dragonbones_rig.mjs';
import { expect, test } from './fixtures';
import { loadedGltf, skinned } from './gltf_rig.mjs';

const [WIDTH, HEIGHT] = [240, 160] as const;
const FILE = 'card.c2warp.json';
const TIMES = Array.from({ length: 12 }, (_, k) => k / 12);
const FROM = { time: 0, posed: [190, 80], rotation: 0, ease: 'linear' } as const;
const TO = { time: 1, posed: [180, 50], rotation: 40, ease: 'linear' } as const;
const DURATION = 1;

/** A card with a bar, whose bones are stretched along it, and a point that a clip moves along a straight line. */
const project = {
  format: 'c2warp/1',
  image: { src: 'card.png', width: WIDTH, height: HEIGHT },
  domain: { kind: 'image' },
  pose: { mode: 'harmonic', blend: 'linear' },
  handles: [
    {
      id: 'bar',
      kind: 'bar',
      rest: [
        [40, 40],
        [40, 120],
      ],
      posed: [
        [30, 30],
        [52, 138],
      ],
    },
    { id: 'point', kind: 'point', rest: [190, 80], posed: [186, 66], rotation: 25 },
  ],
  clips: [{ name: 'nod', duration: DURATION, loop: 'none', tracks: [{ handle: 'point', keys: [FROM, TO] }] }],
};

let folder: string;
let command: string;

test.beforeAll(() => {
  command = builtCommand();
  folder = mkdtempSync(join(tmpdir(), 'c2warp-engines-'));
  const data = new Uint8Array(WIDTH * HEIGHT * 4).fill(255);
  writeFileSync(join(folder, 'card.png'), encode({ width: WIDTH, height: HEIGHT, data, channels: 4 }));
  writeFileSync(join(folder, FILE), JSON.stringify(project));
});

test.afterAll(() => {
  rmSync(folder, { recursive: true });
});

function run(...args: string[]): string {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: folder, encoding: 'utf8' });
  expect(status, stderr).toBe(0);
  return stdout;
}

function exported(...options: string[]): Uint8Array {
  run('export', FILE, '-o', 'card.glb', ...options);
  return new Uint8Array(readFileSync(join(folder, 'card.glb')));
}

/** The places of points by `c2warp map`, with the point handle posed as at a time of the clip, or as in the project. */
function mapped(points: three.Vector2[], time?: number): three.Vector2[] {
  const at = (time ?? 0) / DURATION;
  const between = (a: number, b: number) => a + (b - a) * at;
  const posed = [between(FROM.posed[0], TO.posed[0]), between(FROM.posed[1], TO.posed[1])];
  const moment = time === undefined ? {} : { posed, rotation: between(FROM.rotation, TO.rotation) };
  const [bar, point] = project.handles;
  writeFileSync(
    join(folder, 'moment.c2warp.json'),
    JSON.stringify({ ...project, handles: [bar, { ...point, ...moment }] }),
  );
  writeFileSync(join(folder, 'points.csv'), ['x,y', ...points.map(({ x, y }) => `${x},${y}`)].join('\n'));
  const rows = run('map', 'moment.c2warp.json', '--at', 'points.csv', '-o', '-').trim().split('\n').slice(1);
  return rows.map((row) => new three.Vector2(...row.split(',').slice(2, 4).map(Number)));
}

function greatest(a: three.Vector2[], b: three.Vector2[]): number {
  expect(a.length).toBe(b.length);
  return Math.max(...a.map((p, k) => p.distanceTo(b[k] as three.Vector2)));
}

test('the validator of Khronos finds nothing to complain about', async () => {
  for (const options of [[], ['--influences', '8'], ['--bones', '3', '--vertices', '20']]) {
    const { issues } = await validateBytes(exported(...options));
    const { numErrors, numWarnings, messages } = issues;
    expect([numErrors, numWarnings], JSON.stringify(messages)).toEqual([0, 0]);
  }
});

test('three.js takes vertices to the places of the map in the pose and along the clip', async () => {
  const glb = exported('--bones', '255');
  const gltf = await loadedGltf(glb);
  const { rest, posed } = skinned(gltf, WIDTH, HEIGHT);
  // 32 bits have a step of 2⁻¹⁶ px at the far side.
  expect(greatest(posed(), mapped(rest))).toBeLessThan(0.02);
  const mixer = new three.AnimationMixer(gltf.scene);
  const [clip] = gltf.animations;
  if (!clip) throw new Error('The file has no clip.');
  expect([clip.name, clip.duration]).toEqual(['nod', DURATION]);
  const action = mixer.clipAction(clip);
  action.play();
  for (const time of TIMES) {
    mixer.setTime(time * DURATION);
    expect(greatest(posed(), mapped(rest, time * DURATION)), `${time} s`).toBeLessThan(0.12);
  }
});

test('materials are unlit and blended, and the picture is inside', () => {
  const glb = exported();
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  expect(json.materials[0]).toMatchObject({ alphaMode: 'BLEND', extensions: { KHR_materials_unlit: {} } });
  const { byteOffset, byteLength } = json.bufferViews[json.images[0].bufferView];
  const start = 28 + length + byteOffset;
  expect([...glb.subarray(start, start + 4)]).toEqual([0x89, 0x50, 0x4e, 0x47]);
  expect(byteLength).toBeGreaterThan(50);
});

test('the runtime of DragonBones takes vertices to the places of the map', () => {
  run('export', FILE, '-o', 'card_ske.json', '--bones', '255');
  const [skeleton, texture] = ['card_ske.json', 'card_tex.json'].map((name) =>
    readFileSync(join(folder, name), 'utf8'),
  ) as [string, string];
  const rig = dragonBonesRig(skeleton, texture);
  expect(rig.durations).toEqual({ nod: DURATION });
  const { uvs } = JSON.parse(skeleton).armature[0].skin[0].slot[0].display[0];
  const points = (numbers: readonly number[], width = 1, height = 1) =>
    Array.from(
      { length: numbers.length / 2 },
      (_, v) => new three.Vector2((numbers[2 * v] ?? 0) * width, (numbers[2 * v + 1] ?? 0) * height),
    );
  const rest = points(uvs, WIDTH, HEIGHT);
  // Numbers of the file are rounded to hundredths.
  expect(greatest(points(rig.vertices()), mapped(rest))).toBeLessThan(0.03);
  for (const time of TIMES) {
    const posed = points(rig.vertices('nod', time * DURATION));
    expect(greatest(posed, mapped(rest, time * DURATION)), `${time} s`).toBeLessThan(0.12);
  }
});
