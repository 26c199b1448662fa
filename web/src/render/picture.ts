/**
 * The picture as a texture: premultiplied, so that neither filtering nor blending mixes in the colours of transparent
 * pixels; with mipmaps; without anisotropy, so that every GPU filters alike.
 */
import * as twgl from 'twgl.js';
import type { View } from '../geometry/view';

/** Above this many device pixels per image pixel, image pixels are drawn as squares. */
const CRISP_ABOVE = 4;

/**
 * Uploads a premultiplied bitmap, shrunk where it exceeds the GPU's largest texture. Only the screen uses this texture,
 * never an export.
 */
export function createPictureTexture(gl: WebGL2RenderingContext, source: ImageBitmap): WebGLTexture {
  const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  const ratio = Math.min(1, most / source.width, most / source.height);
  return twgl.createTexture(gl, {
    src: ratio < 1 ? shrunk(source, ratio) : source,
    // A bitmap is uploaded as it is, premultiplied; of a canvas this must be requested.
    premultiplyAlpha: ratio < 1 ? 1 : 0,
    internalFormat: gl.RGBA8,
    min: gl.LINEAR_MIPMAP_LINEAR,
    mag: gl.LINEAR,
    wrap: gl.CLAMP_TO_EDGE,
    auto: true,
  });
}

/** Sets the magnification filter for a view. */
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
  if (!context) throw new Error('this browser has no 2D canvas to shrink a picture with');
  context.imageSmoothingQuality = 'high';
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}
