/**
 * The picture as a texture with mipmaps.
 *
 * The texture is premultiplied: filtering and blending then ignore the colours of transparent pixels. Anisotropic
 * filtering is off, so that all GPUs give the same result.
 */
import * as twgl from 'twgl.js';
import type { View } from '../geometry/view';

/** Above this many device pixels per image pixel, image pixels are drawn as squares. */
const CRISP_ABOVE = 4;

/**
 * Uploads a premultiplied bitmap, and shrinks it if it exceeds the GPU's largest texture. The texture serves the screen
 * only; exports use the original pixels.
 */
export function createPictureTexture(gl: WebGL2RenderingContext, source: ImageBitmap): WebGLTexture {
  const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  const ratio = Math.min(1, most / source.width, most / source.height);
  return twgl.createTexture(gl, {
    src: ratio < 1 ? shrunk(source, ratio) : source,
    // A bitmap is premultiplied already. WebGL must be told to premultiply a canvas.
    premultiplyAlpha: ratio < 1 ? 1 : 0,
    internalFormat: gl.RGBA8,
    min: gl.LINEAR_MIPMAP_LINEAR,
    mag: gl.LINEAR,
    wrap: gl.CLAMP_TO_EDGE,
    auto: true,
  });
}

/** Sets the magnification filter for a view: squares at high zoom and for pixel art, else linear. */
export function setMagnification(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  { scale, pixelated = false }: View,
): void {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  const crisp = pixelated || scale > CRISP_ABOVE;
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, crisp ? gl.NEAREST : gl.LINEAR);
}

function shrunk(source: ImageBitmap, ratio: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.floor(source.width * ratio));
  canvas.height = Math.max(1, Math.floor(source.height * ratio));
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser cannot shrink a picture on a 2D canvas.');
  context.imageSmoothingQuality = 'high';
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}
