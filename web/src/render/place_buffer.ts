/** The attribute `a_place` of a mesh: where its vertices lie before they are posed. */
import type { Attribute } from './buffers';

export class PlaceBuffer {
  /** All of the mesh. */
  readonly attributes: Record<string, Attribute>;
  readonly #gl: WebGL2RenderingContext;
  readonly #rest: Attribute;
  /** Created once vertices are displaced. */
  #buffer: WebGLBuffer | undefined;

  /**
   * Vertices lie where they rest until places are set.
   * @param rest The attribute `a_rest`.
   */
  constructor(gl: WebGL2RenderingContext, rest: Attribute, others: Readonly<Record<string, Attribute>>) {
    this.#gl = gl;
    this.#rest = rest;
    this.attributes = { ...others, a_rest: rest, a_place: rest };
  }

  /** @param places vertices × 2; null where they rest. */
  set(places: Float32Array | null): void {
    this.attributes.a_place = places ? { ...this.#rest, buffer: this.#filled(places) } : this.#rest;
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
