/**
 * Draws the warped picture on a canvas with WebGL2.
 *
 * Takes flat arrays, and knows neither handles nor solver. Keeps its inputs, to fill a context again that was lost and
 * restored.
 */
import type { Blend } from '../geometry/blend';
import { MOTION_STRIDE } from '../geometry/skin';
import type { View } from '../geometry/view';
import { unwarpedMesh, type WarpMesh } from './mesh';
import { Scene } from './scene';

export class Renderer {
  readonly #canvas: HTMLCanvasElement;
  readonly #gl: WebGL2RenderingContext;
  readonly #lending: WEBGL_lose_context | null;
  readonly #listening = new AbortController();
  #asleep = false;
  /** Who holds the context. Only the browser's can be restored: once `webglcontextlost` has been handled. */
  #context: 'ours' | 'given back' | "the browser's" = 'ours';
  #scene: Scene | undefined;
  #picture: ImageBitmap | null = null;
  #mesh: WarpMesh | null = null;
  #motions: Float32Array | null = null;
  #reach: Float32Array | null = null;
  #blend: Blend = 'linear';

  /** Called when a lost context is restored and the picture must be drawn again. */
  onrestore: (() => void) | null = null;

  /** @throws Error with the code `webgl` where the browser has no WebGL2. */
  constructor(canvas: HTMLCanvasElement) {
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: true, depth: false, stencil: false });
    if (!gl) {
      const message =
        'This browser cannot draw by WebGL2: switch hardware acceleration on, or use another browser.';
      throw Object.assign(new Error(message), { code: 'webgl' });
    }
    this.#canvas = canvas;
    this.#gl = gl;
    // Requested now, as a lost context has no extensions.
    this.#lending = gl.getExtension('WEBGL_lose_context');
    const { signal } = this.#listening;
    canvas.addEventListener('webglcontextlost', (event) => this.#lose(event), { signal });
    canvas.addEventListener('webglcontextrestored', () => this.#restore(), { signal });
    if (!gl.isContextLost()) this.#scene = new Scene(gl);
  }

  /** Whether the context is lost; drawing does nothing until it is restored. */
  get lost(): boolean {
    return this.#scene === undefined || this.#gl.isContextLost();
  }

  /** Shows another picture, unwarped, or none. The bitmap must be premultiplied, and open while it is shown. */
  setPicture(source: ImageBitmap | null): void {
    this.#picture = source;
    this.#mesh = null;
    this.#motions = null;
    this.#reach = null;
    if (!source) this.#scene?.clear();
    this.#fill();
  }

  /** The mesh to draw the picture on, at rest until motions are set; null for the unwarped picture. */
  setSolution(mesh: WarpMesh | null): void {
    this.#mesh = mesh;
    this.#motions = null;
    this.#reach = null;
    this.#fillMesh();
  }

  /**
   * Sites × 12, see {@link MOTION_STRIDE}, and how they are blended; null draws the mesh at rest.
   * @throws RangeError unless there is one motion per site of the mesh.
   */
  setMotions(motions: Float32Array | null, blend: Blend = 'linear'): void {
    const sites = (this.#mesh?.siteRest.length ?? 0) / 2;
    if (motions && motions.length !== sites * MOTION_STRIDE) {
      throw new RangeError(`${motions.length / MOTION_STRIDE} motions for ${sites} sites`);
    }
    this.#motions = motions;
    this.#blend = blend;
    if (!this.lost) this.#scene?.setMotions(motions, blend);
  }

  /**
   * One number from 0 to 1 per vertex of the mesh, drawn as a heat map over the picture; null for the picture alone.
   * @throws RangeError unless there is one number per vertex.
   */
  setReach(reach: Float32Array | null): void {
    if (reach === this.#reach) return;
    const vertices = (this.#mesh?.positions.length ?? 0) / 2;
    if (reach && reach.length !== vertices) {
      throw new RangeError(`a reach of ${reach.length} vertices for ${vertices}`);
    }
    this.#reach = reach;
    if (!this.lost) this.#scene?.setReach(reach);
  }

  draw(view: View): void {
    if (this.lost) return;
    // Assigning a size clears the canvas, even if the size stays the same.
    if (this.#canvas.width !== view.width) this.#canvas.width = view.width;
    if (this.#canvas.height !== view.height) this.#canvas.height = view.height;
    this.#scene?.draw(view);
  }

  /** Draws, and returns the pixels: premultiplied RGBA, rows from the top. */
  readPixels(view: View): Uint8Array {
    this.draw(view);
    const { width, height } = view;
    const pixels = new Uint8Array(width * height * 4);
    this.#gl.readPixels(0, 0, width, height, this.#gl.RGBA, this.#gl.UNSIGNED_BYTE, pixels);
    return flipped(pixels, width * 4);
  }

  /** Releases the context until `wake`. The canvas is empty meanwhile; picture, mesh and motions are kept. */
  sleep(): void {
    this.#asleep = true;
    if (this.lost) return;
    this.#context = 'given back';
    this.#lending?.loseContext();
  }

  wake(): void {
    this.#asleep = false;
    if (this.#context !== "the browser's") return;
    this.#context = 'ours';
    this.#lending?.restoreContext();
  }

  /** Releases the context for good: the canvas cannot be drawn on again. */
  dispose(): void {
    this.#listening.abort();
    this.sleep();
    this.#scene = undefined;
  }

  #lose(event: Event): void {
    // Without this the browser never restores the context.
    event.preventDefault();
    this.#scene = undefined;
    if (this.#context === 'given back') setTimeout(() => this.#giveBack());
  }

  /** The browser has the context now; `wake` may have been called meanwhile. */
  #giveBack(): void {
    this.#context = "the browser's";
    if (!this.#asleep) this.wake();
  }

  #restore(): void {
    this.#scene = new Scene(this.#gl);
    if (this.#asleep) {
      this.sleep();
      return;
    }
    this.#fill();
    this.#scene.setMotions(this.#motions, this.#blend);
    this.#scene.setReach(this.#reach);
    this.onrestore?.();
  }

  #fill(): void {
    if (this.lost || !this.#picture) return;
    this.#scene?.setPicture(this.#picture);
    this.#fillMesh();
  }

  #fillMesh(): void {
    if (this.lost || !this.#picture) return;
    this.#scene?.setMesh(this.#mesh ?? unwarpedMesh(this.#picture.width, this.#picture.height));
  }
}

function flipped(pixels: Uint8Array, stride: number): Uint8Array {
  const result = new Uint8Array(pixels.length);
  for (let from = 0, to = pixels.length - stride; to >= 0; from += stride, to -= stride) {
    result.set(pixels.subarray(from, from + stride), to);
  }
  return result;
}
