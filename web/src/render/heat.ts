/**
 * Draws the picture under a heat map of one value per vertex, with optional isolines.
 *
 * One pass draws both, so that parts of the picture hide the heat map of the parts behind them.
 */
import * as twgl from 'twgl.js';
import { HEAT_RAMP, type HeatMap } from '../geometry/heat';
import heatFragment from './heat.frag.glsl?raw';
import { drawWith, program } from './program';

/** Width of an isoline, CSS pixels. */
const LINE_CSS_PX = 1.2;

const RAMP = HEAT_RAMP.flatMap(([red, green, blue, alpha]) => [red / 255, green / 255, blue / 255, alpha]);

export class HeatLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: twgl.ProgramInfo;
  #buffer: WebGLBuffer | undefined;
  #lines = true;

  /** @throws Error if the shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#program = program(gl, heatFragment, 'HEAT');
  }

  get isSet(): boolean {
    return this.#buffer !== undefined;
  }

  /** Sets the heat map for the next meshes. */
  set({ values, lines }: HeatMap): void {
    this.clear();
    this.#buffer = twgl.createBufferFromTypedArray(this.#gl, values);
    this.#lines = lines;
  }

  clear(): void {
    if (this.#buffer) this.#gl.deleteBuffer(this.#buffer);
    this.#buffer = undefined;
  }

  /** @param pixelRatio Device pixels per CSS pixel. */
  draw(mesh: twgl.BufferInfo, uniforms: Record<string, unknown>, pixelRatio: number): void {
    if (!this.#buffer) return;
    const gl = this.#gl;
    const a_heat = { buffer: this.#buffer, numComponents: 1, type: gl.FLOAT };
    const own = { u_ramp: RAMP, u_line: this.#lines ? LINE_CSS_PX * pixelRatio : 0 };
    drawWith(
      gl,
      this.#program,
      { ...mesh, attribs: { ...mesh.attribs, a_heat } },
      { ...uniforms, ...own },
      gl.TRIANGLES,
    );
    // An enabled attribute without a buffer makes the draw calls of other programs fail.
    gl.disableVertexAttribArray(gl.getAttribLocation(this.#program.program, 'a_heat'));
  }
}
