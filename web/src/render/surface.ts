/**
 * What renderers draw on. Browsers allow a page 16 WebGL contexts, on phones 8, and take the oldest away for a new one,
 * visible or not. Here the first canvases of a page have one each. All others are drawn one after another in one that
 * they share, and keep a copy of what was drawn for them: a copy for each frame, but no limit.
 */
import type { Size } from '../geometry/camera';

export interface Surface {
  /** Its canvas is that of the surface, or belongs to all that share it. */
  readonly gl: WebGL2RenderingContext;
  readonly shared: boolean;
  /** Shows what was drawn, on the surface's own canvas. To be called in the task of the drawing. */
  show(): void;
  release(): void;
}

/** Few, as the page may have contexts of its own. */
const MOST_OWN = 4;

let own = 0;
let common: WebGL2RenderingContext | undefined;

/** @throws Error with the code `webgl` where the browser has no WebGL2. */
export function surfaceOf(canvas: HTMLCanvasElement): Surface {
  return own < MOST_OWN ? ownSurface(canvas) : sharedSurface(canvas);
}

/** Gives a canvas a size in device pixels. */
export function resize(canvas: HTMLCanvasElement | OffscreenCanvas, { width, height }: Size): void {
  // Assigning a size clears the canvas, even if the size stays the same.
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

function ownSurface(canvas: HTMLCanvasElement): Surface {
  const gl = contextOf(canvas);
  // Requested now, as a lost context has no extensions.
  const lending = gl.getExtension('WEBGL_lose_context');
  own++;
  return {
    gl,
    shared: false,
    show() {},
    release() {
      own--;
      lending?.loseContext();
    },
  };
}

function sharedSurface(canvas: HTMLCanvasElement): Surface {
  common ??= contextOf(document.createElement('canvas'));
  const gl = common;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('this browser has no 2D canvas to show a picture on');
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
  const message =
    'This browser cannot draw by WebGL2: switch hardware acceleration on, or use another browser.';
  throw Object.assign(new Error(message), { code: 'webgl' });
}
