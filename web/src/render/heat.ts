/**
 * Draws the picture under a heat map of one value per vertex, with optional isolines.
 *
 * One pass draws both, so that parts of the picture hide the heat map of the parts behind them.
 */
import { HEAT_RAMP, type HeatMap } from '../geometry/heat';
import { type Attribute, type Buffers, createAttribute } from './buffers';
import heatFragment from './heat.frag.glsl?raw';
import { drawWith, type Program, program } from './program';
import type { Uniforms } from './uniforms';

/** Width of an isoline, CSS pixels. */
const LINE_CSS_PX = 1.2;

const RAMP = HEAT_RAMP.flatMap(([red, green, blue, alpha]) => [red / 255, green / 255, blue / 255, alpha]);

export class HeatLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: Program;
  #values: Attribute | undefined;
  #lines = true;

  /** @throws Error if the shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#program = program(gl, heatFragment, 'HEAT');
  }

  get isSet(): boolean {
    return this.#values !== undefined;
  }

  /** Sets the heat map for the next meshes. */
  set({ values, lines }: HeatMap): void {
    this.clear();
    this.#values = createAttribute(this.#gl, 1, values);
    this.#lines = lines;
  }

  clear(): void {
    if (this.#values) this.#gl.deleteBuffer(this.#values.buffer);
    this.#values = undefined;
  }

  /** @param pixelRatio Device pixels per CSS pixel. */
  draw(mesh: Buffers, uniforms: Uniforms, pixelRatio: number): void {
    if (!this.#values) return;
    const gl = this.#gl;
    const attributes = { ...mesh.attributes, a_heat: this.#values };
    const own = { u_ramp: RAMP, u_line: this.#lines ? LINE_CSS_PX * pixelRatio : 0 };
    drawWith(gl, this.#program, { ...mesh, attributes }, { ...uniforms, ...own }, gl.TRIANGLES);
    // An enabled attribute without a buffer makes the draw calls of other programs fail.
    gl.disableVertexAttribArray(gl.getAttribLocation(this.#program.program, 'a_heat'));
  }
}
