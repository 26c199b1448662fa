/** The crosshair, which arrow keys move over the picture: Enter places a handle or a corner there. */
import { toImage, toStage } from '../geometry/camera';
import { add, scaled, type Vec } from '../geometry/vec';
import type { Viewing } from './viewing';

/** CSS pixels that an arrow key moves it for each pixel that it would nudge. */
const STEP = 4;

export class Crosshair {
  readonly #viewing: Viewing;
  /** Image pixels; null until an arrow key has moved it. */
  at: Vec | null = null;

  constructor(viewing: Viewing) {
    this.#viewing = viewing;
  }

  /** Where Enter places, image pixels. */
  get place(): Vec {
    const { camera, middle } = this.#viewing;
    return this.at ?? toImage(camera, middle);
  }

  /**
   * Moves it, at most to the edge of the stage. Returns where it is then, image pixels.
   * @param start where it starts unless it is shown already; without it in the middle of the view.
   */
  move(by: Vec, start: Vec | undefined): Vec {
    const step = STEP / this.#viewing.camera.scale;
    this.at = this.#inView(add(this.at ?? start ?? this.place, scaled(by, step)));
    return this.at;
  }

  /** The nearest point within the stage, image pixels. */
  #inView(at: Vec): Vec {
    const { camera, stage } = this.#viewing;
    const [x, y] = toStage(camera, at);
    const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
    return toImage(camera, [within(x, stage.width), within(y, stage.height)]);
  }
}
