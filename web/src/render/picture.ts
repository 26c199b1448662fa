/**
 * The picture as a texture: premultiplied, so that neither filter nor blending mixes in colours from under transparent
 * pixels, with mipmaps, and without anisotropy, so that every machine and the CPU filter alike.
 */
import * as twgl from 'twgl.js';

/** Above this many device pixels per image pixel, the pixels of the picture show as squares. */
const CRISP_ABOVE = 4;

/**
 * Uploads a premultiplied bitmap. One larger than the graphics card takes is shown smaller: only on screen, an export
 * never comes from here.
 */
export function createPictureTexture(gl: WebGL2RenderingContext, source: ImageBitmap): WebGLTexture {
  const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  const ratio = Math.min(1, most / source.width, most / source.height);
  return twgl.createTexture(gl, {
    src: ratio < 1 ? shrunk(source, ratio) : source,
    // Bitmaps are uploaded as they are, premultiplied; a canvas has to be asked.
    premultiplyAlpha: ratio < 1 ? 1 : 0,
    internalFormat: gl.RGBA8,
    min: gl.LINEAR_MIPMAP_LINEAR,
    mag: gl.LINEAR,
    wrap: gl.CLAMP_TO_EDGE,
    auto: true,
  });
}

/** Chooses how a magnified picture looks. */
export function setMagnification(gl: WebGL2RenderingContext, texture: WebGLTexture, scale: number): void {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, scale > CRISP_ABOVE ? gl.NEAREST : gl.LINEAR);
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
