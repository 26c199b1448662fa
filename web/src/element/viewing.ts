/**
 * Where the person looks. Until they look elsewhere the whole picture stays in view, whatever the size of the stage: its own rectangle,
 * which is what is exported, and whatever has been bent beyond it.
 */
import { type Box, boxOfBoth } from '../geometry/box';
import { type Camera, fitted, type Insets, panned, type Size, scaledAt, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';

/** Room for the cards over the stage, by its size; the layout's breakpoints are the same. */
function insetsOf({ width, height }: Size): Insets {
  if (width >= 640 && height < 290)
    return { top: 16, right: 248, bottom: 16, left: height < 208 ? 182 : 134 };
  if (width >= 900) return { top: 28, right: 260, bottom: 28, left: 84 };
  if (width >= 640) return { top: 20, right: 248, bottom: 20, left: 72 };
  return { top: 16, right: 16, bottom: 136, left: 16 };
}

const beyond = (at: number, least: number, most: number): number => at - Math.max(least, Math.min(at, most));

/** One notch of the zoom buttons. */
const NOTCH = Math.SQRT2;

export class Viewing {
  /** Where the posed picture lies, image pixels; null where nobody knows yet. */
  readonly #bounds: () => Box | null;
  camera: Camera = { scale: 1, x: 0, y: 0 };
  stage: Size = { width: 1, height: 1 };
  /** The size of the stage that the camera is made for. */
  #settled: Size = this.stage;
  #picture: Size | null = null;
  #fitted = true;

  constructor(bounds: () => Box | null) {
    this.#bounds = bounds;
  }

  show(picture: Size | null): void {
    this.#picture = picture;
    this.fit();
  }

  /**
   * A stage that is not shown has no size, and the view stays as it was.
   *
   * @param typing a keyboard on the glass takes some of the height and gives it back: nothing moves for that.
   */
  resize(stage: Size, typing = false): void {
    if (!(stage.width > 0 && stage.height > 0)) return;
    const keyboard = typing && stage.width === this.stage.width;
    this.stage = stage;
    if (keyboard) return;
    const by: Vec = [(stage.width - this.#settled.width) / 2, (stage.height - this.#settled.height) / 2];
    this.#settled = stage;
    if (this.#fitted) this.fit();
    else this.camera = panned(this.camera, by);
  }

  look(camera: Camera): void {
    this.camera = camera;
    this.#fitted = false;
  }

  fit(): void {
    this.#fitted = true;
    if (!this.#picture) return;
    const { width, height } = this.#picture;
    const frame: Box = { min: [0, 0], max: [width, height] };
    const posed = this.#bounds();
    this.camera = fitted(posed ? boxOfBoth(frame, posed) : frame, this.stage, insetsOf(this.stage));
  }

  /** The same, unless the person looks elsewhere. */
  refit(): void {
    if (this.#fitted) this.fit();
  }

  /** One image pixel on one pixel of the stage. */
  actual(): void {
    this.look(scaledAt(this.camera, 1, this.middle));
  }

  zoom(notches: number): void {
    this.look(scaledAt(this.camera, this.camera.scale * NOTCH ** notches, this.middle));
  }

  /** Brings a place of the picture into what the cards leave free, by the shortest way. */
  reveal(at: Vec): void {
    const [x, y] = this.#outside(at);
    if (x !== 0 || y !== 0) this.look(panned(this.camera, [-x, -y]));
  }

  /** Whether a place of the picture is where no card lies, with as much room to the right of it, stage pixels. */
  shows(at: Vec, room = 0): boolean {
    return this.#outside(at, room).every((by) => Math.abs(by) < 1);
  }

  /** How far a place lies outside of what the cards leave free, stage pixels. */
  #outside(at: Vec, room = 0): Vec {
    const { top, right, bottom, left } = insetsOf(this.stage);
    const [x, y] = toStage(this.camera, at);
    return [beyond(x, left, this.stage.width - right - room), beyond(y, top, this.stage.height - bottom)];
  }

  /** The middle of what the cards leave free, stage pixels. */
  get middle(): Vec {
    const { top, right, bottom, left } = insetsOf(this.stage);
    return [(left + this.stage.width - right) / 2, (top + this.stage.height - bottom) / 2];
  }
}
