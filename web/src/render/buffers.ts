/** The vertices and the indices of meshes, on the graphics card. */

/** Numbers of each vertex. */
export interface Attribute {
  readonly buffer: WebGLBuffer;
  /** Numbers a vertex. */
  readonly channels: number;
  /** Whole numbers, or fractions. */
  readonly isWhole: boolean;
}

export interface Buffers {
  /** By their names in shaders. */
  readonly attributes: Readonly<Record<string, Attribute>>;
  readonly indices: Indices;
}

export interface Indices {
  readonly buffer: WebGLBuffer;
  readonly count: number;
}

/** Uploads numbers of vertices: fractions as floats, whole numbers as unsigned integers. */
export const createAttribute = (
  gl: WebGL2RenderingContext,
  channels: number,
  data: Float32Array | Uint32Array,
): Attribute => ({
  buffer: filled(gl, gl.ARRAY_BUFFER, data),
  channels,
  isWhole: data instanceof Uint32Array,
});

/** Uploads indices. A later order of the same length may replace them. */
export const createIndices = (gl: WebGL2RenderingContext, data: Uint32Array): Indices => ({
  buffer: filled(gl, gl.ELEMENT_ARRAY_BUFFER, data),
  count: data.length,
});

function filled(gl: WebGL2RenderingContext, target: number, data: Float32Array | Uint32Array): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(target, buffer);
  gl.bufferData(target, data, gl.STATIC_DRAW);
  return buffer;
}

/** Makes the buffers the source of the next draw call of a program, whose attributes have these locations. */
export function bindBuffers(
  gl: WebGL2RenderingContext,
  locations: ReadonlyMap<string, number>,
  { attributes, indices }: Buffers,
): void {
  for (const [name, location] of locations) {
    const attribute = attributes[name];
    if (!attribute) continue;
    const { buffer, channels, isWhole } = attribute;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    if (isWhole) gl.vertexAttribIPointer(location, channels, gl.UNSIGNED_INT, 0, 0);
    else gl.vertexAttribPointer(location, channels, gl.FLOAT, false, 0, 0);
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices.buffer);
}

export function deleteBuffers(gl: WebGL2RenderingContext, { attributes, indices }: Buffers): void {
  for (const { buffer } of Object.values(attributes)) gl.deleteBuffer(buffer);
  gl.deleteBuffer(indices.buffer);
}
