/** Draws figures on the one WebGL context of a page, with the shaders of the editor. */
import edgesFragment from '../render/edges.frag.glsl?raw';
import layerFragment from '../render/layer.frag.glsl?raw';
import pictureFragment from '../render/picture.frag.glsl?raw';
import warpVertex from '../render/warp.vert.glsl?raw';
import type { Order } from './clip';
import type { Figure } from './figure';
import { type Program, programOf, tableOf } from './program';
import type { Rig } from './rig';

/** As in the editor: web/src/render/picture.ts and web/src/render/edges.ts. */
const CRISP_ABOVE = 4;
const RADIUS = 0.004;
const LEAST_RADIUS_PX = 2;
const APART = 4;

const SCREEN = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}`;

export interface View {
  /** The size of the drawing, device pixels. */
  readonly width: number;
  readonly height: number;
  /** Device pixels per pixel of the picture, and the position of its corner. */
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

export interface Painter {
  /** Draws into the lower left corner of the canvas. */
  draw(rig: Rig, figure: Figure, order: Order, view: View): void;
}

interface Edges {
  readonly places: Program;
  readonly darkness: Program;
  readonly layers: readonly Layer[];
}

interface Layer {
  readonly texture: WebGLTexture;
  readonly framebuffer: WebGLFramebuffer;
}

/** @throws Error if a shader does not compile. */
export function painterOf(gl: WebGL2RenderingContext): Painter {
  const picture = programOf(gl, warpVertex, pictureFragment);
  let edges: Edges | undefined;
  let size = [0, 0];

  const set = (program: Program, rig: Rig, view: View) => {
    program.use();
    ['u_picture', 'u_weights', 'u_motions'].forEach((name, unit) => {
      gl.uniform1i(program.at(name), unit);
    });
    gl.uniform2f(program.at('u_picture_size'), rig.width, rig.height);
    gl.uniform2f(program.at('u_canvas_size'), view.width, view.height);
    gl.uniform3f(program.at('u_view'), view.scale, view.x, view.y);
    gl.uniform1i(program.at('u_rigid'), Number(rig.rigid));
    gl.uniform1i(program.at('u_at_rest'), 0);
  };

  /** Layers grow to the size of the largest drawing. */
  const sized = ({ layers }: Edges, { width, height }: View) => {
    if (size[0] === width && size[1] === height) return;
    size = [width, height];
    for (const { texture } of layers) {
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG16UI, width, height, 0, gl.RG_INTEGER, gl.UNSIGNED_SHORT, null);
    }
  };

  const drawEdges = (rig: Rig, figure: Figure, view: View) => {
    edges ??= edgesOf(gl);
    const { places, darkness, layers } = edges;
    const radius = Math.max(LEAST_RADIUS_PX, RADIUS * Math.hypot(rig.width, rig.height));
    gl.activeTexture(gl.TEXTURE3);
    sized(edges, view);
    gl.disable(gl.BLEND);
    set(places, rig, view);
    gl.uniform1i(places.at('u_top'), 3);
    gl.uniform1f(places.at('u_apart'), APART * radius);
    layers.forEach(({ framebuffer }, layer) => {
      // A shader must not read what it draws.
      gl.activeTexture(gl.TEXTURE3);
      gl.bindTexture(gl.TEXTURE_2D, layers[1 - layer]?.texture ?? null);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
      gl.uniform1i(places.at('u_below'), layer);
      figure.draw();
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.ZERO, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    darkness.use();
    layers.forEach(({ texture }, layer) => {
      gl.activeTexture(gl.TEXTURE3 + layer);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(darkness.at(['u_top', 'u_below'][layer] ?? ''), 3 + layer);
    });
    gl.uniform2f(darkness.at('u_picture_size'), rig.width, rig.height);
    gl.uniform1f(darkness.at('u_scale'), view.scale);
    gl.uniform1f(darkness.at('u_radius'), radius);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };

  return {
    draw(rig, figure, order, view) {
      gl.viewport(0, 0, view.width, view.height);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, 0, view.width, view.height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
      figure.bind(order);
      gl.activeTexture(gl.TEXTURE0);
      const magnified = view.scale > CRISP_ABOVE ? gl.NEAREST : gl.LINEAR;
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, magnified);
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      set(picture, rig, view);
      figure.draw();
      if (rig.edges && order.crosses) drawEdges(rig, figure, view);
    },
  };
}

function edgesOf(gl: WebGL2RenderingContext): Edges {
  const layer = () => {
    gl.activeTexture(gl.TEXTURE3);
    const texture = tableOf(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG16UI, 1, 1, 0, gl.RG_INTEGER, gl.UNSIGNED_SHORT, null);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    return { texture, framebuffer };
  };
  return {
    places: programOf(gl, warpVertex, layerFragment),
    darkness: programOf(gl, SCREEN, edgesFragment),
    layers: [layer(), layer()],
  };
}
