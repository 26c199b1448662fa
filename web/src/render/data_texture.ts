/**
 * Float textures that the vertex shader reads as arrays.
 *
 * Texel i lies at (i mod width, i / width).
 */
import { createNearestTexture } from './target';

const WIDTH = 2048;

export interface DataTexture {
  readonly texture: WebGLTexture;
  /** Replaces the first texels; `data` must fit the texture. */
  update(data: Float32Array): void;
  dispose(): void;
}

/**
 * @param channels Numbers per texel: 2 or 4.
 * @param texels The least number of texels.
 */
export function createDataTexture(gl: WebGL2RenderingContext, channels: 2 | 4, texels: number): DataTexture {
  const height = Math.max(1, Math.ceil(texels / WIDTH));
  const [internalFormat, format] = channels === 2 ? [gl.RG32F, gl.RG] : [gl.RGBA32F, gl.RGBA];
  const padded = new Float32Array(WIDTH * height * channels);
  const texture = createNearestTexture(gl);
  gl.texImage2D(gl.TEXTURE_2D, 0, internalFormat, WIDTH, height, 0, format, gl.FLOAT, padded);
  return {
    texture,
    update(data) {
      const rows = Math.ceil(data.length / channels / WIDTH);
      padded.set(data);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, WIDTH, rows, format, gl.FLOAT, padded);
    },
    dispose: () => gl.deleteTexture(texture),
  };
}
