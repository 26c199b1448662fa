/**
 * Draws the feather of a selection: a rim of the picture around the mesh that fades out.
 *
 * It moves with vertices of the mesh, by the weights and motions of that. It is drawn before the mesh, so that it never
 * covers it.
 */
import * as twgl from 'twgl.js';
import { ownedRows, type WarpMesh, weightRows } from './mesh';
import pictureFragment from './picture.frag.glsl?raw';
import { PlaceBuffer } from './place_buffer';
import { drawWith, program } from './program';

export class RimLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: twgl.ProgramInfo;
  readonly #buffers: twgl.BufferInfo;
  readonly places: PlaceBuffer;

  /** Returns `undefined` for a mesh without a feather. @throws Error if the shader does not compile. */
  static of(gl: WebGL2RenderingContext, mesh: WarpMesh): RimLayer | undefined {
    const { featherPositions, featherOwners, featherLevels, featherTriangles } = mesh;
    if (!featherPositions || !featherOwners || !featherLevels || !featherTriangles?.length) return undefined;
    return new RimLayer(gl, {
      a_rest: { numComponents: 2, data: featherPositions },
      a_row: { numComponents: 2, data: ownedRows(weightRows(mesh.offsets), featherOwners) },
      a_level: { numComponents: 1, data: featherLevels },
      indices: { numComponents: 3, data: featherTriangles },
    });
  }

  private constructor(gl: WebGL2RenderingContext, arrays: twgl.Arrays) {
    this.#gl = gl;
    this.#program = program(gl, pictureFragment, 'RIM');
    this.#buffers = twgl.createBufferInfoFromArrays(gl, arrays);
    this.places = new PlaceBuffer(gl, this.#buffers);
  }

  /** @param uniforms those of the mesh. */
  draw(uniforms: Record<string, unknown>): void {
    const gl = this.#gl;
    drawWith(gl, this.#program, this.#buffers, uniforms, gl.TRIANGLES);
    // An enabled attribute without a buffer makes the draw calls of other programs fail.
    gl.disableVertexAttribArray(gl.getAttribLocation(this.#program.program, 'a_level'));
  }

  dispose(): void {
    this.places.dispose();
    const { indices, attribs } = this.#buffers;
    const buffers = [indices, ...Object.values(attribs ?? {}).map(({ buffer }) => buffer)];
    for (const buffer of buffers) this.#gl.deleteBuffer(buffer ?? null);
  }
}
