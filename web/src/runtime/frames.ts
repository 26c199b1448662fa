/**
 * Draws the state on the canvas, at most once a frame, and only the changed parts.
 *
 * Out of sight nothing is posed or drawn, so that an animation there costs nothing.
 */
import type { SolutionData } from '../compute/solution';
import { blendOf } from '../document/bending';
import type { HeatMap } from '../geometry/heat';
import type { View } from '../geometry/view';
import type { TexturePatch, TextureSource } from '../render/picture';
import { Renderer } from '../render/renderer';
import type { DrawnPose } from './glide';

/** Everything that a frame shows. Unchanged parts are the same objects as in the last frame. */
export interface Frame {
  readonly picture: TextureSource | null;
  /** The filled part of the picture behind the solution, if it exists. */
  readonly fill: TexturePatch | null;
  readonly solution: SolutionData | null;
  /** Null draws the picture at rest. */
  readonly pose: DrawnPose | null;
  readonly heat: HeatMap | null;
  /** A drag or a clip changes the pose from frame to frame. */
  readonly moves: boolean;
  /** The pose changes by itself: the next frame is another one. */
  readonly glides: boolean;
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

/**
 * What moved rests once it is unchanged for so long, or when a drag or a clip ends. Under a finger the wait is longer:
 * full detail in each short pause would let the picture flicker.
 */
const REST_MS = 200;
const HELD_REST_MS = 600;

export class Frames {
  readonly #listener: FramesListener;
  readonly #renderer: Renderer;
  readonly #observer: IntersectionObserver;
  #request = 0;
  #seen = true;
  #last: Frame | null = null;
  /** The last drawing was one of something that moves. */
  #moving = false;
  #resting: ReturnType<typeof setTimeout> | undefined;

  /** @throws C2WarpError with the code `webgl` if WebGL2 is not available. */
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
    clearTimeout(this.#resting);
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
      const moved = this.#isMoved(frame);
      const changed = this.#update(frame);
      const ended = this.#last?.moves === true && !frame.moves;
      const rests = this.#moving && (ended || this.#resting === undefined);
      if (this.#renderer.load() || changed || rests) this.#show(frame, changed && moved);
    } catch (error) {
      this.#listener.failed(error);
    }
    this.#last = frame;
    if (this.#renderer.isLoading || frame.glides) this.request();
  }

  /** Draws, and draws again in full detail after a motion has ended. */
  #show({ moves, view }: Frame, moving: boolean): void {
    clearTimeout(this.#resting);
    this.#moving = moving;
    this.#resting = moving ? setTimeout(() => this.#rest(), moves ? HELD_REST_MS : REST_MS) : undefined;
    this.#renderer.draw(moving ? { ...view, moving } : view);
  }

  #rest(): void {
    this.#resting = undefined;
    this.request();
  }

  /** Whether a changed frame is one of many: of a drag, a clip, a pan or a zoom. */
  #isMoved({ picture, solution, moves, view }: Frame): boolean {
    const last = this.#last;
    if (picture !== last?.picture || solution !== last?.solution) return false;
    return moves || isMovedView(view, last.view);
  }

  /** Passes the changes to the renderer. Returns whether there were any. */
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
    if (posed) this.#setPose(pose);
    if (heated) this.#renderer.setHeat(heat);
    return filled || posed || heated || !isSameView(view, last?.view);
  }

  #setPose(pose: DrawnPose | null): void {
    if (pose) {
      const { motions, places, project, triangles } = pose;
      this.#renderer.setPlaces(places);
      this.#renderer.setMotions(motions, blendOf(project), triangles, project.edges ? pose.crossed() : null);
    } else {
      this.#renderer.setPlaces(null);
      this.#renderer.setMotions(null);
    }
  }
}

/** Panned or zoomed. A canvas of another size is another layout. */
const isMovedView = (a: View, b: View): boolean =>
  a.width === b.width && a.height === b.height && (a.scale !== b.scale || a.x !== b.x || a.y !== b.y);

const isSameView = (a: View, b: View | undefined): boolean =>
  b !== undefined && JSON.stringify(a) === JSON.stringify(b);
