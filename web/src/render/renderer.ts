/**
 * Draws the warped picture on a canvas with WebGL2.
 *
 * The renderer takes flat arrays and knows neither handles nor solver. It keeps its inputs, to fill the context again
 * after a context loss.
 */
import type { Box } from '../geometry/box';
import type { HeatMap } from '../geometry/heat';
import { type Blend, MOTION_STRIDE, type Places } from '../geometry/skin';
import type { View } from '../geometry/view';
import { unwarpedMesh, type WarpMesh } from './mesh';
import { Painter } from './painter';
import type { TexturePatch, TextureSource } from './picture';
import { resize, type Surface, surfaceOf } from './surface';

export class Renderer {
  readonly #surface: Surface;
  readonly #listening = new AbortController();
  #asleep = false;
  #painter: Painter | undefined;
  #picture: TextureSource | null = null;
  #patch: TexturePatch | null = null;
  #mesh: WarpMesh | null = null;
  #motions: Float32Array | null = null;
  #places: Places | null = null;
  #heat: HeatMap | null = null;
  #blend: Blend = 'linear';
  #triangles: Uint32Array | null = null;
  #crossed: Box | null = null;

  /** Called when the context is lost: until `onrestore`, drawing does nothing. */
  onlose: (() => void) | null = null;
  /** Called when the picture must be drawn again: the context was restored, or `wake` was called. */
  onrestore: (() => void) | null = null;

