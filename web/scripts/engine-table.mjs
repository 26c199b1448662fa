/**
 * `node web/scripts/engine-table.mjs`: prints the table of web/docs/engines.md. Exports the samples in all formats, and
 * compares the vertices that two other readers compute along the clips.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as three from 'three';
import { dragonBonesRig } from '../../tests/browser/dragonbones_rig.mjs';
import { loadedGltf, skinned } from '../../tests/browser/gltf_rig.mjs';
import { main, step } from './steps.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const SAMPLES = join(ROOT, 'web/public/samples');
const COMMAND = join(ROOT, 'target/release/c2warp');
/** Times of a clip that readers are compared at. */
const TIMES = 24;
const NAMES =
  'sample,vertices,random poses,by hand,clips,between,readers,Spine,DragonBones,glTF,Godot,PNG'.split(',');
const HEAD = `| ${NAMES.join(' | ')} |\n|${'---|'.repeat(NAMES.length)}`;

/** Exports a project. @returns {string} The report. @param {string} project @param {string} output */
function exported(project, output) {
  const { status, stdout, stderr } = spawnSync(COMMAND, ['export', project, '-o', output], {
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(stderr);
  return stdout;
}

/**
 * The largest error and that of 99 %, of the worst row with such a name; empty without one.
 *
 * @param {string} report
 * @param {string} name
 */
function errors(report, name) {
  const rows = report.split('\n').filter((line) => line.startsWith(name));
  const numbers = rows.map((line) => line.trim().split(/\s+/).slice(-3, -1).map(Number));
  if (numbers.length === 0) return '';
  const worst = [0, 1].map((at) => Math.max(...numbers.map((row) => row[at] ?? 0)).toFixed(2));
  return `${worst.join(', ')} px`;
}

/** @param {string} file */
function size(file) {
  const bytes = statSync(file).size;
  return bytes < 1e6 ? `${Math.round(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

/**
 * The largest distance between vertices of three.js and of DragonBones, in the pose and along all clips.
 *
 * @param {string} folder
 * @param {{ width: number, height: number }} image
 */
async function apart(folder, { width, height }) {
  const gltf = await loadedGltf(new Uint8Array(readFileSync(join(folder, 'a.glb'))));
  const { posed, rest } = skinned(gltf, width, height);
  const text = (/** @type {string} */ name) => readFileSync(join(folder, name), 'utf8');
  const bones = dragonBonesRig(text('a_ske.json'), text('a_tex.json'));
  const distance = (/** @type {number[]} */ other) => {
    const far = posed().map(({ x, y }, v) =>
      Math.hypot(x - (other[2 * v] ?? 0), y - (other[2 * v + 1] ?? 0)),
    );
    return Math.max(...far);
  };
  let largest = distance(bones.vertices());
  const mixer = new three.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) {
    mixer.stopAllAction();
    mixer.clipAction(clip).reset().play();
    for (let k = 0; k < TIMES; k++) {
      const seconds = (clip.duration * k) / TIMES;
      mixer.setTime(seconds);
      largest = Math.max(largest, distance(bones.vertices(clip.name, seconds)));
    }
  }
  return { largest, vertices: rest.length };
}

/** @param {string} sample */
async function row(sample) {
  const project = join(SAMPLES, `${sample}.c2warp.json`);
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-table-'));
  try {
    const outputs = ['a.spine.json', 'a_ske.json', 'a.glb', 'a.tscn'].map((name) => join(folder, name));
    const [report = ''] = outputs.map((output) => exported(project, output));
    const { largest, vertices } = await apart(folder, JSON.parse(readFileSync(project, 'utf8')).image);
    const names = ['vertices, 20 random', 'bones by hand', 'vertices, clip', 'between'];
    const sizes = [...outputs, join(folder, 'a.png')].map(size);
    const cells = [
      sample,
      vertices,
      ...names.map((name) => errors(report, name)),
      `${largest.toFixed(2)} px`,
      ...sizes,
    ];
    return `| ${cells.join(' | ')} |`;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

await main(async () => {
  const args = ['build', '--release', '--package', 'c2warp-cli'];
  await step('The command', 'cargo', args, 'It does not build. The reason is above.');
  console.log(HEAD);
  const samples = readdirSync(SAMPLES).filter((name) => name.endsWith('.c2warp.json'));
  for (const name of samples.toSorted()) console.log(await row(name.replace('.c2warp.json', '')));
});
