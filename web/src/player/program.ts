/** Shader programs and textures, without a library. */

export interface Program {
  use(): void;
  /** The location of a uniform; null if the shader does not use it. */
  at(uniform: string): WebGLUniformLocation | null;
}

/** @throws Error with the compiler's message if a shader does not compile. */
export function programOf(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type) as WebGLShader;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    // It lives on with its program.
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(`A shader does not compile: ${gl.getProgramInfoLog(program)}`);
  const known = new Map<string, WebGLUniformLocation | null>();
  return {
    use: () => gl.useProgram(program),
    at(uniform) {
      const at = known.get(uniform) ?? gl.getUniformLocation(program, uniform);
      known.set(uniform, at);
      return at;
    },
  };
}

/** A texture without mipmaps, whose texels are read one by one. It is bound. */
export function tableOf(gl: WebGL2RenderingContext): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
    gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
  return texture;
}

/** Texels in a row of an array. */
const WIDTH = 1024;

/** Numbers as whole rows of texels. */
export function padded(length: number, channels: number): Float32Array {
  return new Float32Array(Math.max(1, Math.ceil(length / channels / WIDTH)) * WIDTH * channels);
}

/** Fills the bound texture with padded numbers: texel i lies at (i mod width, i / width). */
export function fill(gl: WebGL2RenderingContext, data: Float32Array, channels: 2 | 4): void {
  const [internal, format] = channels === 2 ? [gl.RG32F, gl.RG] : [gl.RGBA32F, gl.RGBA];
  const height = data.length / channels / WIDTH;
  gl.texImage2D(gl.TEXTURE_2D, 0, internal, WIDTH, height, 0, format, gl.FLOAT, data);
}
