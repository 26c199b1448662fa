/**
 * Draws pixel art as an export has it: on the export's grid of pixels, which is then enlarged.
 *
 * Only the part of the grid in view is drawn, so that it is hardly larger than the canvas. The rasteriser of the export
 * is the reference. GPUs round corners of triangles to 1/16 or 1/256 of a pixel. So each pixel of the export is drawn
 * as a square of pixels, and its middle counts: rare differences remain.
 */
import type { View } from '../geometry/view';
import type { Buffers } from './buffers';
import pixelFragment from './pixel.frag.glsl?raw';
import { drawScreen, drawWith, type Program, program, screenProgram } from './program';
import sheetFragment from './sheet.frag.glsl?raw';
import { Target } from './target';
import type { Uniforms } from './uniforms';

/** A mesh to draw, with its own uniforms. */
export type PixelMesh = readonly [mesh: Buffers, uniforms: Uniforms];

/** Device pixels per pixel of an export. */
const gridScale = ({ scale, exportScale = 1 }: View): number => scale / exportScale;

/** The side of the square of each pixel: odd, since its middle counts. */
const MOST_TEXELS = 15;

/** Whether a view shows pixel art enlarged. A reduced grid would lose pixels. */
export const showsPixels = (view: View): boolean =>
  view.pixelated === true && view.compare !== true && gridScale(view) >= 1;

export class PixelLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #pixels: Program;
  readonly #enlarge: Program;
  readonly #sheet: Target;

  /** @throws Error if a shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#pixels = program(gl, pixelFragment);
    this.#enlarge = screenProgram(gl, sheetFragment);
    this.#sheet = new Target(gl, [gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE]);
  }

  /** Draws the meshes one over another. */
  draw(meshes: readonly PixelMesh[], view: View): void {
    const gl = this.#gl;
    const { exportScale = 1 } = view;
    const size = gridScale(view);
    // The part of the grid in view.
    const [left, top] = [Math.floor(-view.x / size), Math.floor(-view.y / size)];
    const texels = Math.min(MOST_TEXELS, Math.floor((size - 1) / 2) * 2 + 1);
    const width = (Math.ceil((view.width - view.x) / size) - left) * texels;
    const height = (Math.ceil((view.height - view.y) / size) - top) * texels;
    this.#sheet.resize(width, height);
    this.#sheet.bind();
    gl.viewport(0, 0, width, height);
    gl.disable(gl.BLEND);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const grid = {
      u_canvas_size: [width, height],
      u_view: [exportScale * texels, -left * texels, -top * texels],
    };
    for (const [mesh, uniforms] of meshes)
      drawWith(gl, this.#pixels, mesh, { ...uniforms, ...grid }, gl.TRIANGLES);

    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, view.width, view.height);
    drawScreen(gl, this.#enlarge, {
      u_canvas_size: [view.width, view.height],
      u_sheet: this.#sheet.texture,
      u_texels: texels,
      u_grid: [size, view.x + left * size, view.y + top * size],
    });
    gl.enable(gl.BLEND);
  }

  dispose(): void {
    this.#sheet.dispose();
  }
}
