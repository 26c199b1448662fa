/**
 * Draws the state on the canvas, at most once a frame, and only what has changed.
 *
 * Out of sight nothing is posed or drawn, so that an animation there costs nothing.
 */
import type { Pose } from '../compute/posed_picture';
import type { SolutionData } from '../compute/solution';
import { blendOf } from '../document/bending';
import type { HeatMap } from '../geometry/heat';
import type { View } from '../geometry/view';
import type { TexturePatch, TextureSource } from '../render/picture';
import { Renderer } from '../render/renderer';

/** Everything that a frame shows. Unchanged parts are the same objects as in the last frame. */
export interface Frame {
  readonly picture: TextureSource | null;
  /** The part of the picture that is filled behind the solution, if it is there. */
  readonly fill: TexturePatch | null;
  readonly solution: SolutionData | null;
  /** Null draws the picture at rest. */
  readonly pose: Pose | null;
  readonly heat: HeatMap | null;
  readonly view: View;
}

export interface FramesListener {
  /** The frame of the present state. */
  frame(): Frame;
  /** The canvas is in sight again. */
  seen(): void;
  /** The graphics context is lost, or can be drawn on again. */
  lost(): void;
  restored(): void;
  failed(error: unknown): void;
}

/** Margin around the viewport within which the canvas is drawn, so that it is ready when it comes into sight. */
const MARGIN = '25%';

export class Frames {
  readonly #listener: FramesListener;
  readonly #renderer: Renderer;
  readonly #observer: IntersectionObserver;
  #request = 0;
  #seen = true;
  #last: Frame | null = null;

  /** @throws Error with the code `webgl` if WebGL2 is not available. */
  constructor(canvas: HTMLCanvasElement, listener: FramesListener) {
    this.#listener = listener;
    this.#renderer = new Renderer(canvas);
    this.#renderer.onlose = () => listener.lost();
    this.#renderer.onrestore = () => this.#restored();
    if (this.#renderer.lost) listener.lost();
    this.#observer = new IntersectionObserver((entries) => this.#observed(entries), { rootMargin: MARGIN });
    this.#observer.observe(canvas);
  }

  /** Whether the canvas is in or near the viewport. */
  get seen(): boolean {
    return this.#seen;
  }

  /** Something may have changed: draws with the next frame. */
  request(): void {
    if (this.#request === 0 && this.#seen) this.#request = requestAnimationFrame(() => this.#draw());
  }

  /** Draws at once: a frame of the screen has begun, and its marks are rendered with it. */
  drawNow(): void {
    if (!this.#seen) return;
    cancelAnimationFrame(this.#request);
    this.#draw();
  }

  /** Draws again although nothing has changed. */
  redraw(): void {
    this.#last = this.#last && { ...this.#last, view: { ...this.#last.view, width: 0 } };
    this.request();
  }

  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#request = -1;
    this.#observer.disconnect();
    this.#renderer.dispose();
  }

  #observed(entries: readonly IntersectionObserverEntry[]): void {
    const seen = entries.at(-1)?.isIntersecting ?? false;
    const returns = seen && !this.#seen;
    this.#seen = seen;
    if (seen) this.#renderer.wake();
    else this.#renderer.sleep();
    if (!returns) return;
    this.redraw();
    this.#listener.seen();
  }

  #restored(): void {
    this.#listener.restored();
    this.redraw();
  }

  #draw(): void {
    this.#request = 0;
    const frame = this.#listener.frame();
    try {
      const changed = this.#update(frame);
      if (this.#renderer.load() || changed) this.#renderer.draw(frame.view);
    } catch (error) {
      this.#listener.failed(error);
    }
    this.#last = frame;
    if (this.#renderer.isLoading) this.request();
  }

  /** Passes what has changed to the renderer. Returns whether anything has. */
  #update({ picture, fill, solution, pose, heat, view }: Frame): boolean {
    const last = this.#last;
    const pictured = picture !== (last?.picture ?? null);
    const solved = pictured || solution !== (last?.solution ?? null);
    const filled = pictured || fill !== (last?.fill ?? null);
    const posed = solved || pose !== (last?.pose ?? null);
    const heated = solved || heat?.values !== last?.heat?.values || heat?.lines !== last?.heat?.lines;
    if (pictured) this.#renderer.setPicture(picture);
    if (filled) this.#renderer.setFill(fill);
    if (solved) this.#renderer.setSolution(solution);
    if (posed) this.#show(pose);
    if (heated) this.#renderer.setHeat(heat);
    return filled || posed || heated || !isSameView(view, last?.view);
  }

  #show(pose: Pose | null): void {
    if (pose) {
      const { motions, project, triangles } = pose;
      this.#renderer.setMotions(motions, blendOf(project), triangles, project.edges ? pose.crossed() : null);
    } else this.#renderer.setMotions(null);
  }
}

const isSameView = (a: View, b: View | undefined): boolean =>
  b !== undefined && JSON.stringify(a) === JSON.stringify(b);
