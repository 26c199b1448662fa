/** A texture that is drawn into, and read texel by texel. */

/** How texels are stored: internal format, format and type. */
export type TexelFormat = readonly [internal: number, format: number, type: number];

export class Target {
  readonly texture: WebGLTexture;
  readonly #gl: WebGL2RenderingContext;
  readonly #format: TexelFormat;
  readonly #framebuffer: WebGLFramebuffer;
  #width = 0;
  #height = 0;

  constructor(gl: WebGL2RenderingContext, format: TexelFormat) {
    this.#gl = gl;
    this.#format = format;
    this.texture = createNearestTexture(gl);
    this.#framebuffer = gl.createFramebuffer();
    this.resize(1, 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Another size loses the content. */
  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    const gl = this.#gl;
    const [internal, format, type] = this.#format;
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
    [this.#width, this.#height] = [width, height];
  }

  /** Makes it the target of the next draw calls. */
  bind(): void {
    this.#gl.bindFramebuffer(this.#gl.FRAMEBUFFER, this.#framebuffer);
  }

  dispose(): void {
    this.#gl.deleteFramebuffer(this.#framebuffer);
    this.#gl.deleteTexture(this.texture);
  }
}

/** A texture without mipmaps, whose texels are read one by one. It is bound. */
export function createNearestTexture(gl: WebGL2RenderingContext): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
    gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
  return texture;
}
