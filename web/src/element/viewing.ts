/**
 * Where the person looks. Until they look elsewhere the whole picture stays in view, whatever the size of the stage: its own rectangle,
 * which is what is exported, and whatever has been bent beyond it.
 */
import { type Box, boxOfBoth, reachesBeyond } from '../geometry/box';
import { type Camera, fitted, type Insets, panned, type Size, scaledAt, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { type Cards, insetsOf } from './insets';

const beyond = (at: number, least: number, most: number): number => at - Math.max(least, Math.min(at, most));

/** Image pixels that rounding takes a pose beyond its picture. */
const SLACK = 0.5;

/** One notch of the zoom buttons. */
const NOTCH = Math.SQRT2;

export interface ViewingHost extends Omit<Cards, 'stage'> {
  /** Where the posed picture lies, image pixels; null where nobody knows yet. */
  bounds(): Box | null;
}

export class Viewing {
  readonly #host: ViewingHost;
  camera: Camera = { scale: 1, x: 0, y: 0 };
  stage: Size = { width: 1, height: 1 };
  /** The size of the stage that the camera is made for. */
  #settled: Size = this.stage;
  #picture: Size | null = null;
  #fitted = true;
  /** It is beside the sheet. */
  #beside = false;
  /** What has been bent beyond its rectangle made a bare picture smaller. */
  #widened = false;

  constructor(host: ViewingHost) {
    this.#host = host;
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
    if (this.#fitted) this.refit();
    else this.camera = panned(this.camera, by);
  }

  look(camera: Camera): void {
    this.camera = camera;
    this.#fitted = false;
  }

  /** @param sheet whether to leave room for the panel as a sheet. */
  fit(sheet = this.#host.sheet): void {
    this.#fitted = true;
    this.#beside = sheet;
    if (!this.#picture) return;
    const posed = this.#host.bounds();
    const all = posed ? boxOfBoth(this.#frame, posed) : this.#frame;
    this.camera = fitted(all, this.stage, this.#insets(sheet));
  }

  /** The same once more, unless the person looks elsewhere. What is selected meanwhile moves nothing. */
  refit(): void {
    if (this.#fitted) this.fit(this.#beside);
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

  /**
   * Nobody can pan or zoom a bare picture: all of it comes into view as soon as one of these places is out of reach, and goes back to its
   * size with the pose that took it there.
   */
  contain(places: readonly Vec[]): void {
    if (!this.#widened && places.every((at) => this.shows(at))) return;
    this.fit();
    const posed = this.#host.bounds();
    this.#widened = posed !== null && reachesBeyond(posed, this.#frame, SLACK);
  }

  /** Whether a place of the picture is where no card lies, with as much room to the right of it, stage pixels. */
  shows(at: Vec, room = 0): boolean {
    return this.#outside(at, room).every((by) => Math.abs(by) < 1);
  }

  /** How far a place lies outside of what the cards leave free, stage pixels. */
  #outside(at: Vec, room = 0): Vec {
    const { top, right, bottom, left } = this.#insets();
    const [x, y] = toStage(this.camera, at);
    return [beyond(x, left, this.stage.width - right - room), beyond(y, top, this.stage.height - bottom)];
  }

  get #frame(): Box {
    return { min: [0, 0], max: [this.#picture?.width ?? 0, this.#picture?.height ?? 0] };
  }

  #insets(sheet = this.#host.sheet): Insets {
    const { coarse, bare } = this.#host;
    return insetsOf({ stage: this.stage, coarse, sheet, bare });
  }

  /** The middle of what the cards leave free, stage pixels. */
  get middle(): Vec {
    const { top, right, bottom, left } = this.#insets();
    return [(left + this.stage.width - right) / 2, (top + this.stage.height - bottom) / 2];
  }
}
