/** The attribute `a_place` of a mesh: where its vertices lie before they are posed. */
import type * as twgl from 'twgl.js';

export class PlaceBuffer {
  readonly #gl: WebGL2RenderingContext;
  readonly #attribs: NonNullable<twgl.BufferInfo['attribs']>;
  /** Created once vertices are displaced. */
  #buffer: WebGLBuffer | undefined;

  /** Vertices lie where they rest, `a_rest`, until places are set. */
  constructor(gl: WebGL2RenderingContext, { attribs }: twgl.BufferInfo) {
    this.#gl = gl;
    this.#attribs = attribs ?? {};
    this.set(null);
  }

  /** @param places vertices × 2; null where they rest. */
  set(places: Float32Array | null): void {
    const rest = this.#attribs.a_rest;
    if (!rest) return;
    this.#attribs.a_place = places ? { ...rest, buffer: this.#filled(places) } : rest;
  }

  #filled(places: Float32Array): WebGLBuffer {
    const gl = this.#gl;
    const isNew = this.#buffer === undefined;
    this.#buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    if (isNew) gl.bufferData(gl.ARRAY_BUFFER, places, gl.DYNAMIC_DRAW);
    else gl.bufferSubData(gl.ARRAY_BUFFER, 0, places);
    return this.#buffer;
  }

  dispose(): void {
    this.#gl.deleteBuffer(this.#buffer ?? null);
  }
}
