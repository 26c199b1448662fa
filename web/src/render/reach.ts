/**
 * The picture under a heat map with isolines, of one number per vertex. Both are drawn in one pass, so that parts that
 * the picture covers show in neither.
 */
import * as twgl from 'twgl.js';
import { REACH_RAMP } from '../geometry/reach';
import { drawWith, program } from './program';
import reachFragment from './reach.frag.glsl?raw';

/** Width of an isoline, CSS pixels. */
const LINE_CSS_PX = 1.2;

const RAMP = REACH_RAMP.flatMap(([red, green, blue, alpha]) => [red / 255, green / 255, blue / 255, alpha]);

export class ReachLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: twgl.ProgramInfo;
  #buffer: WebGLBuffer | undefined;

  /** @throws Error where the shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#program = program(gl, reachFragment, 'REACH');
  }

  get isSet(): boolean {
    return this.#buffer !== undefined;
  }

  /** One number per vertex of the mesh that is drawn next. */
  set(reach: Float32Array): void {
    this.clear();
    this.#buffer = twgl.createBufferFromTypedArray(this.#gl, reach);
  }

  clear(): void {
    if (this.#buffer) this.#gl.deleteBuffer(this.#buffer);
    this.#buffer = undefined;
  }

  /** @param pixelRatio Device pixels per CSS pixel. */
  draw(mesh: twgl.BufferInfo, uniforms: Record<string, unknown>, pixelRatio: number): void {
    if (!this.#buffer) return;
    const gl = this.#gl;
    const a_reach = { buffer: this.#buffer, numComponents: 1, type: gl.FLOAT };
    const own = { u_ramp: RAMP, u_line: LINE_CSS_PX * pixelRatio };
    drawWith(
      gl,
      this.#program,
      { ...mesh, attribs: { ...mesh.attribs, a_reach } },
      { ...uniforms, ...own },
      gl.TRIANGLES,
    );
    // An enabled attribute without its buffer makes draws of other programs fail.
    gl.disableVertexAttribArray(gl.getAttribLocation(this.#program.program, 'a_reach'));
  }
}
