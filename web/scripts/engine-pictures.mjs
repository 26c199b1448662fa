/**
 * `node web/scripts/engine-pictures.mjs`: draws web/screenshots/engines.webp. The picture shows two frames of a clip,
 * drawn by the command, by three.js from the glTF, and by DragonBones' runtime, whose vertices three.js draws.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { dragonBonesRig } from '../../tests/browser/dragonbones_rig.mjs';
import { launchChromium } from './chromium.mjs';
import { main, step } from './steps.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const COMMAND = join(ROOT, 'target/release/c2warp');
const PROJECT = join(ROOT, 'web/public/samples/gingerbread.c2warp.json');
const [WIDTH, HEIGHT] = [1024, 1280];
const CLIP = 'wave';
const TIMES = [0.55, 1.4];
const SCALE = 0.3;
const OUTPUT = 'web/screenshots/engines.webp';
const TYPES = { '.js': 'text/javascript', '.html': 'text/html', '.png': 'image/png' };

/** A page with three.js, which draws a row of pictures for each time. */
const PAGE = `<!doctype html>
<script type="importmap">
  {"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}
</script>
<script type="module">
  import * as three from 'three';
  import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
  window.draw = async ({ width, height, scale, clip, rows, uvs, triangles, types }) => {
    const [across, down] = [Math.round(width * scale), Math.round(height * scale)];
    const label = 28;
    const sheet = document.createElement('canvas');
    [sheet.width, sheet.height] = [3 * across, label + rows.length * down];
    const context = sheet.getContext('2d');
    context.fillStyle = '#fff';
    context.fillRect(0, 0, sheet.width, sheet.height);
    const renderer = new three.WebGLRenderer({ alpha: true, antialias: true, preserveDrawingBuffer: true });
    renderer.setSize(across, down);
    const camera = new three.OrthographicCamera(0, width, 0, -height, -1, 1);
    const gltf = await new GLTFLoader().loadAsync('/files/a.glb');
    gltf.scene.traverse((node) => (node.frustumCulled = false));
    const mixer = new three.AnimationMixer(gltf.scene);
    mixer.clipAction(three.AnimationClip.findByName(gltf.animations, clip)).play();
    const map = await new three.TextureLoader().loadAsync('/files/a_tex.png');
    map.flipY = false;
    map.colorSpace = three.SRGBColorSpace;
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('uv', new three.Float32BufferAttribute(uvs, 2));
    geometry.setIndex(triangles);
    const side = three.DoubleSide;
    const mesh = new three.Mesh(geometry, new three.MeshBasicMaterial({ map, transparent: true, side }));
    mesh.frustumCulled = false;
    const boned = new three.Scene();
    boned.add(mesh);
    for (const [row, { at, own, vertices }] of rows.entries()) {
      const image = await createImageBitmap(await (await fetch('/files/' + own)).blob());
      const y = label + row * down;
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, y, across, down);
      mixer.setTime(at);
      renderer.render(gltf.scene, camera);
      context.drawImage(renderer.domElement, across, y);
      const places = vertices.flatMap((value, k) => (k % 2 ? [-value, 0] : [value]));
      geometry.setAttribute('position', new three.Float32BufferAttribute(places, 3));
      renderer.render(boned, camera);
      context.drawImage(renderer.domElement, 2 * across, y);
    }
    context.fillStyle = '#222';
    context.font = '600 16px sans-serif';
    context.textAlign = 'center';
    for (const [k, name] of types.entries()) context.fillText(name, (k + 0.5) * across, 20);
    return sheet.toDataURL('image/webp', 0.85);
  };
  document.title = 'ready';
</script>`;

/** @param {string} folder @param {string[]} args */
function run(folder, ...args) {
  const { status, stderr } = spawnSync(COMMAND, args, { cwd: folder, encoding: 'utf8' });
  if (status !== 0) throw new Error(stderr);
}

/** @param {string} folder */
async function drawn(folder) {
  for (const output of ['a.glb', 'a_ske.json']) run(folder, 'export', PROJECT, '-o', output);
  const text = (/** @type {string} */ name) => readFileSync(join(folder, name), 'utf8');
  const rig = dragonBonesRig(text('a_ske.json'), text('a_tex.json'));
  const { uvs, triangles } = JSON.parse(text('a_ske.json')).armature[0].skin[0].slot[0].display[0];
  const rows = TIMES.map((at, k) => {
    const own = `own-${k}.png`;
    run(folder, 'warp', PROJECT, '--clip', CLIP, '--at', String(at), '-o', own);
    return { at, own, vertices: rig.vertices(CLIP, at) };
  });
  const browser = await launchChromium();
  try {
    const page = await browser.newPage();
    await page.route('http://pictures.test/**', (route) => {
      const { pathname } = new URL(route.request().url());
      const type = TYPES[/** @type {keyof typeof TYPES} */ (extname(pathname))] ?? 'application/octet-stream';
      const body = pathname.startsWith('/three/')
        ? readFileSync(join(ROOT, 'node_modules', pathname))
        : pathname.startsWith('/files/')
          ? readFileSync(join(folder, pathname.slice('/files/'.length)))
          : PAGE;
      return route.fulfill({ body, contentType: body === PAGE ? 'text/html' : type });
    });
    await page.goto('http://pictures.test/');
    await page.waitForFunction("document.title === 'ready'");
    const order = { width: WIDTH, height: HEIGHT, scale: SCALE, clip: CLIP, rows, uvs, triangles };
    const types = ['c2warp', 'glTF in three.js', 'DragonBones'];
    const url = await page.evaluate((order) => Reflect.get(globalThis, 'draw')(order), { ...order, types });
    return Buffer.from(String(url).split(',')[1] ?? '', 'base64');
  } finally {
    await browser.close();
  }
}

await main(async () => {
  const args = ['build', '--release', '--package', 'c2warp-cli'];
  await step('The command', 'cargo', args, 'It does not build. The reason is above.');
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-pictures-'));
  try {
    writeFileSync(join(ROOT, OUTPUT), await drawn(folder));
    console.log(OUTPUT);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
