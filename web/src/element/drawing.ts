/** Redraws at most once a frame, after a change of the pose or the view. */
import type { Pose } from '../compute/posed_picture';
import type { SolutionData } from '../compute/solution';
import { blendOf } from '../document/bending';
import type { HeatMap } from '../geometry/heat';
import type { View } from '../geometry/view';
import { Renderer } from '../render/renderer';

export interface DrawingHost {
  view(): View;
  /** Null draws the picture at rest. */
  pose(): Pose | null;
  heat(): HeatMap | null;
  /** It is seen again, after the handles have moved out of sight. */
  came(): void;
}

/** Margin around the viewport within which a canvas is drawn, so that it is before it is visible. */
const AROUND = '25%';

export class Drawing {
  readonly #host: DrawingHost;
  readonly #renderer: Renderer;
  readonly #watching: IntersectionObserver;
  #frame = 0;
  #posed = true;
  /** Whether the canvas is in or near the viewport; unknown, it counts as seen. */
  #seen = true;

  /** @throws Error with the code `webgl` if WebGL2 is not available. */
  constructor(canvas: HTMLCanvasElement, host: DrawingHost) {
    this.#host = host;
    this.#renderer = new Renderer(canvas);
    this.#renderer.onrestore = () => this.pose();
    const tell = (entries: readonly IntersectionObserverEntry[]) => {
      this.#seen = entries.at(-1)?.isIntersecting ?? false;
      if (this.#seen) this.#renderer.wake();
      else this.#renderer.sleep();
      if (!this.#seen || this.#posed) return;
      this.look();
      host.came();
    };
    this.#watching = new IntersectionObserver(tell, { rootMargin: AROUND });
    this.#watching.observe(canvas);
  }

  setPicture(bitmap: ImageBitmap | null): void {
    this.#renderer.setPicture(bitmap);
    this.look();
  }

  setSolution(data: SolutionData | null): void {
    this.#renderer.setSolution(data);
    this.pose();
    this.look();
  }

  get seen(): boolean {
    return this.#seen;
  }

  /** The handles have moved. Out of sight this waits, so that an animation there costs nothing. */
  pose(): void {
    this.#posed = false;
    if (this.#seen) this.look();
  }

  /** The view has changed. */
  look(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = -1;
    this.#watching.disconnect();
    this.#renderer.dispose();
  }

  #show(pose: Pose | null): void {
    if (pose) this.#renderer.setMotions(pose.motions, blendOf(pose.project), pose.triangles);
    else this.#renderer.setMotions(null);
  }

  #draw(): void {
    this.#frame = 0;
    if (!this.#posed) this.#show(this.#host.pose());
    this.#posed = true;
    this.#renderer.setHeat(this.#host.heat());
    this.#renderer.draw(this.#host.view());
  }
}
