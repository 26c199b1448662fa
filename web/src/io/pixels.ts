/**
 * Reads the exact bytes of a picture in straight alpha, through a WebGL texture. A 2D canvas would premultiply and
 * round, and lose the colours of transparent pixels.
 */
import { say } from '../texts/wording';
import { pictureError } from './picture_error';

/** A picture in straight alpha, rows from the top. */
export interface Rgba {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

const TILE = 2048;

/** How long an idle context is kept. A new context per picture would slow down pages with many pictures. */
const KEEP_CONTEXT_MS = 1000;

/** An image that WebGL can read. Workers have no image elements, which are part of it in a page. */
export type DecodedImage = Extract<TexImageSource, ImageBitmapSource>;

/** Creates a WebGL2 context; null if the browser has none. */
export type CreateContext = () => WebGL2RenderingContext | null;

let context: WebGL2RenderingContext | null = null;
let releaseTimer: ReturnType<typeof setTimeout> | undefined;

/**
 * Returns the pixels of a picture: RGBA in straight alpha, rows from the top.
 *
 * @param picture Decoded without premultiplying, `width` × `height` pixels.
 * @throws C2WarpError if the browser has no WebGL2, or loses the context meanwhile.
 */
export function straightPixels(
  picture: DecodedImage,
  width: number,
  height: number,
  createContext: CreateContext,
): Uint8Array<ArrayBuffer> {
  const gl = pixelContext(createContext);
  const pixels = new Uint8Array(width * height * 4);
  gl.pixelStorei(gl.PACK_ROW_LENGTH, width);
  // Read in tiles, since a picture can be larger than the largest texture.
  for (let y = 0; y < height; y += TILE) {
    for (let x = 0; x < width; x += TILE) {
      readTile(gl, picture, pixels, [x, y, Math.min(TILE, width - x), Math.min(TILE, height - y)]);
    }
  }
  // A lost context reads as zeros.
  if (gl.isContextLost()) {
    throw pictureError('picture', say('errors.picture.contextLost'));
  }
  return pixels;
}

/** The longest side of a texture. */
export function largestTexture(createContext: CreateContext): number {
  const gl = pixelContext(createContext);
  return gl.getParameter(gl.MAX_TEXTURE_SIZE);
}

/** Returns a context that is kept for a moment after its last use. */
function pixelContext(createContext: CreateContext): WebGL2RenderingContext {
  const gl = context && !context.isContextLost() ? context : prepared(createContext());
  context = gl;
  clearTimeout(releaseTimer);
  releaseTimer = setTimeout(() => gl.getExtension('WEBGL_lose_context')?.loseContext(), KEEP_CONTEXT_MS);
  return gl;
}

function prepared(gl: WebGL2RenderingContext | null): WebGL2RenderingContext {
  if (!gl) throw pictureError('picture', say('errors.picture.noWebgl'));
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  return gl;
}

function readTile(
  gl: WebGL2RenderingContext,
  picture: DecodedImage,
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
