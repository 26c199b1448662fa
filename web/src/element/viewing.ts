/**
 * The view of the picture. Until the person pans or zooms, the whole picture stays fitted to the stage: its own
 * rectangle, which is exported, and whatever is bent beyond that.
 */
import { type Box, boxOfBoth, reachesBeyond } from '../geometry/box';
import {
  type Camera,
  fitted,
  type Insets,
  panned,
  type Size,
  scaledAt,
  toImage,
  toStage,
} from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { type Cards, insetsOf } from './insets';

const beyond = (at: number, least: number, most: number): number => at - Math.max(least, Math.min(at, most));

/** Image pixels that rounding alone may move a pose beyond its picture. */
const SLACK = 0.5;

/** Zoom factor of one step of the zoom buttons. */
const NOTCH = Math.SQRT2;

/** A view of a picture, to be restored later. */
export interface Look {
  readonly camera: Camera;
  /** The stage size that the camera belongs to. */
  readonly stage: Size;
  /** The whole picture is kept in view. */
  readonly fitted: boolean;
  /** The fit leaves room for the sheet. */
  readonly beside: boolean;
}

export interface ViewingHost extends Omit<Cards, 'stage'> {
  /** Bounding box of the posed picture, image pixels; null if not known yet. */
  bounds(): Box | null;
}

export class Viewing {
  readonly #host: ViewingHost;
  stage: Size = { width: 1, height: 1 };
  #picture: Size | null = null;
  #now: Look = { camera: { scale: 1, x: 0, y: 0 }, stage: this.stage, fitted: true, beside: false };
  /** Whether `contain` has shrunk the picture to show parts bent beyond its rectangle. */
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

  /** @param look an earlier view to restore; without it the whole picture is fitted. */
  show(picture: Size | null, look?: Look): void {
    this.#picture = picture;
    if (look) {
      this.#now = look;
      this.resize(this.stage);
    } else this.fit();
  }

  /**
   * Ignores a hidden stage, which has no size.
   *
   * @param typing an on-screen keyboard may change the height: the picture does not move for that.
   * @param pressing nor does it move under a press.
   */
  resize(stage: Size, { typing = false, pressing = false } = {}): void {
    if (!(stage.width > 0 && stage.height > 0)) return;
    const keyboard = typing && stage.width === this.stage.width;
    this.stage = stage;
    if (keyboard || pressing) return;
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

  /** Fits again unless the person has panned or zoomed. A sheet opened meanwhile does not move the picture. */
  refit(): void {
    if (this.#now.fitted) this.fit(this.#now.beside);
  }

  /** Zooms to 100 %: one image pixel for one CSS pixel. */
  actual(): void {
    this.look(scaledAt(this.camera, 1, this.middle));
  }

  zoom(notches: number): void {
    this.look(scaledAt(this.camera, this.camera.scale * NOTCH ** notches, this.middle));
  }

  /** Pans by the shortest way until no card covers a point of the picture. */
  reveal(at: Vec): void {
    const [x, y] = this.#outside(at);
    if (x !== 0 || y !== 0) this.look(panned(this.camera, [-x, -y]));
  }

  /**
   * For a bare picture, which nobody can pan or zoom: fits the whole posed picture once one of these points is out of
   * view, and restores its size once no part is bent beyond the frame.
   */
  contain(places: readonly Vec[]): void {
    if (!this.#widened && places.every((at) => this.shows(at))) return;
    this.fit();
    const posed = this.#host.bounds();
    this.#widened = posed !== null && reachesBeyond(posed, this.#frame, SLACK);
  }

  /** Whether no card covers a point of the picture, nor `room` to its right, CSS pixels. */
  shows(at: Vec, room = 0): boolean {
    return this.#outside(at, room).every((by) => Math.abs(by) < 1);
  }

  /** The area free of cards, image pixels. */
  get free(): Box {
    const { top, right, bottom, left } = this.#insets();
    const { width, height } = this.stage;
    return {
      min: toImage(this.camera, [left, top]),
      max: toImage(this.camera, [width - right, height - bottom]),
    };
  }

  /** How far a point lies outside the area free of cards, CSS pixels. */
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

  /** The middle of the area free of cards, CSS pixels. */
  get middle(): Vec {
    const { top, right, bottom, left } = this.#insets();
    return [(left + this.stage.width - right) / 2, (top + this.stage.height - bottom) / 2];
  }
}
