/**
 * Reads the exact bytes of a picture in straight alpha, through a WebGL texture. A 2D canvas would premultiply and
 * round, and lose the colours of transparent pixels.
 */
import { WarpError } from '../error';

/** A picture in straight alpha, rows from the top. */
export interface Rgba {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

const NO_WEBGL =
  'This browser cannot read pictures with WebGL2. Switch on hardware acceleration or use another browser.';

const TILE = 2048;

/** How long an idle context is kept. A new context per picture would slow down pages with many pictures. */
const KEEP_CONTEXT_MS = 1000;

let context: WebGL2RenderingContext | null = null;
let releaseTimer: ReturnType<typeof setTimeout> | undefined;

/**
 * Returns the pixels of a picture: RGBA in straight alpha, rows from the top.
 *
 * @param picture Decoded without premultiplying, `width` × `height` pixels.
 * @throws WarpError if the browser has no WebGL2, or loses the context meanwhile.
 */
export function straightPixels(
  picture: ImageBitmap | HTMLImageElement,
  width: number,
  height: number,
): Uint8Array<ArrayBuffer> {
  context = usable(context) ?? createContext();
  const gl = context;
  clearTimeout(releaseTimer);
  releaseTimer = setTimeout(() => gl.getExtension('WEBGL_lose_context')?.loseContext(), KEEP_CONTEXT_MS);
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
    throw new WarpError(
      'picture',
      'The graphics context was lost while the picture was read. Open the picture again.',
    );
  }
  return pixels;
}

const usable = (gl: WebGL2RenderingContext | null) => (gl?.isContextLost() ? null : gl);

function createContext(): WebGL2RenderingContext {
  // An OffscreenCanvas has no WebGL in WebKitGTK and older Safaris.
  const gl = document.createElement('canvas').getContext('webgl2', { antialias: false, depth: false });
  if (!gl) throw new WarpError('picture', NO_WEBGL);
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
