/**
 * Thin dark edges where one part of the picture lies in front of another, as in exports: see
 * `wasm/core/src/raster/edges.rs`.
 *
 * Two passes note the point of the picture at each pixel, and that of another part below it. A third pass darkens.
 *
 * Cost: nothing while no parts cross, otherwise three passes over the rectangle around all crossings.
 */
import type { Box } from '../geometry/box';
import type { Size } from '../geometry/camera';
import type { View } from '../geometry/view';
import type { Buffers } from './buffers';
import edgesFragment from './edges.frag.glsl?raw';
import layerFragment from './layer.frag.glsl?raw';
import { drawScreen, drawWith, type Program, program, screenProgram } from './program';
import { Target, type TexelFormat } from './target';
import type { Uniforms } from './uniforms';

/** Radius of the edge as a fraction of the picture's diagonal, and the least one in pixels of the picture. */
const RADIUS = 0.004;
const LEAST_RADIUS_PX = 2;
/** Points of the picture farther apart than this belong to different parts, in radii. */
const APART = 4;

/** The width of the edge, image pixels. */
export const edgeRadius = ({ width, height }: Size): number =>
  Math.max(LEAST_RADIUS_PX, RADIUS * Math.hypot(width, height));

export class EdgeLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #places: Program;
  readonly #edges: Program;
  readonly #top: Target;
  readonly #below: Target;

  /** @throws Error if a shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#places = program(gl, layerFragment);
    this.#edges = screenProgram(gl, edgesFragment);
    const format: TexelFormat = [gl.RG16UI, gl.RG_INTEGER, gl.UNSIGNED_SHORT];
    [this.#top, this.#below] = [new Target(gl, format), new Target(gl, format)];
  }

  /**
   * Darkens the drawing.
   *
   * @param uniforms Those that the mesh was drawn with.
   * @param picture Image pixels.
   * @param crossed The box around all crossings, image pixels.
   */
  draw(mesh: Buffers, uniforms: Uniforms, picture: Size, crossed: Box, view: View): void {
    const gl = this.#gl;
    const radius = edgeRadius(picture);
    const [top, below] = [this.#top, this.#below];
    if (!this.#bound(crossed, radius, view)) return;
    for (const layer of [top, below]) layer.resize(view.width, view.height);
    gl.disable(gl.BLEND);
    const points = { ...uniforms, u_apart: APART * radius };
    const [u_top, u_below] = [top.texture, below.texture];
    this.#note(top, mesh, { ...points, u_below: false, u_top: u_below });
    this.#note(below, mesh, { ...points, u_below: true, u_top });

    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.ZERO, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    drawScreen(gl, this.#edges, {
      u_top,
      u_below,
      u_picture_size: [picture.width, picture.height],
      u_scale: view.scale,
      u_radius: radius,
    });
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.disable(gl.SCISSOR_TEST);
  }

  dispose(): void {
    this.#top.dispose();
    this.#below.dispose();
  }

  /** Limits drawing to the crossings that are in view. Returns whether there are any. */
  #bound({ min, max }: Box, radius: number, view: View): boolean {
    const pixel = (at: number, offset: number, most: number) =>
      Math.min(most, Math.max(0, at * view.scale + offset));
    const left = Math.floor(pixel(min[0] - radius, view.x, view.width));
    const right = Math.ceil(pixel(max[0] + radius, view.x, view.width));
    const top = Math.floor(pixel(min[1] - radius, view.y, view.height));
    const bottom = Math.ceil(pixel(max[1] + radius, view.y, view.height));
    if (left >= right || top >= bottom) return false;
    this.#gl.scissor(left, view.height - bottom, right - left, bottom - top);
    return true;
  }

  /** Draws the points of the picture into a layer. */
  #note(layer: Target, mesh: Buffers, uniforms: Uniforms): void {
    const gl = this.#gl;
    layer.bind();
    gl.disable(gl.SCISSOR_TEST);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.enable(gl.SCISSOR_TEST);
    drawWith(gl, this.#places, mesh, uniforms, gl.TRIANGLES);
  }
}
