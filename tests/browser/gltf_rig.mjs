/** The mesh and the bones of a glTF file by three.js. Pictures need a page, and do not matter here. */
import * as three from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** @param {Uint8Array} glb */
export async function loadedGltf(glb) {
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

/**
 * The vertices of a file with a skin, in places of the picture: at rest, by texture coordinates, and posed now.
 *
 * @param {import('three/addons/loaders/GLTFLoader.js').GLTF} gltf
 * @param {number} width of the picture
 * @param {number} height
 */
export function skinned(gltf, width, height) {
  /** @type {three.SkinnedMesh[]} */
  const meshes = [];
  gltf.scene.traverse((node) => {
    if (node instanceof three.SkinnedMesh) meshes.push(node);
  });
  const [mesh] = meshes;
  if (!mesh) throw new Error('The file has no mesh with a skin.');
  const uv = mesh.geometry.getAttribute('uv');
  const vertices = Array.from({ length: uv.count }, (_, v) => v);
  const rest = vertices.map((v) => new three.Vector2(uv.getX(v) * width, uv.getY(v) * height));
  const posed = () => {
    gltf.scene.updateMatrixWorld(true);
    return vertices.map((v) => {
      const { x, y, z } = mesh.getVertexPosition(v, new three.Vector3());
      if (Math.abs(z) > 1e-9) throw new Error(`Vertex ${v} leaves the plane.`);
      return new three.Vector2(x, -y);
    });
  };
  return { rest, posed };
}
