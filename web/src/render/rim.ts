/**
 * Draws the feather of a selection: a rim of the picture around the mesh that fades out.
 *
 * It moves with vertices of the mesh, by the weights and motions of that. It is drawn before the mesh, so that it never
 * covers it.
 */
import { type Buffers, createAttribute, createIndices, deleteBuffers, type Indices } from './buffers';
import { ownedRows, type WarpMesh, weightRows } from './mesh';
import pictureFragment from './picture.frag.glsl?raw';
import { PlaceBuffer } from './place_buffer';
import { drawWith, type Program, program } from './program';
import type { Uniforms } from './uniforms';

export class RimLayer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: Program;
  readonly #buffers: Buffers;
  readonly places: PlaceBuffer;

  /** Returns `undefined` for a mesh without a feather. @throws Error if the shader does not compile. */
  static of(gl: WebGL2RenderingContext, mesh: WarpMesh): RimLayer | undefined {
    const { featherPositions, featherOwners, featherLevels, featherTriangles } = mesh;
    if (!featherPositions || !featherOwners || !featherLevels || !featherTriangles?.length) return undefined;
    const places = new PlaceBuffer(gl, createAttribute(gl, 2, featherPositions), {
      a_row: createAttribute(gl, 2, ownedRows(weightRows(mesh.offsets), featherOwners)),
      a_level: createAttribute(gl, 1, featherLevels),
    });
    return new RimLayer(gl, places, createIndices(gl, featherTriangles));
  }

  private constructor(gl: WebGL2RenderingContext, places: PlaceBuffer, indices: Indices) {
    this.#gl = gl;
    this.#program = program(gl, pictureFragment, 'RIM');
    this.places = places;
    this.#buffers = { attributes: places.attributes, indices };
  }

  /** @param uniforms those of the mesh. */
  draw(uniforms: Uniforms): void {
    const gl = this.#gl;
    drawWith(gl, this.#program, this.#buffers, uniforms, gl.TRIANGLES);
    // An enabled attribute without a buffer makes the draw calls of other programs fail.
    gl.disableVertexAttribArray(gl.getAttribLocation(this.#program.program, 'a_level'));
  }

  dispose(): void {
    this.places.dispose();
    deleteBuffers(this.#gl, this.#buffers);
  }
}
