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

/** A view of a picture that can be come back to. */
export interface Look {
  readonly camera: Camera;
  /** The size of the stage that the camera is made for. */
  readonly stage: Size;
  /** The whole picture is in view, and stays so. */
  readonly fitted: boolean;
  /** It is beside the sheet. */
  readonly beside: boolean;
}

export interface ViewingHost extends Omit<Cards, 'stage'> {
  /** Where the posed picture lies, image pixels; null where nobody knows yet. */
  bounds(): Box | null;
}

export class Viewing {
  readonly #host: ViewingHost;
  stage: Size = { width: 1, height: 1 };
  #picture: Size | null = null;
  #now: Look = { camera: { scale: 1, x: 0, y: 0 }, stage: this.stage, fitted: true, beside: false };
  /** What has been bent beyond its rectangle made a bare picture smaller. */
  #widened = false;

  constructor(host: ViewingHost) {
    this.#host = host;
  }

  get now(): Look {
    return this.#now;
  }

  get camera(): Camera {
    return this.#now.camera;
  }

  /** @param look as it was looked at before; left out: the whole of it. */
  show(picture: Size | null, look?: Look): void {
    this.#picture = picture;
    if (look) {
      this.#now = look;
      this.resize(this.stage);
    } else this.fit();
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
    const { camera, stage: before } = this.#now;
    const by: Vec = [(stage.width - before.width) / 2, (stage.height - before.height) / 2];
    this.#now = { ...this.#now, stage, camera: panned(camera, by) };
    this.refit();
  }

  look(camera: Camera): void {
    this.#now = { ...this.#now, camera, fitted: false };
  }

  /** @param sheet whether to leave room for the panel as a sheet. */
  fit(sheet = this.#host.sheet): void {
    this.#now = { ...this.#now, fitted: true, beside: sheet };
    if (!this.#picture) return;
    const posed = this.#host.bounds();
    const all = posed ? boxOfBoth(this.#frame, posed) : this.#frame;
    this.#now = { ...this.#now, camera: fitted(all, this.stage, this.#insets(sheet)) };
  }

  /** The same once more, unless the person looks elsewhere. What is selected meanwhile moves nothing. */
  refit(): void {
    if (this.#now.fitted) this.fit(this.#now.beside);
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
