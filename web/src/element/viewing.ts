/** Where the person looks. Until they look elsewhere the whole picture stays in view, whatever the size of the stage. */
import { type Camera, fitted, type Insets, panned, type Size, scaledAt } from '../geometry/camera';
import type { Vec } from '../geometry/vec';

/** Room for the cards over the stage, by its width; the layout's breakpoints are the same. */
function insetsOf({ width }: Size): Insets {
  if (width >= 900) return { top: 28, right: 260, bottom: 28, left: 84 };
  if (width >= 640) return { top: 20, right: 248, bottom: 20, left: 72 };
  return { top: 16, right: 16, bottom: 84, left: 16 };
}

/** One notch of the zoom buttons. */
const NOTCH = Math.SQRT2;

export class Viewing {
  camera: Camera = { scale: 1, x: 0, y: 0 };
  stage: Size = { width: 1, height: 1 };
  #picture: Size | null = null;
  #fitted = true;

  show(picture: Size | null): void {
    this.#picture = picture;
    this.fit();
  }

  resize(stage: Size): void {
    const by: Vec = [(stage.width - this.stage.width) / 2, (stage.height - this.stage.height) / 2];
    this.stage = stage;
    if (this.#fitted) this.fit();
    else this.camera = panned(this.camera, by);
  }

  look(camera: Camera): void {
    this.camera = camera;
    this.#fitted = false;
  }

  fit(): void {
    this.#fitted = true;
    if (this.#picture) this.camera = fitted(this.#picture, this.stage, insetsOf(this.stage));
  }

  /** One image pixel on one pixel of the stage. */
  actual(): void {
    this.look(scaledAt(this.camera, 1, this.middle));
  }

  zoom(notches: number): void {
    this.look(scaledAt(this.camera, this.camera.scale * NOTCH ** notches, this.middle));
  }

  /** The middle of what the cards leave free, stage pixels. */
  get middle(): Vec {
    const { top, right, bottom, left } = insetsOf(this.stage);
    return [(left + this.stage.width - right) / 2, (top + this.stage.height - bottom) / 2];
  }
}