  /** @throws C2WarpError with the code `webgl` if the browser has no WebGL2. */
  constructor(canvas: HTMLCanvasElement) {
    this.#surface = surfaceOf(canvas);
    const { gl } = this.#surface;
    const { signal } = this.#listening;
    gl.canvas.addEventListener('webglcontextlost', (event) => this.#lose(event), { signal });
    gl.canvas.addEventListener('webglcontextrestored', () => this.#restore(), { signal });
    // The browser dropped the copy that was drawn in a shared context.
    canvas.addEventListener('contextrestored', () => this.onrestore?.(), { signal });
    if (!gl.isContextLost()) this.#painter = new Painter(gl);
  }

  /** Whether the context is lost or released. Drawing does nothing until `onrestore`. */
  get lost(): boolean {
    return this.#painter === undefined || this.#surface.gl.isContextLost();
  }

  /** Shows another picture unwarped; null shows no picture. The bitmaps must stay open while shown. */
  setPicture(source: TextureSource | null): void {
    this.#picture = source;
    this.#patch = null;
    this.#mesh = null;
    this.#motions = null;
    this.#places = null;
    this.#heat = null;
    if (!source) this.#painter?.clear();
    this.#fill();
  }

  /** Fills a part of the picture behind the mesh; null fills nothing. The bitmap must stay open while shown. */
  setFill(patch: TexturePatch | null): void {
    this.#patch = patch;
    if (!this.lost && this.#picture) this.#painter?.setFill(this.#picture, patch);
  }

  /** Sets the mesh that carries the picture, at rest until motions are set; null shows the unwarped picture. */
  setSolution(mesh: WarpMesh | null): void {
    this.#mesh = mesh;
    this.#motions = null;
    this.#places = null;
    this.#triangles = null;
    this.#crossed = null;
    this.#heat = null;
    this.#fillMesh();
  }

  /**
   * Sets the motions, sites × 12, and their blend; null draws the mesh at rest. See {@link MOTION_STRIDE}.
   *
   * @param triangles The mesh's triangles in the drawing order of the pose; null keeps the order of the mesh.
   * @param crossed The box around all crossings, whose edges are drawn; null for no edges.
   * @throws RangeError unless there is one motion per site of the mesh.
   */
  setMotions(
    motions: Float32Array | null,
    blend: Blend = 'linear',
    triangles: Uint32Array | null = null,
    crossed: Box | null = null,
  ): void {
    const sites = (this.#mesh?.siteRest.length ?? 0) / 2;
    if (motions && motions.length !== sites * MOTION_STRIDE) {
      throw new RangeError(
        `Expected ${sites} motions, one per site, found ${motions.length / MOTION_STRIDE}.`,
      );
    }
    this.#motions = motions;
    this.#blend = blend;
    this.#triangles = triangles;
    this.#crossed = crossed;
    if (!this.lost) this.#painter?.setMotions(motions, blend, triangles, crossed);
  }

  /**
   * Sets where the mesh lies before it is posed; null where it rests.
   *
   * @throws RangeError unless there is one place per vertex.
   */
  setPlaces(places: Places | null): void {
    if (places === this.#places) return;
    const numbers = this.#mesh?.positions.length ?? 0;
    if (places && places.mesh.length !== numbers)
      throw new RangeError(
        `Expected ${numbers / 2} places, one per vertex, found ${places.mesh.length / 2}.`,
      );
    this.#places = places;
    if (!this.lost) this.#painter?.setPlaces(places);
  }

  /**
   * Draws a heat map of the mesh over the picture; null draws only the picture.
   *
   * @throws RangeError unless there is one number per vertex.
   */
  setHeat(heat: HeatMap | null): void {
    if (heat?.values === this.#heat?.values) return;
    const vertices = (this.#mesh?.positions.length ?? 0) / 2;
    if (heat && heat.values.length !== vertices) {
      throw new RangeError(`Expected ${vertices} heat values, one per vertex, found ${heat.values.length}.`);
    }
    this.#heat = heat;
    if (!this.lost) this.#painter?.setHeat(heat);
  }

  /** Whether parts of a large picture still have to be uploaded. */
  get isLoading(): boolean {
    return !this.lost && this.#painter?.isLoading === true;
  }

  /** Uploads the next part of a large picture. Returns whether that was the last one: draw again. */
  load(): boolean {
    return this.isLoading && this.#painter?.load() === true;
  }

  draw(view: View): void {
    if (this.lost) return;
    resize(this.#surface.gl.canvas, view);
    this.#painter?.draw(view);
    this.#surface.show();
  }

  /** Draws, then returns the pixels: premultiplied RGBA, rows from the top. */
  readPixels(view: View): Uint8Array {
    this.draw(view);
    const { width, height } = view;
    const { gl } = this.#surface;
    const pixels = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return flipped(pixels, width * 4);
  }

  /** Frees the graphics memory of a shared context until `wake`. The canvas keeps its last frame. */
  sleep(): void {
    if (!this.#surface.shared) return;
    this.#asleep = true;
    this.#painter?.clear();
    this.#painter = undefined;
  }

  wake(): void {
    if (!this.#asleep) return;
    this.#asleep = false;
    this.#restore();
  }

  /** Releases all resources. The canvas cannot be drawn on again. */
  dispose(): void {
    this.#listening.abort();
    this.#painter?.clear();
    this.#painter = undefined;
    this.#surface.release();
  }

  #lose(event: Event): void {
    // The browser restores the context only after this call.
    event.preventDefault();
    this.#painter = undefined;
    this.onlose?.();
  }

  #restore(): void {
    const { gl } = this.#surface;
    if (this.#asleep || gl.isContextLost()) return;
    this.#painter = new Painter(gl);
    this.#fill();
    this.#painter.setPlaces(this.#places);
    this.#painter.setMotions(this.#motions, this.#blend, this.#triangles, this.#crossed);
    this.#painter.setHeat(this.#heat);
    this.onrestore?.();
  }

  #fill(): void {
    if (this.lost || !this.#picture) return;
    this.#painter?.setPicture(this.#picture);
    this.#painter?.setFill(this.#picture, this.#patch);
    this.#fillMesh();
  }

  #fillMesh(): void {
    if (this.lost || !this.#picture) return;
    this.#painter?.setMesh(this.#mesh ?? unwarpedMesh(this.#picture.width, this.#picture.height));
  }
}

function flipped(pixels: Uint8Array, stride: number): Uint8Array {
  const result = new Uint8Array(pixels.length);
  for (let from = 0, to = pixels.length - stride; to >= 0; from += stride, to -= stride) {
    result.set(pixels.subarray(from, from + stride), to);
  }
  return result;
}
