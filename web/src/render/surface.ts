/**
 * The surfaces that renderers draw on.
 *
 * Browsers allow 16 WebGL contexts per page, 8 on phones, and drop the oldest one for a new one, visible or not. So the
 * first canvases of a page have a context each, and all others share one. A shared surface copies each frame to its own
 * canvas, which costs time but has no limit.
 */
import { errorsIn } from '../error';
import type { Size } from '../geometry/camera';
import { en } from '../texts/en';
import { say } from '../texts/wording';

const surfaceError = errorsIn<'errors'>(en);

export interface Surface {
  /** Draws on the surface's own canvas, or on one that all shared surfaces use. */
  readonly gl: WebGL2RenderingContext;
  readonly shared: boolean;
  /** Shows the frame on the surface's own canvas. Must be called in the same task as the draw calls. */
  show(): void;
  release(): void;
}

/** Few, because the page may have its own contexts. */
const MAX_OWN = 4;

let own = 0;
let common: WebGL2RenderingContext | undefined;

/** @throws C2WarpError with the code `webgl` if the browser has no WebGL2. */
export function surfaceOf(canvas: HTMLCanvasElement): Surface {
  return own < MAX_OWN ? ownSurface(canvas) : sharedSurface(canvas);
}

/** Sets the size of a canvas in device pixels. */
export function resize(canvas: HTMLCanvasElement | OffscreenCanvas, { width, height }: Size): void {
  // An assignment clears the canvas, even with the same size.
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

function ownSurface(canvas: HTMLCanvasElement): Surface {
  const gl = contextOf(canvas);
  // Requested now, since a lost context has no extensions.
  const losing = gl.getExtension('WEBGL_lose_context');
  own++;
  return {
    gl,
    shared: false,
    show() {},
    release() {
      own--;
      losing?.loseContext();
    },
  };
}

function sharedSurface(canvas: HTMLCanvasElement): Surface {
  common ??= contextOf(document.createElement('canvas'));
  const gl = common;
  const context = canvas.getContext('2d');
  if (!context) throw surfaceError('failed', say('errors.noCanvas'));
  return {
    gl,
    shared: true,
    show() {
      resize(canvas, gl.canvas);
      context.globalCompositeOperation = 'copy';
      context.drawImage(gl.canvas, 0, 0);
    },
    release() {},
  };
}

function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const gl = canvas.getContext('webgl2', { antialias: true, alpha: true, depth: false, stencil: false });
  if (gl) return gl;
  throw surfaceError('webgl', say('errors.noWebgl'));
}
