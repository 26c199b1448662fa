/** Rigs for engines: glTF files by the validator of Khronos and by three.js, with the vertices of `c2warp map`. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { encode } from 'fast-png';
import { validateBytes } from 'gltf-validator';
import * as three from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { builtCommand } from './command';
import { expect, test } from './fixtures';

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

/** Loads the bones and the mesh of a file. Pictures need a page, and do not matter here. */
async function loaded(glb: Uint8Array): Promise<GLTF> {
  const view = new DataView(glb.buffer, glb.byteOffset);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  for (const key of ['images', 'textures', 'samplers', 'materials', 'extensionsUsed']) delete json[key];
  for (const mesh of json.meshes) for (const primitive of mesh.primitives) delete primitive.material;
  const text = new TextEncoder().encode(JSON.stringify(json));
  const words = Math.ceil(text.length / 4);
  const stripped = new Uint8Array(20 + 4 * words + glb.length - 20 - length).fill(0x20);
  stripped.set(glb.subarray(0, 20));
  stripped.set(text, 20);
  stripped.set(glb.subarray(20 + length), 20 + 4 * words);
  const header = new DataView(stripped.buffer);
  header.setUint32(8, stripped.length, true);
  header.setUint32(12, 4 * words, true);
  return new GLTFLoader().parseAsync(stripped.buffer, '');
}

/** The mesh of a file with its vertices at rest, by texture coordinates, and posed, both in places of the picture. */
function skinned(gltf: GLTF) {
  const meshes: three.SkinnedMesh[] = [];
  gltf.scene.traverse((node) => {
    if (node instanceof three.SkinnedMesh) meshes.push(node);
  });
  const [mesh] = meshes;
  if (!mesh) throw new Error('The file has no mesh with a skin.');
  const { geometry } = mesh;
  const uv = geometry.getAttribute('uv');
  const vertices = Array.from({ length: uv.count }, (_, v) => v);
  const rest = vertices.map((v) => new three.Vector2(uv.getX(v) * WIDTH, uv.getY(v) * HEIGHT));
  const posed = () => {
    gltf.scene.updateMatrixWorld(true);
    return vertices.map((v) => {
      const { x, y, z } = mesh.getVertexPosition(v, new three.Vector3());
      expect(Math.abs(z)).toBeLessThan(1e-9);
      return new three.Vector2(x, -y);
    });
  };
  return { rest, posed };
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
  const gltf = await loaded(glb);
  const { rest, posed } = skinned(gltf);
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
