/**
 * The exact bytes of a picture in straight alpha. A 2D canvas would premultiply and round them, and lose the colours
 * under transparent pixels; a WebGL texture keeps them.
 */
import { PictureError } from './picture_error';

/** A picture in straight alpha, rows from the top. */
export interface Rgba {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

const TILE = 2048;

/** How long the context waits for the next picture. Making one for each would slow down pages of many pictures. */
const KEPT_MS = 1000;

let context: WebGL2RenderingContext | null = null;
let letGo: ReturnType<typeof setTimeout> | undefined;

/**
 * @param picture Decoded without premultiplying, of this width and height.
 * @returns RGBA, rows from the top.
 * @throws PictureError where the browser has no WebGL2 to read it with, or loses the context meanwhile.
 */
export function straightPixels(
  picture: ImageBitmap | HTMLImageElement,
  width: number,
  height: number,
): Uint8Array<ArrayBuffer> {
  context = ready(context) ?? created();
  const gl = context;
  clearTimeout(letGo);
  letGo = setTimeout(() => gl.getExtension('WEBGL_lose_context')?.loseContext(), KEPT_MS);
  const pixels = new Uint8Array(width * height * 4);
  gl.pixelStorei(gl.PACK_ROW_LENGTH, width);
  // In tiles, since a picture may be larger than the largest texture.
  for (let y = 0; y < height; y += TILE) {
    for (let x = 0; x < width; x += TILE) {
      readTile(gl, picture, pixels, [x, y, Math.min(TILE, width - x), Math.min(TILE, height - y)]);
    }
  }
  // A lost context reads as zeros.
  if (gl.isContextLost()) {
    throw new PictureError('The browser has lost its graphics while it read the picture: open it once more.');
  }
  return pixels;
}

const ready = (gl: WebGL2RenderingContext | null) => (gl?.isContextLost() ? null : gl);

function created(): WebGL2RenderingContext {
  // Not an OffscreenCanvas: WebKitGTK and older Safaris give those no WebGL.
  const gl = document.createElement('canvas').getContext('webgl2', { antialias: false, depth: false });
  if (!gl) throw new PictureError('This browser has no WebGL2 to read a picture with.');
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  return gl;
}

function readTile(
  gl: WebGL2RenderingContext,
  picture: ImageBitmap | HTMLImageElement,
  pixels: Uint8Array,
  [x, y, width, height]: [number, number, number, number],
): void {
  gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, x);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, y);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  const texture: WebGLTexture = gl.getParameter(gl.TEXTURE_BINDING_2D);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.pixelStorei(gl.PACK_SKIP_PIXELS, x);
  gl.pixelStorei(gl.PACK_SKIP_ROWS, y);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
}
