/** A rig on the graphics card: the picture, the mesh with its weights, and the motions of one frame. */
import { type Order, STRIDE } from './clip';
import { fill, padded, tableOf } from './program';
import type { Rig } from './rig';

/** Each pose with depths has its own order: old ones are dropped. */
const MOST_ORDERS = 64;

/** The attribute `a_place` of the shader. */
const PLACE = 3;

export interface Figure {
  /** Uploads motions, sites × 12. */
  pose(motions: Float32Array): void;
  /** Binds everything. The uniforms `u_picture`, `u_weights` and `u_motions` are texture units 0, 1 and 2. */
  bind(order: Order): void;
  /** Draws the bound mesh. */
  draw(): void;
  dispose(): void;
}

/** @param picture Premultiplied. */
export function figureOf(gl: WebGL2RenderingContext, rig: Rig, picture: ImageBitmap): Figure {
  const vertices = gl.createVertexArray();
  gl.bindVertexArray(vertices);
  const arrays = [
    [0, rig.positions],
    [1, rig.rows],
    [PLACE, rig.displaced],
  ] as const;
  const buffers = arrays.map(([location, data]) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    if (data instanceof Float32Array) gl.vertexAttribPointer(location, 2, gl.FLOAT, false, 0, 0);
    else gl.vertexAttribIPointer(location, 2, gl.UNSIGNED_INT, 0, 0);
    return buffer;
  });
  const textures = [pictureTexture(gl, picture), tableOf(gl)];
  const entries = padded(rig.entries.length, 2);
  entries.set(rig.entries);
  fill(gl, entries, 2);
  const motionTable = tableOf(gl);
  textures.push(motionTable);
  const table = padded((rig.rest.length / 2) * STRIDE, 4);
  const orders = new Map<Order['triangles'], WebGLBuffer>();
  const forgetOldest = () => {
    for (const [triangles, buffer] of orders) {
      if (orders.size < MOST_ORDERS) return;
      gl.deleteBuffer(buffer);
      orders.delete(triangles);
    }
  };
  return {
    pose(motions) {
      table.set(motions);
      gl.activeTexture(gl.TEXTURE2);
      gl.bindTexture(gl.TEXTURE_2D, motionTable);
      fill(gl, table, 4);
    },
    bind({ triangles }) {
      gl.bindVertexArray(vertices);
      const known = orders.get(triangles);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, known ?? null);
      if (!known) {
        forgetOldest();
        const buffer = gl.createBuffer();
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, ordered(rig.triangles, triangles), gl.STATIC_DRAW);
        orders.set(triangles, buffer);
      }
      textures.forEach((texture, unit) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
      });
    },
    draw: () => gl.drawElements(gl.TRIANGLES, rig.triangles.length, gl.UNSIGNED_INT, 0),
    dispose() {
      gl.deleteVertexArray(vertices);
      for (const buffer of [...buffers, ...orders.values()]) gl.deleteBuffer(buffer);
      for (const texture of textures) gl.deleteTexture(texture);
    },
  };
}

function ordered(triangles: Uint32Array, order: Uint32Array | null): Uint32Array {
  if (!order) return triangles;
  const corners = new Uint32Array(triangles.length);
  order.forEach((triangle, at) => {
    corners.set(triangles.subarray(3 * triangle, 3 * triangle + 3), 3 * at);
  });
  return corners;
}

function pictureTexture(gl: WebGL2RenderingContext, picture: ImageBitmap): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  gl.generateMipmap(gl.TEXTURE_2D);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}
